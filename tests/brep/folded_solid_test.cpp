#include "solid_check.hpp"
#include "support/sheets.hpp"

#include <planish/brep/step.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using brep::check_step_solid;
using brep::SolidCheck;
using std::numbers::pi;
constexpr auto up = BendDirection::up;
constexpr auto down = BendDirection::down;

SolidCheck folded(const Sheet& sheet, const std::string& name = "part") {
  const auto text = folded_solid_step(sheet, name);
  if (!text) {
    ADD_FAILURE() << text.error().message << " (" << text.error().where << ")";
    return {};
  }
  const auto check = check_step_solid(*text);
  if (!check) ADD_FAILURE() << check.error().message;
  return check.value_or(SolidCheck{});
}

/// A valid closed solid whose volume is the one of Pappus, which the sheet knows.
SolidCheck expect_sound(const Sheet& sheet, double relative_volume = 1e-9) {
  const SolidCheck check = folded(sheet);
  EXPECT_EQ(check.solids, 1);
  EXPECT_TRUE(check.valid);
  EXPECT_TRUE(check.closed);
  EXPECT_NEAR(check.volume / *sheet.volume, 1.0, relative_volume);
  return check;
}

std::string code_of(const Sheet& sheet) {
  const auto text = folded_solid_step(sheet, "part");
  return text ? "none" : std::string(code_name(text.error().code));
}

void expect_box(const SolidCheck& check, const Vec3& lo, const Vec3& hi) {
  EXPECT_LT((check.lo - lo).norm(), 1e-5) << check.lo.transpose();
  EXPECT_LT((check.hi - hi).norm(), 1e-5) << check.hi.transpose();
}

TEST(FoldedSolid, OfStripsIsSound) {
  for (const Sheet& sheet : {l_bracket(), l_bracket_down(), u_channel(), z_profile(), staircase(4),
                             hem(), turn_of_250(), two_turns_of_270(), rolled()})
    expect_sound(sheet);
}

TEST(FoldedSolid, KeepsPlanesAndCylinders) {
  // Two skins each of two flanges, three walls on each flange, two ring sectors beside the bend.
  const SolidCheck l = expect_sound(l_bracket());
  EXPECT_EQ(l.planes, 4 + 6 + 2);
  EXPECT_EQ(l.cylinders, 2);
  for (BendDirection direction : {up, down}) {
    const SolidCheck b = expect_sound(box({}, direction));
    EXPECT_EQ(b.planes, 5 * 2 + 4 * 3 + 8 + 4 * 2);
    EXPECT_EQ(b.cylinders, 8);
  }
  const SolidCheck plate = expect_sound(plate_with_holes());
  EXPECT_EQ(plate.planes, 2 + 4 + 2);
  EXPECT_EQ(plate.cylinders, 2 + 2);
}

TEST(FoldedSolid, KeepsCones) {
  for (BendDirection direction : {up, down}) {
    ConeJoint joint;
    joint.turn.direction = direction;
    const SolidCheck check = expect_sound(cone_joined(joint));
    EXPECT_EQ(check.cones, 4) << "two skins and two walls perpendicular to them";
    EXPECT_EQ(check.splines, 0);
  }
  const SolidCheck rolled_cone = expect_sound(truncated_cone(20, 40, 50, Angle::degrees(300), 1.5));
  EXPECT_EQ(rolled_cone.cones, 4);
  EXPECT_EQ(rolled_cone.planes, 2);
}

TEST(FoldedSolid, LiesWhereTheSheetIs) {
  expect_box(folded(l_bracket()), {0, 0, -2}, {50 + 3 + 2, 40, 3 + 30});
  expect_box(folded(l_bracket_down()), {0, 0, -3 - 2 - 30}, {50 + 3 + 2, 40, 0});
  expect_box(folded(ring(30, 12, 2)), {-30, -30, -2}, {30, 30, 0});
}

TEST(FoldedSolid, OfAFrustumHasItsRadii) {
  // Reference skin outside: the wide end reaches 40 from the axis.
  const Sheet sheet = truncated_cone(20, 40, 50, Angle::degrees(300), 1.5);
  const Cone& cone = std::get<Cone>(std::get<Developable>(sheet.faces.front().surface));
  Eigen::Isometry3d upright = Eigen::Isometry3d::Identity();
  upright.linear() << cone.frame.x, cone.frame.y, cone.frame.z;
  upright.translation() = cone.frame.origin;
  const SolidCheck check = folded(moved(sheet, upright.inverse()));
  const double apex = 20 / (20.0 / 50.0);
  EXPECT_NEAR(check.hi.y(), 40, 1e-5);
  EXPECT_NEAR(check.lo.x(), -40, 1e-5);
  EXPECT_NEAR(check.hi.z(), apex + 50 + 1.5 * 20 / std::hypot(20, 50), 1e-5);
  EXPECT_NEAR(check.lo.z(), apex, 1e-5);
}

TEST(FoldedSolid, MitresSharpBends) {
  const auto l = [](BendDirection direction) {
    return strip({Straight{30}, Crease{Angle::degrees(90), direction}, Straight{20}}, 15, 1.5);
  };
  const SolidCheck inside = expect_sound(l(up));
  expect_box(inside, {0, 0, -1.5}, {31.5, 15, 20});
  EXPECT_EQ(inside.planes, 4 + 6);
  const SolidCheck outside = expect_sound(l(down));
  expect_box(outside, {0, 0, -20}, {30, 15, 0});
  expect_sound(strip({Straight{30}, Crease{Angle::degrees(70), up}, Straight{20},
                      Turn{Angle::degrees(40), 2.0, down}, Straight{20},
                      Crease{Angle::degrees(120), down}, Straight{30}},
                     15, 1.5));
}

TEST(FoldedSolid, OfOpenedBendsIsSound) {
  for (BendDirection direction : {up, down}) {
    Opened part;
    part.turn.direction = direction;
    expect_sound(slot_across_bend(12, part));
    expect_sound(slot_into_bend(12, part));
    // The walls of these are no surfaces of revolution: fitted within 5e-7 mm.
    EXPECT_EQ(expect_sound(hole_in_bend(5, 0.44, part), 1e-7).splines, 1);
    EXPECT_EQ(expect_sound(hole_across_bend(20, 0.44, part), 1e-7).splines, 2);
  }
}

TEST(FoldedSolid, OfHolesOfAnySizeInABendIsSound) {
  for (double diameter : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.5}) {
    SCOPED_TRACE(diameter);
    expect_sound(hole_in_bend(diameter, 0.5), 1e-7);
    expect_sound(scaled(hole_in_bend(diameter, 0.5), 0.3), 1e-6);
  }
}

/// A bend of one cylinder in two faces, met along a border that runs across its rulings, at
/// another speed on either side when `spline`.
Sheet split_bend(BendDirection direction, bool spline) {
  const Turn turn{Angle::degrees(120), 10, direction};
  const Rim rim{Frame{}, 50, {}, {}};
  const Cylinder cylinder = cylinder_behind(rim, turn, 1.5);
  const int sense = direction == up ? -1 : 1;
  const double end = turn.angle.radians();
  const auto uv = [&](double azimuth, double y) { return Vec2(azimuth, sense < 0 ? 50 - y : y); };
  const Vec2 p = uv(0.5, 0), q = uv(1.4, 50);
  Curve2 back = Segment{q, p};
  if (spline) back = CubicSpline{{q, q + 0.1 * (p - q), q + 0.5 * (p - q), p}};

  SheetBuilder builder(1.5);
  const BendId id = builder.new_bend({BendKind::cylinder, {}, turn.angle, 10, sense < 0, {}});
  const FaceId first = builder.bend_face(
      id, cylinder, sense,
      {{Segment{uv(0, 50), uv(0, 0)}, Segment{uv(0, 0), p}, Segment{p, q}, Segment{q, uv(0, 50)}}});
  const FaceId second = builder.bend_face(
      id, cylinder, sense,
      {{back, Segment{p, uv(end, 0)}, Segment{uv(end, 0), uv(end, 50)}, Segment{uv(end, 50), q}}});
  builder.join({first, 0, 2}, {second, 0, 0});
  return builder.finish();
}

TEST(FoldedSolid, OfABendInSeveralFacesIsSound) {
  for (BendDirection direction : {up, down})
    for (bool spline : {false, true})
      EXPECT_EQ(expect_sound(split_bend(direction, spline), 1e-8).cylinders, 4);
}

TEST(FoldedSolid, MitresCornersThatAreNotSquare) {
  SheetBuilder builder(1.5);
  const FaceId base = builder.flange(Frame{}, {polygon({{0, 0}, {30, 5}, {35, 35}, {0, 40}})});
  const Rim rim = builder.crease(builder.rim(base, 1), {Angle::degrees(60), up});
  builder.flange_behind(rim, {polygon({{0, 0}, {rim.length, 0}, {rim.length + 6, 25}, {3, 20}})});
  const SolidCheck check = expect_sound(builder.finish(), 0.002);
  EXPECT_EQ(check.splines, 4) << "the walls beside the crease wind from one corner to the other";
}

TEST(FoldedSolid, OfGeneralDevelopablesAgreesWithCylindersAndCones) {
  for (const Sheet& sheet : {l_bracket(), l_bracket_down(), cone_joined(), hole_in_bend(5, 0.44),
                             truncated_cone(20, 40, 50, Angle::degrees(300), 1.5)}) {
    const SolidCheck check = expect_sound(as_ruled(sheet, Angle::degrees(2)), 1e-6);
    EXPECT_EQ(check.cylinders + check.cones, 0);
    EXPECT_LT(check.largest_tolerance, 5e-6);
  }
}

/// Valid and closed says `thicken`; the volume is measured from the borders, because that of
/// `SolidCheck` takes a minute here.
TEST(FoldedSolid, OfPlatesJoinedByObliqueConesHasTheirVolume) {
  LoftedCorner leaning;
  leaning.apex = {60, -10, 60};
  for (double near : {0.5, 0.25, 0.1}) {
    SCOPED_TRACE(near);
    leaning.near = near;
    for (const LoftedCorner& corner : {leaning, other_side(leaning)}) {
      const Sheet sheet = lofted_corner(corner);
      const auto text = folded_solid_step(sheet, "part");
      ASSERT_TRUE(text) << text.error().message;
      const auto file = read_step_text(*text, "part");
      ASSERT_TRUE(file) << file.error().message;
      ASSERT_EQ(file->bodies.size(), 1u);
      EXPECT_EQ(file->bodies[0].face_count(), 6 + 2 * 3 + 2);
      EXPECT_NEAR(file->bodies[0].volume() / *sheet.volume, 1.0, 1e-7);
    }
  }
}

TEST(FoldedSolid, OfRandomSheetsIsSoundWhereverTheyLie) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Sheet sheet = random_sheet(random, 1 + static_cast<int>(seed % 8));
    const Vec3 axis = Vec3(1, 2, 3).normalized();
    const Eigen::Isometry3d motion(Eigen::Translation3d(100, -50, 7) *
                                   Eigen::AngleAxisd(1.1 + seed, axis));
    expect_sound(scaled(moved(sheet, motion), seed % 2 == 0 ? 1.0 : 10.0));
  }
}

/// Every corner of every face moved by up to `size`, each face for itself.
Sheet roughened(Sheet sheet, double size) {
  std::mt19937 random(1);
  const auto noise = [&] { return size * (static_cast<double>(random()) / 4294967295.0 * 2 - 1); };
  for (Face& face : sheet.faces) {
    const auto* surface = std::get_if<Developable>(&face.surface);
    const double u_size = surface == nullptr ? 1.0 : 1.0 / std::get<Cylinder>(*surface).radius;
    for (BorderLoop& loop : face.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        auto* segment = std::get_if<Segment>(&loop[i].curve);
        if (segment == nullptr) continue;
        segment->b += Vec2(noise() * u_size, noise());
        auto* next = std::get_if<Segment>(&loop[(i + 1) % loop.size()].curve);
        if (next != nullptr) next->a = segment->b;
      }
  }
  return sheet;
}

TEST(FoldedSolid, HoldsTogetherWhereBordersMissEachOther) {
  for (double size : {1e-8, 1e-6, 1e-5, 1e-4, 1e-3}) {
    SCOPED_TRACE(size);
    for (const Sheet& sheet : {l_bracket(), box(), staircase(2)}) {
      const SolidCheck check = expect_sound(roughened(sheet, size), 10 * size);
      EXPECT_LT(check.largest_tolerance, 1e-6 + 10 * size);
    }
  }
}

TEST(FoldedSolid, IsTheSameTextEveryTime) {
  EXPECT_EQ(folded_solid_step(box(), "box").value(), folded_solid_step(box(), "box").value());
}

TEST(FoldedSolid, IsNamed) {
  EXPECT_EQ(folded(l_bracket(), "bracket 12-A").product, "bracket 12-A");
  EXPECT_NE(
      folded_solid_step(l_bracket(), "Träger 'links'")->find(R"('Tr\X2\00E4\X0\ger ''links''')"),
      std::string::npos)
      << "no name as STEP spells it";
}

TEST(FoldedSolid, IsAp214InMillimetres) {
  const std::string text = folded_solid_step(l_bracket(), "l").value();
  EXPECT_NE(text.find("AUTOMOTIVE_DESIGN"), std::string::npos);
  EXPECT_NE(text.find("SI_UNIT(.MILLI.,.METRE.)"), std::string::npos);
}

TEST(FoldedSolid, RefusesWhatHasNoSolid) {
  Sheet flat = plate_with_holes();
  flat.thickness = 0.0;
  EXPECT_EQ(code_of(flat), "invalid_input");

  Sheet twice = l_bracket();
  twice.joints.push_back(twice.joints[0]);
  EXPECT_EQ(code_of(twice), "invalid_input");
  Sheet missing = l_bracket();
  missing.joints[0].a.border = 17;
  EXPECT_EQ(code_of(missing), "invalid_input");

  EXPECT_EQ(
      code_of(strip({Straight{30}, Turn{Angle::degrees(90), 0.0, down}, Straight{20}}, 15, 1)),
      "unsupported_shape")
      << "an inside radius of zero";
  LoftedCorner pointed;
  pointed.near = 0.01;
  EXPECT_EQ(code_of(lofted_corner(other_side(pointed))), "unsupported_shape")
      << "an oblique cone thicker than its radius near the apex";
  EXPECT_EQ(code_of(strip({Straight{30}, Crease{Angle::degrees(175), up}, Straight{20}}, 15, 1)),
            "unsupported_shape")
      << "a mitre that runs away";
  EXPECT_EQ(code_of(strip(
                {Turn{Angle::degrees(90), 2.0, up}, Crease{Angle::degrees(60), up}, Straight{20}},
                15, 1)),
            "unsupported_shape")
      << "a circular border at a sharp bend";
}

}  // namespace
}  // namespace planish::test
