#include "rule_checks.hpp"

#include <planish/base/assert.hpp>
#include <planish/inspect/findings.hpp>

#include <array>
#include <cmath>

namespace planish {

using namespace inspect_detail;

std::span<const RuleField> rule_fields() {
  static constexpr std::array kFields{
      RuleField{
          "flange_height_t", &Rules::flange_height_t,
          "smallest flange height from the outside of the bend: this · T + flange_height_r · R",
          "Creo: 1.5 T + R; shops: 4 T, or 0.7 of the V-die's opening"},
      RuleField{"flange_height_r", &Rules::flange_height_r,
                "share of the inside radius R in the smallest flange height", "Creo: 1"},
      RuleField{"opening_to_bend_t", &Rules::opening_to_bend_t,
                "smallest distance of an opening from a bend's tangent line, in T",
                "Protolabs: 2; Creo: 2.5 T + R from the bend"},
      RuleField{"opening_to_edge_t", &Rules::opening_to_edge_t,
                "smallest distance of an opening from the outer contour, in T",
                "laser: SMS Laser 1, SendCutSend 0.5; punch: Creo 2, Crenshaw 1"},
      RuleField{"opening_to_opening_t", &Rules::opening_to_opening_t,
                "smallest distance between two openings, in T",
                "laser: Tuan Thinh 1, Acute 0.7, SendCutSend 0.5; punch: 2; Creo: 5"},
      RuleField{"opening_to_opening_mm", &Rules::opening_to_opening_mm,
                "smallest distance between two openings of thin sheet, mm",
                "laser: thin webs burn away; 0 for punching"},
      RuleField{"smallest_opening_t", &Rules::smallest_opening_t,
                "diameter of the circle that must fit into every opening, in T",
                "laser: SendCutSend and RapidFab 0.5, SMS Laser 1; punch: 1.2, Image2Punch 1 to 2"},
      RuleField{"inside_radius_t", &Rules::inside_radius_t,
                "smallest inside radius of a bend, in T",
                "shops: 1; low-carbon steel 0.5, and not below 0.8 mm"},
      RuleField{"relief_width_t", &Rules::relief_width_t,
                "smallest width of the relief where a bend ends inside an edge, in T; 0 switches "
                "the rule off",
                "laser: SendCutSend 0.5; punch: 1, the width of a tool"},
      RuleField{"relief_depth_r", &Rules::relief_depth_r,
                "share of the inside radius R in the smallest relief depth", "shops: 1"},
      RuleField{"relief_depth_t", &Rules::relief_depth_t,
                "smallest relief depth from the outside of the bend: this · T + relief_depth_r · R",
                "SendCutSend: 1, and 0.5 mm more"},
      RuleField{"hem_diameter_t", &Rules::hem_diameter_t,
                "smallest inside diameter of a hem (170° and more), in T", "shops: 1"},
      RuleField{"hem_return_t", &Rules::hem_return_t,
                "shortest return of a hem from the outside of the bend, in T", "shops: 6"},
      RuleField{"k_low", &Rules::k_low, "smallest plausible K-factor", "measured ones lie above"},
      RuleField{"k_high", &Rules::k_high, "largest plausible K-factor", "the middle of the sheet"},
  };
  return kFields;
}

Rules rules_for(Process process) {
  Rules rules;
  if (process == Process::laser) return rules;
  rules.opening_to_edge_t = 2.0;
  rules.opening_to_opening_t = 2.0;
  rules.opening_to_opening_mm = 0.0;
  rules.smallest_opening_t = 1.2;
  rules.relief_width_t = 1.0;
  return rules;
}

std::vector<Finding> check_rules(const Sheet& sheet, const FlatPattern& pattern,
                                 const Rules& rules) {
  if (!rules.enabled) return {};
  require_valid(pattern);
  for (const RuleField& field : rule_fields())
    PLANISH_ASSERT(rules.*(field.value) >= 0.0 && std::isfinite(rules.*(field.value)));
  const Workpiece workpiece(sheet, pattern);
  std::vector<Observation> all;
  for (const auto observe :
       {observe_flange_heights, observe_reliefs, observe_bend_shapes, observe_openings_by_bends,
        observe_openings_by_edges, observe_openings_by_openings, observe_opening_sizes}) {
    for (Observation& one : observe(workpiece, rules))
      all.push_back(std::move(one));
  }
  return grouped(all);
}

}  // namespace planish
