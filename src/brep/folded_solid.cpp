#include "guarded.hpp"
#include "step_out.hpp"
#include "thicken.hpp"

#include <planish/brep/step.hpp>

namespace planish {

Result<std::string> folded_solid_step(const Sheet& sheet, const std::string& name) {
  return brep::guarded(
      [&]() -> Result<std::string> {
        const auto solid = brep::thicken(sheet);
        if (!solid) return tl::unexpected(solid.error());
        return brep::step_text(*solid, name);
      },
      name);
}

}  // namespace planish
