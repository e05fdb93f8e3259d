#pragma once

#include <planish/inspect/findings.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/sheet/layout.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
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

/// What a maker is asked, as data. `options()` has a row for each of these but `input`; a maker
/// looks at those that its own row names.
struct Request : PatternChecks {
  std::filesystem::path input;             ///< "-" reads standard input
  std::string body;                        ///< number (1-based) or name; empty: the only body
  std::optional<AllowanceRule> allowance;  ///< empty: that of the file, or else the default
  std::vector<std::pair<std::string, double>> bend_k;  ///< K of single bends, by their ids ("B1"),
                                                       ///< before `allowance`
  std::string root = "largest";                        ///< "largest" or a face number
  std::string up = "auto";  ///< "auto", "reference", "other", or the number of a face that shall
                            ///< face up
  ExtrudedHoles extruded = ExtrudedHoles::pilot;  ///< what is cut within formed features
  std::optional<LengthUnit> units;  ///< of the report and of the DXF; empty: those of the file
  int piece = 0;                    ///< of several pieces the one that is shown, from 0
  DxfOptions dxf;                   ///< its units are not looked at: they are those of the report
};

}  // namespace planish::job
