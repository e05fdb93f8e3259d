#include "step_out.hpp"

#include "solid_check.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace planish::brep {
namespace {

TEST(StepString, DoublesQuotesAndBackslashesAndEncodesTheRest) {
  EXPECT_EQ(step_string("lid 5 ~"), "lid 5 ~");
  EXPECT_EQ(step_string("O'Neill\\a"), "O''Neill\\\\a");
  EXPECT_EQ(step_string("\x7F\x1F"), "\\X2\\007F\\X0\\\\X2\\001F\\X0\\");
  EXPECT_EQ(step_string("\xC2\x80\xC3\xA4\xDF\xBF"),
            "\\X2\\0080\\X0\\\\X2\\00E4\\X0\\\\X2\\07FF\\X0\\");
  EXPECT_EQ(step_string("\xE0\xA0\x80\xE2\x8C\x80\xEF\xBF\xBF"),
            "\\X2\\0800\\X0\\\\X2\\2300\\X0\\\\X2\\FFFF\\X0\\");
  EXPECT_EQ(step_string("\xF0\x9F\x98\x80\xF4\x8F\xBF\xBF"),
            "\\X4\\0001F600\\X0\\\\X4\\0010FFFF\\X0\\");
}

TEST(StepString, ReplacesWhatIsNotUtf8) {
  const std::string unknown = "\\X2\\FFFD\\X0\\";
  EXPECT_EQ(step_string("\x80"), unknown);
  EXPECT_EQ(step_string("\xC1"
                        "a"),
            unknown + "a")
      << "no lead byte";
  EXPECT_EQ(step_string("\xF5"
                        "a"),
            unknown + "a")
      << "beyond Unicode";
  EXPECT_EQ(step_string("\xE2\x8C"), unknown) << "ends early";
  EXPECT_EQ(step_string("\xC3"
                        "a"),
            unknown + "a")
      << "no continuation";
}

TopoDS_Shape drilled_block() {
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(30, 20, 2).Shape(),
                         BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(9, 9, -1), gp::DZ()), 4, 5).Shape())
      .Shape();
}

TEST(StepOut, IsReadAgainAsTheSameSolid) {
  const auto text = step_text(drilled_block(), "lid");
  ASSERT_TRUE(text);
  const auto check = check_step_solid(*text);
  ASSERT_TRUE(check);
  EXPECT_EQ(check->product, "lid");
  EXPECT_EQ(check->solids, 1);
  EXPECT_TRUE(check->valid && check->closed);
  EXPECT_NEAR(check->volume, 1200 - 32 * std::numbers::pi, 1e-6);
  EXPECT_EQ(check->planes, 6);
  EXPECT_EQ(check->cylinders, 1);
}

TEST(StepOut, KeepsThePlaceAndTheSideOfAShape) {
  gp_Trsf motion;
  motion.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), std::numbers::pi / 2);
  motion.SetTranslationPart(gp_Vec(100, 50, -20));
  const auto text = step_text(drilled_block().Moved(TopLoc_Location(motion)), "lid");
  ASSERT_TRUE(text);
  const auto check = check_step_solid(*text);
  ASSERT_TRUE(check);
  EXPECT_NEAR((check->lo - Vec3(80, 50, -20)).norm(), 0.0, 1e-5);
  EXPECT_NEAR((check->hi - Vec3(100, 80, -18)).norm(), 0.0, 1e-5);
  EXPECT_GT(check->volume, 0.0);
}

TEST(StepOut, IsTheSameTextEachTimeInMillimetresAndWithAFixedHeader) {
  const auto once = step_text(drilled_block(),
                              "D\xC3\xA4"
                              "ckel 'a'");
  const auto again = step_text(drilled_block(),
                               "D\xC3\xA4"
                               "ckel 'a'");
  ASSERT_TRUE(once && again);
  EXPECT_EQ(*once, *again);
  EXPECT_NE(once->find("1970-01-01T00:00:00"), std::string::npos);
  EXPECT_NE(once->find("AUTOMOTIVE_DESIGN"), std::string::npos);
  EXPECT_NE(once->find(".MILLI.,.METRE."), std::string::npos);
  EXPECT_NE(once->find("PRODUCT('D\\X2\\00E4\\X0\\ckel ''a''','D\\X2\\00E4\\X0\\ckel ''a''"),
            std::string::npos);
  EXPECT_EQ(once->find("planish-product-name"), std::string::npos);
  EXPECT_EQ(once->find("PCURVE"), std::string::npos) << "readers make these themselves";
}

TEST(StepOut, WritesTheFacesWithMostEdgesLast) {
  const auto text = step_text(drilled_block(), "lid");
  const size_t shell = text->find("CLOSED_SHELL('',(");
  ASSERT_NE(shell, std::string::npos);
  // The two faces with a hole have a second bound, and come after those with one.
  const size_t data = text->find("DATA;");
  std::vector<int> bounds;
  for (size_t at = text->find("ADVANCED_FACE('',(", data); at != std::string::npos;
       at = text->find("ADVANCED_FACE('',(", at + 1)) {
    const std::string list = text->substr(at, text->find(')', at) - at);
    bounds.push_back(static_cast<int>(std::ranges::count(list, '#')));
  }
  ASSERT_EQ(bounds.size(), 7u);
  EXPECT_TRUE(std::ranges::is_sorted(bounds));
  EXPECT_EQ(std::ranges::count(bounds, 2), 2);
}

}  // namespace
}  // namespace planish::brep
