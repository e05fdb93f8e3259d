#include "coordinate_bound.hpp"

#include <planish/brep/codes.hpp>

#include <StepData_StepModel.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <fmt/format.h>

#include <cmath>

namespace planish::brep {

std::optional<Error> point_too_far_away(const StepData_StepModel& model, double millimetres,
                                        const std::string& name) {
  constexpr double kKilometre = 1e6;  // mm
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const auto point = Handle(StepGeom_CartesianPoint)::DownCast(model.Value(i));
    if (point.IsNull()) continue;
    for (int k = 1; k <= point->NbCoordinates(); ++k) {
      const double coordinate = millimetres * std::abs(point->CoordinatesValue(k));
      if (coordinate <= kFarthestPoint) continue;
      return Error{
          code::too_far_away,
          fmt::format("{} has a point {:.3g} km from its origin, where nothing can be "
                      "computed beyond {:.0f} km: the file is damaged, or the part must be "
                      "moved to the origin and exported again.",
                      name, coordinate / kKilometre, kFarthestPoint / kKilometre),
          fmt::format("{} #{}", name, model.IdentLabel(point))};
    }
  }
  return std::nullopt;
}

}  // namespace planish::brep
