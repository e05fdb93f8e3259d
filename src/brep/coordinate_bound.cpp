#include "coordinate_bound.hpp"

#include "refusals.hpp"

#include <StepData_StepModel.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <fmt/format.h>

#include <cmath>

namespace planish::brep {

std::optional<Error> point_too_far_away(const StepData_StepModel& model, double millimetres,
                                        const std::string& name) {
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const auto point = Handle(StepGeom_CartesianPoint)::DownCast(model.Value(i));
    if (point.IsNull()) continue;
    for (int k = 1; k <= point->NbCoordinates(); ++k) {
      const double coordinate = millimetres * std::abs(point->CoordinatesValue(k));
      if (coordinate <= kFarthestPoint) continue;
      return error_of(refuse::point_too_far_away,
                      {{"file", name},
                       {"reach", coordinate / kKilometre, unit::kilometres},
                       {"limit", kFarthestPoint / kKilometre, unit::kilometres}},
                      fmt::format("{} #{}", name, model.IdentLabel(point)));
    }
  }
  return std::nullopt;
}

}  // namespace planish::brep
