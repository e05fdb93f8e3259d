#pragma once

#include <planish/base/result.hpp>
#include <planish/brake/plan.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/request.hpp>
#include <planish/sheet/certificate.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planish::job {

struct SheetSummary {
  double thickness = 0.0, thickness_spread = 0.0, volume = 0.0;
  int flanges = 0, bends = 0;
  std::optional<double> k_factor;  ///< of all bends, or of the rule if there are none; empty if
                                   ///< they differ
  std::string k_source;            ///< likewise; "mixed" if they differ
};

enum class Status { ok, warning, refused };
/// "ok", "warning", "refused".
std::string_view status_name(Status status);

/// What every command reports about a flat pattern. A refused report, which an `Outcome` only shows
/// beside its error, has no pattern; `summary` (if its thickness > 0) and `flat` (if its outer
/// contour is not empty) then hold what was known. Lengths are mm; `units` is for the reports.
struct Report {
  std::string input;
  std::string body;  ///< name of the part: of the body in its file, or of its input file
  std::string material, colour;   ///< "S235", "#rrggbb" as its file says; empty: it does not say
  std::optional<double> density;  ///< kg/dm³, likewise
  std::optional<Error> refusal;   ///< empty in what an `Outcome` holds
  SheetSummary summary;
  Sheet sheet;  ///< the faces and bends that `flat` refers to; no faces if it was not known
  FlatPattern flat;
  Layout layout;              ///< how the faces of `sheet` lie in `flat`, before slits are cut
  std::vector<Loop> reliefs;  ///< outlines of what was cut out of `flat` beyond its faces
  Vec2 size = Vec2::Zero();   ///< smallest enclosing rectangle, longer side first, mm
  Certificate certificate;
  std::vector<Finding> findings;
  std::vector<std::string> notes;
  std::optional<double> mass;      ///< kg, when the density is known
  std::optional<Plan> plan;        ///< of the strokes that bend it, if that was asked for
  std::string_view task = {};      ///< that reports it, "bend"; empty: that of the maker
  std::vector<std::string> files;  ///< written, named as the writer names them
  LengthUnit units = LengthUnit::mm;
  double read_seconds = 0.0, unfold_seconds = 0.0;
  bool has_warnings() const;
  Status status() const;
};

}  // namespace planish::job
