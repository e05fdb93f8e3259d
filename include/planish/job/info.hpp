#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/geometry/frame.hpp>
#include <planish/io/flat_writers.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planish {
struct StepFile;
}

namespace planish::job {

/// A request to `planish info`.
struct InfoRequest {
  std::filesystem::path input;  ///< "-" reads standard input
  std::string body;             ///< number (1-based) or name; empty: all
  bool recognize = false;       ///< look for the sheet in each body
  LengthUnit units = LengthUnit::mm;
};

/// A planar face of a sheet's reference skin: what `--root` and `--up` can name.
struct FlangeFaceInfo {
  int number = 0;     ///< face number in the solid
  double area = 0.0;  ///< mm²
};

/// The sheet found in a body.
struct SheetInfo {
  double thickness = 0.0;
  int flanges = 0, bends = 0;
  std::vector<FlangeFaceInfo> faces;  ///< largest first
};

struct BodyInfo {
  int number = 0;
  std::string name;
  int quantity = 1, faces = 0;
  Vec3 size = Vec3::Zero();                ///< mm
  double volume = 0.0;                     ///< mm³
  std::string material, colour;            ///< as the file says; empty: it does not say
  std::optional<double> density;           ///< kg/dm³, likewise
  std::optional<Result<SheetInfo>> sheet;  ///< or why there is none; empty: nobody asked
};

/// What a STEP file holds. Lengths are mm; `units` is for the reports.
struct InfoReport {
  std::string input;
  std::string schema, cad_system, file_unit;
  std::vector<BodyInfo> bodies;
  int surface_bodies = 0;
  LengthUnit units = LengthUnit::mm;
};

/// Errors: those of `read_step`, and `no_such_body`.
Result<InfoReport> info(const InfoRequest& request, const Progress& progress = {});

/// The same for a file already read (`request.input` only names it).
Result<InfoReport> info_of(const StepFile& file, const InfoRequest& request,
                           const Progress& progress = {});

/// JSON text; `status` and `reason` as in a report (formats.md#report).
/// With the error of a request that failed, `report` has its input and units.
std::string info_json(const InfoReport& report, const std::optional<Error>& error = {});
/// Text for a terminal.
std::string info_text(const InfoReport& report);

}  // namespace planish::job
