#pragma once

#include <planish/brake/plan.hpp>
#include <planish/sheet/flat_pattern.hpp>

namespace planish {

/// Enters the first stroke that presses each bend in a pattern; bends that none presses stay
/// without. A bend formed by bumps gets a line for each.
void number_bends(FlatPattern& flat, const Plan& plan);

}  // namespace planish
