#include "makers.hpp"

namespace planish::job {

// Each in a file of its own, NAME_maker.cpp.
Maker unfold_maker();
Maker connect_maker();
Maker transition_maker();
Maker slit_maker();

const std::vector<Maker>& makers() {
  static const std::vector<Maker> table{unfold_maker(), connect_maker(), transition_maker(),
                                        slit_maker()};
  return table;
}

std::vector<OptionUse> with_pattern_options(std::vector<OptionUse> own) {
  for (const char* name :
       {"profile", "r12", "splines", "arc_tolerance", "bend_marks", "tick_length", "tangent_lines",
        "bend_text", "turn_to_blank", "write_overlapping", "write_anyway", "density"})
    own.push_back({name});
  return own;
}

std::vector<OptionUse> with_bending_options(std::vector<OptionUse> own) {
  for (const char* name :
       {"shop", "materials", "check_bending", "tools", "metal", "springback", "clearance",
        "shortfall", "opening", "v", "as_drawn", "large_radii", "chord_error", "gauge_openings"})
    own.push_back({name});
  return with_pattern_options(std::move(own));
}

}  // namespace planish::job
