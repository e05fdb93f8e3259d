#include "sample_plates.hpp"

#include <planish/connect/codes.hpp>
#include <planish/connect/connect.hpp>
#include <planish/geometry/region.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;

Connection joined(const PlateStructure& structure, const ConnectOptions& options = {}) {
  auto connection = connect(structure, options);
  EXPECT_TRUE(connection) << (connection
                                  ? ""
                                  : connection.error().message + " at " + connection.error().where);
  return connection ? *connection : Connection{};
}

/// The bends that were found asked for again, after one plate was moved.
Result<Connection> rejoined(const Connection& previous, const Plate& moved) {
  PlateStructure structure = previous.structure;
  for (Plate& plate : structure.plates)
    if (plate.id == moved.id) plate = moved;
  structure.bends.clear();
  for (const FittedBend& bend : previous.bends)
    structure.bends.push_back(bend.request);
  return connect(structure);
}

FlatPattern flat(const Connection& connection, double k = 0.44) {
  auto pattern = flatten(connection.sheet,
                         {.allowance = ConstantK{k, "test"}, .root = connection.root});
  EXPECT_TRUE(pattern) << (pattern ? "" : pattern.error().message);
  return pattern ? *pattern : FlatPattern{};
}

/// Normals of the bend's mid-surface and of both plates agree along the tangent lines.
void expect_tangent(const Connection& connection) {
  for (const Joint& joint : connection.sheet.joints) {
    const Face& a = connection.sheet[joint.a.face];
    const Face& b = connection.sheet[joint.b.face];
    const Curve2& ca = a.loops[joint.a.loop][joint.a.border].curve;
    const Curve2& cb = b.loops[joint.b.loop][joint.b.border].curve;
    for (const double t : {0.0, 0.3, 1.0}) {
      EXPECT_LT((skin_point(a, point_at(ca, t)) - skin_point(b, point_at(cb, 1.0 - t))).norm(),
                1e-9);
      EXPECT_LT(
          (outward_normal(a, point_at(ca, t)) - outward_normal(b, point_at(cb, 1.0 - t))).norm(),
          1e-10);
    }
  }
}

TEST(Connect, JoinsTwoPlatesAtARightAngleByTheLargestCylinderThatFits) {
  const double gap = 14.0, t = 4.0;
  const Connection c = joined(angle_pair(gap));
  ASSERT_EQ(c.bends.size(), 1u);
  const FittedBend& bend = c.bends[0];
  EXPECT_EQ(bend.kind, BendKind::cylinder);
  EXPECT_EQ(bend.edge_kind, EdgeKind::facing);
  EXPECT_NEAR(bend.inside_radius, gap - t / 2, 1e-9);
  EXPECT_NEAR(bend.angle.degrees(), 90.0, 1e-9);
  EXPECT_NEAR(bend.width, 200.0, 1e-9);
  EXPECT_NEAR(bend.extension_area, 0.0, 1e-6);
  expect_tangent(c);
  const FlatPattern pattern = flat(c);
  const double across = 200.0 + pi / 2 * (gap - t / 2 + 0.44 * t);
  EXPECT_NEAR(blank_size(pattern).x(), across, 1e-9 * across);
  EXPECT_NEAR(pattern.area, 200.0 * across, 1e-9 * pattern.area);
  EXPECT_EQ(pattern.outer.loop.size(), 4u);
}

TEST(Connect, ExtendsThePlatesToAGivenRadius) {
  PlateStructure s = angle_pair(14.0);
  s.bends = {{.between = {"A", "B"}, .inside_radius = 5.0}};
  const Connection c = joined(s);
  ASSERT_EQ(c.bends.size(), 1u);
  EXPECT_NEAR(c.bends[0].inside_radius, 5.0, 1e-9);
  EXPECT_NEAR(c.bends[0].extension_area, 2 * 200.0 * (14.0 - 7.0), 1e-6);
  const FlatPattern pattern = flat(c);
  const double across = 200.0 + 14.0 + pi / 2 * (5.0 + 0.44 * 4.0);
  EXPECT_NEAR(pattern.area, 200.0 * across, 1e-9 * pattern.area);
}

TEST(Connect, RefusesARadiusThatWouldCutThePlatesAndSaysWhichFits) {
  PlateStructure s = angle_pair(14.0);
  s.bends = {{.between = {"A", "B"}, .inside_radius = 20.0}};
  const auto c = connect(s);
  ASSERT_FALSE(c);
  EXPECT_EQ(c.error().code, code::no_bend_fits);
  EXPECT_NE(c.error().message.find("12 mm or less"), std::string::npos) << c.error().message;
  EXPECT_EQ(c.error().where, "/bends/0/inside_radius");
}

TEST(Connect, NumbersBendsThatItFindsByTheirPlatesWhicheverAreNearer) {
  for (const double height : {124.0, 150.0}) {  // of the third plate: it is nearer, then farther
    PlateStructure s = angle_pair(14.0);
    s.plates.push_back(rectangle_plate("C", {0, 124, height}, {200, 0, 0}, {0, 100, 0}));
    const auto made = connect(s);
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ(made->bends.size(), 2u);
    EXPECT_EQ(made->bends[0].plates, (std::vector{0, 1})) << height;
    EXPECT_EQ(made->bends[1].plates, (std::vector{1, 2})) << height;
  }
}

TEST(Connect, JoinsATrayToOnePiece) {
  const double gap = 8.0, t = 3.0;
  const Connection c = joined(tray(gap, t));
  ASSERT_EQ(c.bends.size(), 4u);
  EXPECT_EQ(c.structure.plates[index_of(c.root)].id, "floor");
  for (const FittedBend& bend : c.bends)
    EXPECT_EQ(bend.plates[0], 0) << "every wall hangs on the floor";
  expect_tangent(c);
  const FlatPattern pattern = flat(c);
  const double allowance = pi / 2 * (gap - t / 2 + 0.44 * t);
  EXPECT_NEAR(pattern.area, 300 * 200 + 2 * (300 + 200) * (60 + allowance), 1e-6);
  EXPECT_EQ(pattern.bends.size(), 4u);
}

TEST(Connect, JoinsEdgesThatRunApartByAConeWithoutExtension) {
  const double k = 0.2, t = 3.0;
  const Connection c = joined(cone_pair(k, 200, 500, t));
  ASSERT_EQ(c.bends.size(), 1u);
  const FittedBend& bend = c.bends[0];
  EXPECT_EQ(bend.kind, BendKind::cone);
  EXPECT_NEAR(std::abs(bend.line.slope), k, 1e-9);
  EXPECT_NEAR(bend.extension_area, 0.0, 1e-6);
  ASSERT_TRUE(bend.apex);
  EXPECT_LT((bend.frame.origin + *bend.apex * bend.frame.d).norm(), 1e-6)
      << "the apex lies where the edges meet";
  // math.md#tangent-cone.
  const double phi = std::atan(k), omega = std::atan(std::sin(phi) * std::tan(pi / 4));
  ASSERT_TRUE(bend.half_angle);
  EXPECT_NEAR(bend.half_angle->radians(), omega, 1e-12);
  EXPECT_NEAR(bend.angle.degrees(), 90.0, 1e-9);
  expect_tangent(c);
  // The sector of the neutral surface, between the straight lines from corner to corner.
  const double theta = std::atan(std::tan(phi) / std::sin(omega)),
               sector = 2 * theta * std::sin(omega);
  const double shift = (0.44 - 0.5) * t / std::tan(omega);
  const auto triangle = [&](double x) {
    return 0.5 * std::pow(std::hypot(x, k * x) + shift, 2) * std::sin(sector);
  };
  const FlatPattern pattern = flat(c);
  const double plate = 300.0 * (300 - k * 350);
  EXPECT_NEAR(pattern.area, 2 * plate + triangle(500) - triangle(200), 1e-6 * pattern.area);
}

TEST(Connect, JoinsParallelPlatesByAHalfTurn) {
  const Connection c = joined(u_pair(40.0, 3.0));
  ASSERT_EQ(c.bends.size(), 1u);
  EXPECT_EQ(c.bends[0].kind, BendKind::cylinder);
  EXPECT_NEAR(c.bends[0].angle.degrees(), 180.0, 1e-9);
  EXPECT_NEAR(c.bends[0].inside_radius, 18.5, 1e-9);
  expect_tangent(c);
  const FlatPattern pattern = flat(c);
  EXPECT_NEAR(pattern.area, 200 * (180 + pi * (18.5 + 0.44 * 3)), 1e-6);
}

TEST(Connect, RollsAPipeOfItsOwn) {
  PlateStructure s;
  s.thickness = 2.0;
  s.bends = {{.inside_radius = 49.0, .angle = Angle::degrees(360), .length = 300.0}};
  const FlatPattern pattern = flat(joined(s), 0.5);
  EXPECT_NEAR(pattern.area, 300.0 * 2 * pi * 50.0, 1e-6);
}

TEST(Connect, RollsATruncatedConeOfItsOwn) {
  PlateStructure s;
  s.thickness = 2.0;
  s.bends = {
      {.inside_radii = std::array{60.0, 30.0}, .angle = Angle::degrees(300), .length = 100.0}};
  const FlatPattern pattern = flat(joined(s), 0.5);
  // Lateral area of the mid-surface frustum whose ends lie on the normals of the inner one.
  const double tangent = 30.0 / 100.0, cosine = 1 / std::hypot(1, tangent), slant = 100.0 / cosine;
  const double r0 = 60 + cosine, r1 = 30 + cosine;
  EXPECT_NEAR(pattern.area, Angle::degrees(300).radians() * 0.5 * (r0 + r1) * slant, 1e-6);
}

TEST(Connect, CurvesOnBehindAnEdge) {
  PlateStructure s;
  s.thickness = 2.0;
  s.plates = {rectangle_plate("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0})};
  s.bends = {{.between = {"A"},
              .edges = {std::vector{2}},
              .inside_radius = 30.0,
              .angle = Angle::degrees(180)}};
  const Connection c = joined(s);
  expect_tangent(c);
  EXPECT_NEAR(flat(c, 0.5).area, 200 * (100 + pi * 31.0), 1e-6);
  s.bends[0].inside_radius.reset();
  s.bends[0].inside_radii = std::array{20.0, 40.0};
  s.bends[0].angle = Angle::degrees(-90);
  const Connection cone = joined(s);
  ASSERT_EQ(cone.bends.size(), 1u);
  EXPECT_EQ(cone.bends[0].kind, BendKind::cone);
  expect_tangent(cone);
  // The sector between the distances of both ends from the apex.
  const double tangent = 20.0 / 200.0, sine = tangent / std::hypot(1, tangent);
  const double s0 = 21 / tangent, s1 = 41 / tangent;
  EXPECT_NEAR(flat(cone, 0.5).area, 200 * 100 + 0.5 * (s1 * s1 - s0 * s0) * (pi / 2) * sine, 1e-6);
}

TEST(Connect, LoftsAnObliqueConeToARoundOpening) {
  const Connection c = joined(lofted());
  ASSERT_EQ(c.bends.size(), 1u);
  EXPECT_EQ(c.bends[0].kind, BendKind::general);
  EXPECT_NEAR(c.bends[0].extension_area, 0.0, 1e-6);
  expect_tangent(c);
  // The outer end is the quarter circle about the pipe's axis, on the mid-surface.
  const Face& bend = c.sheet.faces.back();
  const double half = 0.5 * c.sheet.thickness;
  for (const double u : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const Vec3 p = skin_point(bend, {u, 0.0}) - half * outward_normal(bend, {u, 0.0});
    EXPECT_NEAR(p.z(), 300.0, 1e-6);
    EXPECT_NEAR(p.head<2>().norm(), 120.0, 1e-6);
  }
  // Area of the mid-surface between both ends, by math.md#general-cone over the circle.
  double area = 0.0;
  constexpr int kParts = 20000;
  const Vec3 apex(200, 200, 0);
  for (int i = 0; i < kParts; ++i) {
    const double a = pi / 2 * (i + 0.5) / kParts;
    const Vec3 arm = Vec3(120 * std::cos(a), 120 * std::sin(a), 300) - apex;
    const Vec3 step = pi / 2 / kParts * Vec3(-120 * std::sin(a), 120 * std::cos(a), 0);
    area += 0.5 * arm.cross(step).norm() * (1 - 0.12 * 0.12);
  }
  double plates = 0.0;
  for (const Plate& plate : c.structure.plates) {
    Vec3 twice = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < plate.outline.size(); ++i)
      twice += (plate.outline[i] - plate.outline[0]).cross(plate.outline[i + 1] - plate.outline[0]);
    plates += 0.5 * twice.norm();
  }
  EXPECT_NEAR(flat(c, 0.5).area, plates + area, 1e-7 * (plates + area));
}

TEST(Connect, DoesNotDependOnPlaceHandScaleOrOrder) {
  for (const PlateStructure& s : {angle_pair(14.0), tray(), cone_pair(), u_pair()}) {
    const double area = flat(joined(s)).area;
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.rotate(Eigen::AngleAxisd(0.8, Vec3(1, 2, -3).normalized()))
        .pretranslate(Vec3(4000, -300, 50));
    EXPECT_NEAR(flat(joined(moved(s, motion))).area, area, 1e-8 * area);
    EXPECT_NEAR(flat(joined(mirrored(s))).area, area, 1e-9 * area);
    EXPECT_NEAR(flat(joined(scaled(s, 10.0))).area, 100 * area, 1e-7 * area);
    PlateStructure turned = s;
    std::ranges::reverse(turned.plates);
    for (Plate& plate : turned.plates)
      std::rotate(plate.outline.begin(), plate.outline.begin() + 1, plate.outline.end());
    EXPECT_NEAR(flat(joined(turned)).area, area, 1e-9 * area);
    for (Plate& plate : turned.plates)
      std::ranges::reverse(plate.outline);
    EXPECT_NEAR(flat(joined(turned)).area, area, 1e-9 * area);
  }
}

TEST(Connect, FollowsAPlateThatIsMoved) {
  PlateStructure s = tray();
  const Connection before = joined(s);
  for (Vec3& p : s.plates[1].outline)
    p += Vec3(0, -5, 5);
  const auto after = rejoined(before, s.plates[1]);
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->bends.size(), before.bends.size());
  EXPECT_NEAR(flat(*after).area, flat(joined(s)).area, 1e-6);
}

TEST(Connect, KeepsWhatWasGivenWhenAPlateIsMoved) {
  PlateStructure s = angle_pair(14.0);
  s.bends = {{.between = {"A", "B"},
              .edges = {std::vector{2}, std::vector{0}},
              .inside_radius = 5.0,
              .lateral = LateralBoundary::arc}};
  const Connection before = joined(s);
  for (Vec3& p : s.plates[1].outline)
    p += Vec3(30, 2, 1);
  const auto after = rejoined(before, s.plates[1]);
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_NEAR(after->bends[0].inside_radius, 5.0, 1e-9);
  EXPECT_EQ(after->bends[0].lateral, LateralBoundary::arc);
  EXPECT_EQ(after->bends[0].edges[0], std::vector{2});
  const auto back = rejoined(*after, before.structure.plates[1]);
  ASSERT_TRUE(back);
  EXPECT_NEAR(flat(*back).area, flat(before).area, 1e-9);
}

// The nearest plates are joined first; those that are joined stay so when others come nearer.
TEST(Connect, JoinsTheSamePlatesWhenOneIsMoved) {
  PlateStructure s = tray();
  const Connection before = joined(s);
  for (Vec3& p : s.plates[4].outline)
    p += Vec3(30, 0, 30);
  const auto after = rejoined(before, s.plates[4]);
  ASSERT_TRUE(after) << after.error().message;
  for (std::size_t b = 0; b < before.bends.size(); ++b) {
    EXPECT_EQ(after->bends[b].plates, before.bends[b].plates);
    if (before.bends[b].request.between[0] == "right" ||
        before.bends[b].request.between[1] == "right")
      continue;
    EXPECT_EQ(after->bends[b].inside_radius, before.bends[b].inside_radius);
    EXPECT_EQ(after->bends[b].edges, before.bends[b].edges);
  }
}

TEST(Connect, SaysWhyAMovedPlateCannotBeFollowed) {
  PlateStructure s = angle_pair(14.0);
  const Connection before = joined(s);
  for (Vec3& p : s.plates[1].outline)
    p = Vec3(p.x(), p.y() - 60, p.z() - 60);
  EXPECT_EQ(rejoined(before, s.plates[1]).error().code, code::plates_intersect);
}

TEST(Connect, MakesAConeOfASlopeAndARadius) {
  PlateStructure s = cone_pair();
  s.bends = {{.between = {"A", "B"}, .inside_radius = 40.0, .slope = 0.1}};
  const Connection c = joined(s);
  ASSERT_EQ(c.bends.size(), 1u);
  EXPECT_EQ(c.bends[0].kind, BendKind::cone);
  EXPECT_NEAR(c.bends[0].line.slope, 0.1, 1e-12);
  // At mid-length the tangent line is as far from the intersection line as the radius of the
  // mid-surface.
  EXPECT_NEAR(c.bends[0].line.at(c.bends[0].frame.local(0, {350, 0, 0}).x()), 41.5, 1e-9);
}

TEST(Connect, OpensTheSeamOfAFullTurnForASolid) {
  PlateStructure pipe;
  pipe.thickness = 2.0;
  pipe.bends = {{.inside_radius = 50.0, .angle = Angle::degrees(360), .length = 200.0}};
  const Connection c = joined(pipe);
  EXPECT_NEAR(flat(c, 0.5).area, 2 * pi * 51 * 200, 1e-6);
  const Sheet open = with_open_seam(c.sheet);
  double widest = 0.0;
  for (const Border& border : open.faces.front().loops[0])
    widest = std::max({widest, start_of(border.curve).x(), end_of(border.curve).x()});
  EXPECT_LT(widest, 2 * pi - 0.5 * 0.01 / 51);
  EXPECT_GT(widest, 2 * pi - 2.0 * 0.01 / 51);
  EXPECT_EQ(with_open_seam(open).faces.front().loops[0][0].edge_length,
            open.faces.front().loops[0][0].edge_length);
}

}  // namespace
}  // namespace planish::test
