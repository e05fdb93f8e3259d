#pragma once

#include "assembly.hpp"

namespace planish::brep {

/// The volume of forms that are curved in two directions, as dimples are, and have the sheet's
/// thickness: drawn from it, they hold what was there. By their faces' areas, mm³, coarse.
double drawn_volume(const Recognition& of);

}  // namespace planish::brep
