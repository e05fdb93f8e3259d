#include "job/job_requests.hpp"

#include <planish/job/transition_json.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using nlohmann::json;

/// A square of 40 below a circle of 10, in a unit.
json duct() {
  return json::parse(R"({"thickness": 1, "units": "inch",
    "from": {"profile": {"polygon": [[-2, -2], [2, -2], [2, 2], [-2, 2]]}},
    "to": {"profile": {"circle": {"radius": 1}}, "frame": {"origin": [0, 0, 4]}}})");
}

TransitionFile duct_of(const json& document) {
  const auto file = parse_transition(document.dump(), "t.json");
  EXPECT_TRUE(file) << (file ? "" : file.error().message);
  return file ? *file : TransitionFile{};
}

std::string wrong_place(const json& document) {
  const auto file = parse_transition(document.dump(), "t.json");
  if (file) return "read";
  EXPECT_EQ(file.error().code, code::invalid_input);
  return file.error().where;
}

TEST(TransitionJson, ReadsLengthsInTheUnitOfTheFile) {
  const TransitionFile file = duct_of(duct());
  EXPECT_EQ(file.units, LengthUnit::inch);
  EXPECT_EQ(file.spec.thickness, 25.4);
  const auto& corners = std::get<PolygonProfile>(file.spec.from.profile).corners;
  ASSERT_EQ(corners.size(), 4u);
  EXPECT_EQ(corners[2], Vec2(50.8, 50.8));
  EXPECT_EQ(std::get<EllipseProfile>(file.spec.to.profile).rx, 25.4);
  EXPECT_EQ(std::get<EllipseProfile>(file.spec.to.profile).ry, 25.4);
  EXPECT_LT((file.spec.to.frame.origin - Vec3(0, 0, 101.6)).norm(), 1e-12);
}

TEST(TransitionJson, HasDefaultsForWhatIsLeftOut) {
  const TransitionFile file = duct_of(duct());
  EXPECT_EQ(file.spec.k_factor, 0.5);
  EXPECT_TRUE(file.has_default_k);
  EXPECT_EQ(file.spec.sizes_are, SizesAre::mid);
  EXPECT_FALSE(file.spec.seam);
  EXPECT_EQ(file.spec.pieces, Division::one);
  EXPECT_EQ(file.spec.from.frame.z, Vec3::UnitZ());
  json given = duct();
  given["k_factor"] = 0.5;
  EXPECT_FALSE(duct_of(given).has_default_k);
}

TEST(TransitionJson, ReadsEveryProfile) {
  const auto profile = [](const char* text) {
    json document = duct();
    document.erase("units");
    document["to"]["profile"] = json::parse(text);
    return duct_of(document).spec.to.profile;
  };
  const auto ellipse = std::get<EllipseProfile>(profile(R"({"ellipse": {"rx": 3, "ry": 2}})"));
  EXPECT_EQ(ellipse.rx, 3.0);
  EXPECT_EQ(ellipse.ry, 2.0);
  const auto rectangle = std::get<RoundedRectangleProfile>(
      profile(R"({"rounded_rectangle": {"width": 5, "height": 4, "radius": 1}})"));
  EXPECT_EQ(rectangle.width, 5.0);
  EXPECT_EQ(rectangle.height, 4.0);
  EXPECT_EQ(rectangle.radius, 1.0);
  const auto obround = std::get<ObroundProfile>(
      profile(R"({"obround": {"length": 6, "width": 3}})"));
  EXPECT_EQ(obround.length, 6.0);
  EXPECT_EQ(obround.width, 3.0);
  EXPECT_EQ(std::get<SplineProfile>(profile(R"({"spline": [[1, 0], [0, 1], [-1, 0]]})")).points[1],
            Vec2(0, 1));
}

TEST(TransitionJson, ReadsSeamPiecesSizesAndPressLines) {
  const auto with = [](const char* key, const json& value) {
    json document = duct();
    document[key] = value;
    return duct_of(document).spec;
  };
  EXPECT_EQ(std::get<SeamEdge>(*with("seam", {{"edge", 2}}).seam).edge, 2);
  EXPECT_EQ(std::get<SeamCorner>(*with("seam", {{"corner", 3}}).seam).corner, 3);
  EXPECT_EQ(std::get<SeamParameter>(*with("seam", {{"parameter", 0.25}}).seam).parameter, 0.25);
  EXPECT_EQ(with("pieces", 1).pieces, Division::one);
  EXPECT_EQ(with("pieces", 2).pieces, Division::two);
  EXPECT_EQ(with("pieces", "per_side").pieces, Division::per_side);
  EXPECT_EQ(with("sizes_are", "inside").sizes_are, SizesAre::inside);
  EXPECT_EQ(with("sizes_are", "outside").sizes_are, SizesAre::outside);
  EXPECT_EQ(std::get<PressCount>(with("press_lines", {{"count", 7}}).pressing).count, 7);
  EXPECT_NEAR(
      std::get<PressAngle>(with("press_lines", {{"max_angle", 15}}).pressing).largest.degrees(),
      15.0, 1e-12);
  EXPECT_EQ(std::get<PressChord>(with("press_lines", {{"chord", 2}}).pressing).largest, 50.8);
}

TEST(TransitionJson, TurnsProfilesByTheirFrame) {
  const auto frame = [](const char* text) {
    json document = duct();
    document["to"]["frame"] = json::parse(text);
    return duct_of(document).spec.to.frame;
  };
  const Frame given = frame(R"({"normal": [0, 3, 0], "x": [0, 1, 2]})");
  EXPECT_LT((given.z - Vec3::UnitY()).norm(), 1e-12);
  EXPECT_LT((given.x - Vec3::UnitZ()).norm(), 1e-12) << "in the plane";
  EXPECT_LT((given.y - given.z.cross(given.x)).norm(), 1e-12);
  // Along x itself the profile's x goes down, or up where the normal looks back.
  EXPECT_LT((frame(R"({"normal": [2, 0, 0]})").x + Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((frame(R"({"normal": [-2, 0, 0]})").x - Vec3::UnitZ()).norm(), 1e-12);
  json document = duct();
  document["to"]["frame"] = {{"normal", {0, 0, 1}}, {"x", {0, 0, 5}}};
  EXPECT_EQ(wrong_place(document), "t.json/to/frame/x");
}

TEST(TransitionJson, NamesThePlaceOfAMistake) {
  for (const auto& [pointer, value] :
       std::vector<std::pair<const char*, json>>{{"/thickness", 0},
                                                 {"/k_factor", 1.5},
                                                 {"/from/profile/polygon", 3},
                                                 {"/to/profile/circle/radius", 0},
                                                 {"/seam", {{"edge", 1}, {"corner", 1}}},
                                                 {"/seam", {{"edge", -1}}},
                                                 {"/pieces", 3},
                                                 {"/sizes_are", "middle"},
                                                 {"/press_lines", {{"count", 0}}},
                                                 {"/press_lines", {{"count", 2001}}},
                                                 {"/press_lines", {{"max_angle", 0}}},
                                                 {"/press_lines", {{"max_angle", 361}}},
                                                 {"/press_lines", {{"chord", 0}}},
                                                 {"/version", 2},
                                                 {"/format", "planish/slits"}}) {
    json document = duct();
    document[json::json_pointer(pointer)] = value;
    EXPECT_EQ(wrong_place(document).rfind(std::string("t.json") + pointer, 0), 0u)
        << pointer << " " << value;
  }
  for (const auto& [pointer, value] :
       std::vector<std::pair<const char*, json>>{{"/press_lines", {{"count", 1}}},
                                                 {"/press_lines", {{"count", 2000}}},
                                                 {"/press_lines", {{"max_angle", 360}}},
                                                 {"/version", 1},
                                                 {"/format", "planish/transition"},
                                                 {"/seam", {{"parameter", 1}}}}) {
    json document = duct();
    document[json::json_pointer(pointer)] = value;
    EXPECT_EQ(wrong_place(document), "read") << pointer << " " << value;
  }
  json document = duct();
  document["to"]["profile"]["circle"] = {{"radius", 1}};
  document["to"]["profile"]["spline"] = json::array();
  EXPECT_EQ(wrong_place(document), "t.json/to/profile");
}

}  // namespace
}  // namespace planish::job
