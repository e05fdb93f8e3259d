#include <planish/brep/step.hpp>
#include <planish/collision/meeting_faces.hpp>
#include <planish/job/run.hpp>
#include <planish/sheet/folded_blocks.hpp>
#include <planish/sheet/layout.hpp>
#include <planish/transition/transition.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace planish::job {
namespace {

using nlohmann::json;

TEST(TransitionSolids, AreMadeWhereCurvesAreFittedBetweenTheirNodes) {
  // The borders of the cones meet their surfaces at the nodes of the fit to 1e-10 mm, and between
  // them to 3e-7 mm: an edge must bear that.
  const json file = {
      {"format", "planish/transition"},
      {"version", 1},
      {"thickness", 0.094},
      {"press_lines", {{"max_angle", 15}}},
      {"from",
       {{"profile",
         {{"polygon",
           {{-143.2, -110.5},
            {18.6, -163.4},
            {192.4, -18.7},
            {151.9, 101.9},
            {-27.5, 162.5},
            {-192.9, 14.7}}}}}}},
      {"to",
       {{"frame", {{"origin", {0, 0, 417}}, {"normal", {0, 0, 1}}, {"x", {1, 0, 0}}}},
        {"profile",
         {{"rounded_rectangle", {{"width", 354.5}, {"height", 215.9}, {"radius", 20.1}}}}}}}};
  const json request = {{"maker", "transition"},
                        {"input", {{"name", "t.json"}, {"content", file}}},
                        {"artifacts", {"step"}}};
  const auto result = run(request.dump());
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->artifacts.size(), 1u);
  const json report = json::parse(result->report);
  for (const json& finding : report["checks"])
    EXPECT_NE(finding["code"], "folded_solid") << finding["message"];
  EXPECT_NEAR(report["verification"]["explained_ratio"].get<double>(), 1.0, 1e-5);
}

TransitionSpec square_to_round(double radius) {
  TransitionSpec spec;
  spec.thickness = 1.0;
  spec.from.profile = PolygonProfile{{{-100, -100}, {100, -100}, {100, 100}, {-100, 100}}};
  spec.to.profile = EllipseProfile{radius, radius};
  spec.to.frame.origin = {0, 0, 250};
  return spec;
}

// The surface bounds a convex body, so no two of its parts meet, however far the round end outgrows
// the square: the cones are then so oblique that a strip between two rulings ends at heights that
// differ by more than its distance from the apex.
TEST(TransitionSolids, OfConvexHullsNeverSeemToMeetThemselves) {
  for (const double radius : {90.0, 110.0, 130.0, 200.0, 400.0}) {
    const auto pieces = folded_pieces(square_to_round(radius));
    ASSERT_TRUE(pieces) << pieces.error().message;
    for (const FoldedPiece& piece : *pieces)
      EXPECT_TRUE(meeting_faces(piece.sheet, 0.04).empty()) << radius;
  }
}

TEST(TransitionSolids, BlocksOfConesEndBeforeTheirApex) {
  const double radius = 200;
  const auto pieces = folded_pieces(square_to_round(radius));
  ASSERT_TRUE(pieces) << pieces.error().message;
  const Sheet& sheet = pieces->front().sheet;
  for (const FaceId face : sheet.faces.ids()) {
    if (!std::holds_alternative<BendId>(sheet[face].part_of)) continue;
    // Cones of the square's corners lie above it, and blocks of the whole thickness at most half of
    // that below.
    for (const Block& block : folded_blocks(sheet, face, {.inset = 0.02}))
      for (const Vec3& p : block)
        EXPECT_GT(p.z(), -0.5 * sheet.thickness);
  }
}

TransitionSpec from_circle_to(std::vector<Vec2> corners) {
  TransitionSpec spec;
  spec.thickness = 1.0;
  spec.from.profile = EllipseProfile{100, 100};
  spec.to.profile = PolygonProfile{std::move(corners)};
  spec.to.frame.origin = {0, 0, 150};
  return spec;
}

/// Both have the same area and length of cut: the solid's own flat pattern, and that found in what
/// is read from its STEP.
void expect_unfolds_again(const FoldedPiece& piece, const std::string& name) {
  const FlattenOptions options{.allowance = ConstantK{0.5, ""}};
  const auto step = folded_solid_step(piece.sheet, name);
  ASSERT_TRUE(step) << name << ": " << step.error().message;
  const auto read = read_step_text(*step, name);
  ASSERT_TRUE(read) << name << ": " << read.error().message;
  const auto found = recognize(read->bodies.front());
  ASSERT_TRUE(found) << name << ": " << found.error().message;
  const auto flat = flatten(found->sheet, options), own = flatten(piece.sheet, options);
  ASSERT_TRUE(flat && own) << name;
  constexpr double kSame = 1e-5;
  EXPECT_NEAR(flat->area / own->area, 1.0, kSame) << name;
  EXPECT_NEAR(flat->perimeter / own->perimeter, 1.0, kSame) << name;
}

// Rulings of cones on one corner differ in length: those of a rectangle of parameters that holds
// the longest would end beyond the apex.
TEST(TransitionSolids, UnfoldAgainHoweverObliqueTheirCones) {
  std::vector<std::pair<std::string, TransitionSpec>> specs;
  for (const double radius : {90.0, 110.0, 130.0, 150.0, 200.0, 400.0})
    specs.emplace_back("round of " + std::to_string(radius), square_to_round(radius));
  for (const double x : {0.0, 30.0, 90.0, 150.0})
    specs.emplace_back("apex at " + std::to_string(x), from_circle_to({{x, 20}}));
  specs.emplace_back("ridge", from_circle_to({{-50, 0}, {50, 0}}));
  for (const auto& [name, spec] : specs) {
    const auto pieces = folded_pieces(spec, {.tolerance = 1e-9});
    ASSERT_TRUE(pieces) << name << ": " << pieces.error().message;
    for (const FoldedPiece& piece : *pieces)
      expect_unfolds_again(piece, name);
  }
}

}  // namespace
}  // namespace planish::job
