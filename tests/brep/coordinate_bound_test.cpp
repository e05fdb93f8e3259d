#include "coordinate_bound.hpp"

#include "support/error_data.hpp"

#include <planish/brep/codes.hpp>
#include <planish/geometry/frame.hpp>

#include <StepData_StepModel.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <TCollection_HAsciiString.hxx>
#include <gtest/gtest.h>

namespace planish::brep {
namespace {

Handle(StepData_StepModel) model_with(const std::vector<Vec3>& points) {
  const Handle(StepData_StepModel) model = new StepData_StepModel;
  for (const Vec3& p : points) {
    const Handle(StepGeom_CartesianPoint) point = new StepGeom_CartesianPoint;
    point->Init3D(new TCollection_HAsciiString(""), p.x(), p.y(), p.z());
    model->AddEntity(point);
  }
  return model;
}

TEST(PointTooFarAway, LetsPassWhatIsWithinAThousandKilometres) {
  EXPECT_FALSE(point_too_far_away(*model_with({}), 1.0, "a.step"));
  EXPECT_FALSE(point_too_far_away(*model_with({{0, 0, 0}, {1e9, -1e9, 1e9}}), 1.0, "a.step"));
  EXPECT_FALSE(point_too_far_away(*model_with({{1e6, 0, 0}}), 1000.0, "a.step"));
}

TEST(PointTooFarAway, LooksAtEveryCoordinateOfEveryPointInItsUnit) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      Vec3 far = Vec3::Zero();
      far[axis] = sign * 1.5e9;
      const auto error = point_too_far_away(*model_with({{1, 2, 3}, far}), 1.0, "a.step");
      ASSERT_TRUE(error);
      EXPECT_EQ(error->code, code::too_far_away);
      EXPECT_NEAR(planish::test::number_in(*error, "reach"), 1500, 1e-9);
      EXPECT_NEAR(planish::test::number_in(*error, "limit"), 1000, 1e-9);
      EXPECT_NE(error->message.find("a.step"), std::string::npos);
    }
  const auto metres = point_too_far_away(*model_with({{2e6, 0, 0}}), 1000.0, "a.step");
  ASSERT_TRUE(metres);
  EXPECT_NEAR(planish::test::number_in(*metres, "reach"), 2000, 1e-9);
}

}  // namespace
}  // namespace planish::brep
