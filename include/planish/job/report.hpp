#pragma once

#include <planish/base/result.hpp>
#include <planish/inspect/findings.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/sheet/certificate.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planish::job {

/// Beyond these a certificate is doubted (a warning with its place) or disbelieved (the pattern is
/// refused as `pattern_wrong`).
struct CertificateBounds {
  double volume_warning = 1e-3;  ///< |volume_ratio − 1|; models agree to far better, so it is a
                                 ///< feature
  double volume_refusal = 0.02;  ///< |explained_ratio − 1|: more than slanted cuts make
  double unmeasured_refusal = 0.08;  ///< |volume_ratio − 1| where features could not be measured
  double length_warning = 0.01;      ///< mm; what a laser cutter holds
  double length_refusal = 0.5;       ///< mm
  double refold_warning = 0.02;      ///< mm; twice that, as two borders meet in a corner
  double refold_refusal = 0.5;       ///< mm
};

/// How far a request is worked out. `draft`: the sheet and its flat pattern, to be seen while
/// something is dragged: no folded solid (so no volume), no certificate, no findings, curves to
/// 1e-3 mm.
enum class Effort { draft, full };

/// How a flat pattern is looked at, whatever sheet it comes from.
struct PatternChecks {
  Effort effort = Effort::full;
  Rules rules;
  bool write_overlapping = false;  ///< write the pattern although it covers itself
  CertificateBounds bounds;
  std::optional<double> density;  ///< kg/dm³; gives the mass
};

/// One request to make a sheet of what a file describes, as data.
struct MakeRequest : PatternChecks {
  std::filesystem::path input;             ///< "-" reads standard input
  std::optional<AllowanceRule> allowance;  ///< empty: the file's K-factor, or else the default
  std::optional<LengthUnit> units;         ///< of the report; empty: those of the file
};

struct SheetSummary {
  double thickness = 0.0, thickness_spread = 0.0, volume = 0.0;
  int flanges = 0, bends = 0;
  std::optional<double> k_factor;  ///< of all bends; of the rule without bends; empty where they
                                   ///< differ
  std::string k_source;            ///< likewise, "mixed" where they differ
};

enum class Status { ok, warning, refused };

/// What every command reports of a flat pattern. `refusal` set: there is no pattern; `sheet`
/// (thickness > 0) and `flat` (outer contour not empty) then hold what was known. Lengths are mm;
/// `units` is for the reports.
struct Report {
  std::string input;
  std::string body;  ///< name of the part: of the body in its file, or of the file that describes
                     ///< it
  std::optional<Error> refusal;
  SheetSummary sheet;
  Sheet laid;  ///< the sheet itself, whose faces and bends `flat` names; no faces where it was not
               ///< known
  FlatPattern flat;
  Layout layout;             ///< how the faces of `laid` lie in `flat`, before slits are cut
  Vec2 size = Vec2::Zero();  ///< smallest enclosing rectangle, longer side first, mm
  Certificate certificate;
  std::vector<Finding> findings;
  std::vector<std::string> notes;
  std::optional<double> mass;      ///< kg, when the density is known
  std::vector<std::string> files;  ///< written, as the one who wrote them names them
  LengthUnit units = LengthUnit::mm;
  double read_seconds = 0.0, unfold_seconds = 0.0;
  bool has_pattern() const { return !refusal; }
  bool has_warnings() const;
  Status status() const;
};

}  // namespace planish::job
