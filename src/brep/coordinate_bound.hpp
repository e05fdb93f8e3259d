#pragma once

#include <planish/base/result.hpp>

#include <optional>
#include <string>

class StepData_StepModel;

namespace planish::brep {

/// No point of a file may be farther from its origin than 1,000 km, which is as far as `check` lets
/// faces of sheets be. Steps between doubles are 0.0001 µm there, well below the kernel's tolerance
/// of 0.1 µm; what lies farther away is a damaged number, and squares of it would overflow.
constexpr double kFarthestPoint = 1e9;  // mm
constexpr double kKilometre = 1e6;      // mm

/// `too_far_away` where a point of the file is; `millimetres` is the length of its unit.
std::optional<Error> point_too_far_away(const StepData_StepModel& model, double millimetres,
                                        const std::string& name);

}  // namespace planish::brep
