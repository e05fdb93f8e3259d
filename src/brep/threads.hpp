#pragma once

#include "assembly.hpp"

#include <optional>

namespace planish::brep {

/// The nominal circle of a thread that is modelled in an opening, clockwise: as far from the axis
/// of its core, a circle of that plane, as helical edges of its walls go, or its rings. Empty where
/// there is none.
std::optional<BorderLoop> thread_about(const Recognition& of, const RimPart& part,
                                       const Frame& plane, const BorderLoop& core);

}  // namespace planish::brep
