#include "guarded.hpp"
#include "reference_shell.hpp"
#include "step_out.hpp"

#include <planish/brep/step.hpp>

namespace planish {

Result<std::string> folded_surface_step(const Sheet& sheet, const std::string& name) {
  return brep::guarded(
      [&]() -> Result<std::string> {
        const auto shell = brep::reference_shell(sheet);
        if (!shell) return pass_on(shell);
        return brep::step_text(*shell, name);
      },
      name);
}

}  // namespace planish
