#pragma once

#include <planish/brake/plan.hpp>
#include <planish/connect/plates.hpp>
#include <planish/inspect/findings.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/option_value.hpp>
#include <planish/sheet/layout.hpp>
#include <planish/shop/part_materials.hpp>
#include <planish/shop/shop.hpp>

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace planish::job {

/// Residuals above these give a warning with its place, or refuse the pattern (`pattern_wrong`).
struct CertificateBounds {
  double volume_warning = 1e-3;  ///< |volume_ratio − 1|; models agree far better, so a feature is
                                 ///< the cause
  double volume_refusal = 0.02;  ///< |explained_ratio − 1|: more than slanted cuts make
  double unmeasured_refusal = 0.08;  ///< |volume_ratio − 1| if features could not be measured
  double length_warning = 0.01;      ///< mm; what a laser cutter holds
  double length_refusal = 0.5;       ///< mm
  double refold_warning = 0.02;      ///< mm; twice that, since two borders meet in a corner
  double refold_refusal = 0.5;       ///< mm
  double opening_warning = 0.01;     ///< mm all round; of outlines too
  double opening_refusal = 0.05;     ///< mm all round; likewise: half of a kerf, which is seen
};

/// How much of a request is computed. `draft`: only the sheet and its flat pattern, for display
/// during a drag: no folded solid (so no volume), no certificate, no findings, curves to 1e-3 mm.
enum class Effort { draft, full };

/// Whether and how a plan is made for bending the part on a press brake.
struct Bending {
  /// A plan, or only a finding if there is none.
  enum class Ask { nothing, finding, plan };
  Ask ask = Ask::nothing;
  std::optional<BrakeTools> tools;      ///< empty: `default_tools`
  std::vector<std::string> begin_with;  ///< ids of bends that come first, in this order
  std::string metal;                    ///< the word given for it; empty: that of the defaults
  PlanOptions plan;                     ///< its `begin_with` is not used
  bool as_made = false;  ///< the pattern and the plan over it are those of the radii that are made
};

/// How a flat pattern is checked, whatever sheet it comes from.
struct PatternChecks {
  Effort effort = Effort::full;
  Rules rules;
  bool write_overlapping = false;  ///< write the pattern although it covers itself
  bool write_anyway = false;       ///< write it whatever error was found in it
  CertificateBounds bounds;
  std::optional<double> density;  ///< kg/dm³; gives the mass
  Bending bending;
  std::optional<shop::ShopChoice> shop;  ///< has a material once `OptionValues::enter` is done
};

/// How corners whose patterns overlap are mended, and slits are cut.
enum class Relief { none, rip, square, round };
struct ReliefOptions {
  Relief shape = Relief::rip;
  double width = 0.0;  ///< of rips along slits, mm; 0: each slit is one line, cut once
  Relief beside_bends = Relief::none;  ///< what is cut where bends would tear the sheet; no rip
};

/// What holds for bends between plates that say nothing else, instead of the defaults of the plates
/// file. Lengths in mm.
struct JoinOptions {
  std::optional<double> inside_radius;
  std::optional<LateralBoundary> lateral;
  std::optional<double> trade_off;
  std::optional<double> largest_span;
  std::optional<bool> trim;
};

/// A request to a maker, as data. `options()` has an entry for each member except `input` and
/// `own`; a maker uses those that its own entry lists.
struct Request : PatternChecks {
  std::filesystem::path input;                   ///< "-" reads standard input
  std::string body;                              ///< number (1-based) or name; empty: the only body
  std::optional<AllowanceRule> allowance;        ///< empty: the file's, or else the default
  std::optional<shop::PartMaterials> materials;  ///< the material of each part that has a row
  std::string material;  ///< name of that of all others: of a file or the shop's; empty: not said
  std::vector<std::pair<std::string, double>> bend_k;  ///< K of single bends by id ("B1");
                                                       ///< overrides `allowance`
  std::string root = "largest";                        ///< "largest" or a face number
  std::vector<int> rip_edges;                          ///< of the solid, along which it is cut open
  std::optional<double> thickness;  ///< of the sheet in the solid, mm; empty: the likeliest
  std::string up = "auto";  ///< "auto", "reference", "other", or the number of the face to face up
  ExtrudedHoles extruded = ExtrudedHoles::pilot;  ///< what is cut within formed features
  ReliefOptions relief;
  JoinOptions join;
  std::optional<LengthUnit> units;  ///< of the report and of the DXF; empty: the file's
  bool overbend = false;            ///< the mould is for strips that spring back
  int piece = 0;                    ///< which of several pieces is shown, from 0
  DxfOptions dxf;                   ///< its units are ignored: the report's are used
  std::map<std::string, OptionValue, std::less<>> own;  ///< of options that one maker alone has
};

}  // namespace planish::job
