#include "support/sheets.hpp"
#include "support/trihedron.hpp"

#include <planish/geometry/region.hpp>
#include <planish/sheet/certificate.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/rip.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using std::numbers::pi;
constexpr double kK = 0.44;

FlatPattern flat(const Sheet& sheet, double k = kK) {
  auto pattern = flatten(sheet, {.allowance = ConstantK{k, "test"}});
  EXPECT_TRUE(pattern.has_value()) << (pattern ? "" : pattern.error().message);
  return pattern.value_or(FlatPattern{});
}

Vec2 size_of(const FlatPattern& pattern) { return bounds(pattern.outer.loop).size(); }

void expect_strip(const std::vector<StripPart>& parts, double width, double thickness) {
  const FlatPattern pattern = flat(strip(parts, width, thickness));
  const double expected = flat_length(parts, thickness, kK);
  EXPECT_NEAR(pattern.area, expected * width, 1e-9 * expected * width);
  const Vec2 size = size_of(pattern);
  EXPECT_NEAR(std::max(size.x(), size.y()), std::max(expected, width), 1e-9 * expected);
  EXPECT_NEAR(std::min(size.x(), size.y()), std::min(expected, width), 1e-9 * expected);
  EXPECT_NEAR(pattern.perimeter, 2 * (expected + width), 1e-9 * expected);
  EXPECT_EQ(pattern.outer.loop.size(), 4u)
      << "collinear sides of flanges and bends must be one line";
}

TEST(FlattenStrip, HasTheClosedFormLengthForAnyTurnUpOrDown) {
  for (const double degrees : {1.0, 45.0, 90.0, 135.0, 180.0, 250.0})
    for (const BendDirection direction : {BendDirection::up, BendDirection::down})
      expect_strip({Straight{50}, Turn{Angle::degrees(degrees), 3.0, direction}, Straight{30}},
                   40.0, 2.0);
}

TEST(FlattenStrip, TakesTheKOfSingleBendsBeforeTheRule) {
  const double radius = 3.0, thickness = 2.0;
  const std::vector<StripPart> parts{
      Straight{50}, Turn{Angle::degrees(90), radius, BendDirection::up}, Straight{30},
      Turn{Angle::degrees(60), radius, BendDirection::down}, Straight{20}};
  const Sheet sheet = strip(parts, 40.0, thickness);
  const auto pattern = flatten(sheet,
                               {.allowance = ConstantK{kK, "test"}, .bend_k = {{BendId{1}, 0.3}}});
  ASSERT_TRUE(pattern.has_value());
  const double expected = 100.0 + pi / 2 * (radius + kK * thickness) +
                          pi / 3 * (radius + 0.3 * thickness);
  EXPECT_NEAR(pattern->area, 40.0 * expected, 1e-9 * expected);
  EXPECT_EQ(pattern->bends[1].allowance.k_factor, 0.3);
  const auto refused = flatten(sheet, {.bend_k = {{BendId{0}, 1.5}}});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, code::bad_option);
}

TEST(FlattenStrip, HasTheClosedFormLengthForTwoBendsOf270Degrees) {
  const Turn turn{Angle::degrees(270), 6.0, BendDirection::up};
  expect_strip({Straight{60}, turn, Straight{8}, turn, Straight{4}}, 25.0, 1.0);
}

TEST(FlattenStrip, UnrollsPartsWithoutAnyFlange) {
  expect_strip({Turn{Angle::degrees(340), 12.0, BendDirection::up}}, 30.0, 1.0);
}

TEST(FlattenStrip, SetsSharpCornersBackOnTheOutsideAndSpacesThemOnTheInside) {
  for (const BendDirection direction : {BendDirection::up, BendDirection::down})
    expect_strip({Straight{50}, Crease{Angle::degrees(90), direction}, Straight{30},
                  Crease{Angle::degrees(60), BendDirection::up}, Straight{20}},
                 40.0, 2.0);
}

TEST(FlattenStaircase, KeepsTheClosedFormUpToAThousandFlanges) {
  for (const int steps : {5, 50, 500}) {
    const FlatPattern pattern = flat(staircase(steps));
    const double allowance = pi / 2 * (1.0 + kK * 1.0);
    const double expected = 20.0 * (2 * steps + 1) + 2 * steps * allowance;
    EXPECT_NEAR(pattern.area, expected * 30.0, 1e-9 * expected * 30.0);
    EXPECT_NEAR(size_of(pattern).x(), expected, 1e-9 * expected);
    EXPECT_EQ(pattern.bends.size(), static_cast<size_t>(2 * steps));
  }
}

TEST(FlattenCone, IsTwoRectanglesAndASector) {
  const ConeJoint joint;
  const FlatPattern pattern = flat(cone_joined(joint), 0.5);
  // Radii of the sector on the neutral surface: the apex of the offset cone lies further back.
  const double w = joint.turn.half_angle.radians();
  const double shift = joint.thickness / 2 / std::tan(w);
  const double near = joint.turn.near_distance + shift;
  const double far = near + joint.width;
  const double sector = joint.turn.azimuth.radians() * std::sin(w) / 2 * (far * far - near * near);
  const double expected = joint.width * (joint.first + joint.second) + sector;
  EXPECT_NEAR(pattern.area, expected, 1e-7 * expected);
}

TEST(FlattenCone, RollsOutAFrustumToAnAnnularSector) {
  const double r1 = 30.0, r2 = 50.0, height = 40.0, t = 1.5;
  const Angle sweep = Angle::degrees(300);
  const FlatPattern pattern = flat(truncated_cone(r1, r2, height, sweep, t), 0.5);
  const double w = std::atan2(r2 - r1, height);
  const double shift = -t / 2 / std::tan(w);
  const double a = r1 / std::sin(w) + shift;
  const double b = r2 / std::sin(w) + shift;
  const double expected = sweep.radians() * std::sin(w) / 2 * (b * b - a * a);
  EXPECT_NEAR(pattern.area, expected, 1e-9 * expected);
  EXPECT_EQ(pattern.outer.loop.size(), 4u);
}

TEST(FlattenOpenings, KeepCirclesAsFullCircles) {
  const FlatPattern pattern = flat(plate_with_holes());
  ASSERT_EQ(pattern.openings.size(), 3u);
  int circles = 0;
  for (const Contour& opening : pattern.openings)
    if (opening.loop.size() == 1)
      if (const auto* arc = std::get_if<Arc>(&opening.loop.front()))
        circles += std::abs(std::abs(arc->sweep) - 2 * pi) < 1e-12;
  EXPECT_EQ(circles, 2);
}

TEST(FlattenOpenings, AcrossABendAreRoundWhenMadeRound) {
  for (const double diameter : {6.0, 30.0}) {
    const Sheet sheet = diameter < 10.0 ? hole_in_bend(diameter, kK)
                                        : hole_across_bend(diameter, kK);
    const FlatPattern pattern = flat(sheet);
    ASSERT_EQ(pattern.openings.size(), 1u);
    EXPECT_NEAR(-signed_area(pattern.openings.front().loop), pi * diameter * diameter / 4,
                1e-4 * diameter * diameter);
    EXPECT_EQ(pattern.bends.front().lines.size(), 2u) << "the bend line stops at the hole";
  }
}

TEST(FlattenOpenings, InterruptABendWithoutMakingALoop) {
  for (const Sheet& sheet : {slot_across_bend(), slot_into_bend()}) {
    const FlatPattern pattern = flat(sheet);
    EXPECT_LT(pattern.closure, 1e-9);
    EXPECT_EQ(pattern.bends.size(), 1u);
  }
}

TEST(FlattenBox, HasFourBendLinesAsLongAsTheWalls) {
  const FlatPattern pattern = flat(box());
  ASSERT_EQ(pattern.bends.size(), 4u);
  for (const FlatBend& bend : pattern.bends)
    EXPECT_EQ(bend.direction, BendDirection::up);
}

TEST(FlattenUpSide, MirrorsThePatternAndTurnsTheBendsRound) {
  const Sheet sheet = z_profile();
  const auto up = flatten(sheet, {.up = UpSide::reference});
  const auto down = flatten(sheet, {.up = UpSide::other});
  ASSERT_TRUE(up && down);
  EXPECT_NEAR(up->area, down->area, 1e-9);
  for (size_t i = 0; i < up->bends.size(); ++i)
    EXPECT_NE(up->bends[i].direction, down->bends[i].direction);
  EXPECT_GT(signed_area(down->outer.loop), 0.0);
}

TEST(FlattenUpSide, AutomaticPutsMostBendsUp) {
  const auto pattern = flatten(l_bracket_down());
  ASSERT_TRUE(pattern);
  EXPECT_EQ(pattern->bends.front().direction, BendDirection::up);
}

TEST(FlattenRoot, DoesNotChangeThePattern) {
  const Sheet sheet = u_channel();
  const double area = flat(sheet).area;
  for (int f = 0; f < static_cast<int>(sheet.faces.size()); ++f) {
    const auto pattern = flatten(sheet, {.allowance = ConstantK{kK, "test"}, .root = FaceId{f}});
    ASSERT_TRUE(pattern);
    EXPECT_NEAR(pattern->area, area, 1e-9 * area);
    EXPECT_NEAR(size_of(*pattern).x(), size_of(flat(sheet)).x(), 1e-9);
  }
}

/// A channel whose free ends are joined: a tube.
Sheet closed_channel() {
  Sheet sheet = u_channel();
  const auto last = static_cast<FaceId>(sheet.faces.size() - 1);
  Joint joint;
  joint.a = {FaceId{0}, 0, 3};
  joint.b = {last, 0, 2};
  sheet.joints.push_back(joint);
  return sheet;
}

TEST(FlattenLoop, IsRefusedWhereItDoesNotClose) {
  const auto pattern = flatten(closed_channel());
  ASSERT_FALSE(pattern);
  EXPECT_EQ(pattern.error().code, code::closed_loop);
  EXPECT_EQ(pattern.error().where, "between face 0 and face 1");
  EXPECT_EQ(pattern.error().places.size(), 2u);
  ASSERT_EQ(pattern.error().numbers.size(), 1u);
  EXPECT_GT(pattern.error().numbers[0].quantity.value, 0.01);
  EXPECT_EQ(pattern.error().numbers[0].quantity.unit, unit::mm);
}

TEST(FlattenLoop, IsOpenedByOneRip) {
  Sheet sheet = closed_channel();
  const auto lies_flat = [](const Sheet& open) -> Result<void> {
    const auto flat = flatten(open);
    return flat ? Result<void>{} : tl::unexpected(flat.error());
  };
  const auto closed = flatten(sheet).error();
  for (const Joint& joint : sheet.joints)
    sheet[joint.a].edge.reset();
  // Without an edge in a solid there is nothing to name.
  EXPECT_EQ(rips_to_open(sheet, {}, lies_flat).error().code, code::closed_loop);
  const Error none = loop_refusal(sheet, closed, {}, lies_flat);
  EXPECT_TRUE(none.message.ends_with(" No rips along its edges open it.")) << none.message;
  EXPECT_TRUE(none.remedies.empty());
  EXPECT_EQ(none.places, closed.places);
  EXPECT_EQ(none.where, closed.where);
  for (int j = 0; j < std::ssize(sheet.joints); ++j)
    sheet[sheet.joints[j].a].edge = 100 + j;
  const auto rips = rips_to_open(sheet, {}, lies_flat);
  ASSERT_TRUE(rips) << rips.error().message;
  ASSERT_EQ(rips->size(), 1u);
  const auto open = ripped(sheet, *rips);
  ASSERT_TRUE(open);
  EXPECT_NEAR(flatten(*open)->area, flatten(u_channel())->area, 1e-9);
  const Error named = loop_refusal(sheet, closed, {}, lies_flat);
  EXPECT_TRUE(named.message.starts_with(closed.message)) << named.message;
  const std::string rip = "Rip edge " + std::to_string(rips->front()) + " to open it.";
  EXPECT_TRUE(named.message.ends_with(" " + rip)) << named.message;
  ASSERT_EQ(named.places.size(), 1u);
  EXPECT_EQ(named.places[0].kind, PlaceKind::edge);
  EXPECT_EQ(named.places[0].id, Place::Id(rips->front()));
  ASSERT_EQ(named.remedies.size(), 1u);
  EXPECT_EQ(named.remedies[0].option, "rip_edges");
  EXPECT_EQ(named.remedies[0].value, std::to_string(rips->front()));
  EXPECT_EQ(named.remedies[0].change, rip);
  // The place of the edge is its middle.
  const Joint& joint = sheet.joints[rips->front() - 100];
  const Curve2& border = sheet[joint.a].curve;
  const Vec3 a = skin_point(sheet[joint.a.face], start_of(border)),
             b = skin_point(sheet[joint.a.face], end_of(border));
  ASSERT_EQ(named.places[0].at.size(), 3u);
  EXPECT_LT((0.5 * (a + b) - Vec3(named.places[0].at.data())).norm(), 1e-9);
  EXPECT_EQ(named.where.find("edge " + std::to_string(rips->front()) + " between face"), 0u);
  // What refuses the sheet after the rips is the reason.
  const auto thick = [](const Sheet&) -> Result<void> {
    return fail(code::radius_too_small, "too thick");
  };
  EXPECT_EQ(loop_refusal(sheet, closed, {}, thick).message, "too thick");
}

TEST(FlattenFormedFeature, IsDrawnAndNotCut) {
  Sheet sheet = plate_with_holes();
  const double plain = flat(sheet).area;
  sheet.features.push_back({"formed", FormSide::up, FaceId{0}, {}, {}, {}});
  for (Border& border : sheet.faces.front().loops[1])
    border.feature = FeatureId{0};
  const FlatPattern pattern = flat(sheet);
  EXPECT_NEAR(pattern.area, plain + pi * 25.0, 1e-9 * plain);
  EXPECT_EQ(pattern.openings.size(), 2u);
  ASSERT_EQ(pattern.features.size(), 1u);
  EXPECT_EQ(pattern.features.front().outlines.size(), 1u);
}

/// A free edge that was read in pieces is cut in one line as far as it is straight.
TEST(FlattenFormedFeature, CutsAStraightSlitAsOneLine) {
  Sheet sheet = plate_with_holes();
  FormedFeature louvre{"formed", FormSide::up, FaceId{0}, {}, {}, {}};
  louvre.slits = {{{Segment{{1, 2}, {1.3, 2}}},
                   {Segment{{1.3, 2}, {4, 2}}},
                   {Segment{{4, 2}, {5, 2 + 1e-8}}},
                   {Segment{{5, 2 + 1e-8}, {5, 4}}}},
                  {{Segment{{6, 2}, {7, 2}}}, {Segment{{7, 2}, {6.5, 2}}}}};
  sheet.features.push_back(louvre);
  const FlatPattern pattern = flat(sheet);
  ASSERT_EQ(pattern.slits.size(), 4u) << "a corner, and one that goes back";
  EXPECT_NEAR(length(pattern.slits[0]), 4.0, 1e-9);
  EXPECT_NEAR(length(pattern.slits[1]), 2.0, 1e-7);
}

TEST(FlattenFormedFeature, IsOnTheOtherSideOnceTheSheetIsTurnedOver) {
  Sheet sheet = plate_with_holes();
  for (const FormSide side : {FormSide::up, FormSide::down, FormSide::both})
    sheet.features.push_back({"formed", side, FaceId{0}, {}, {}, {}});
  const auto seen = [&](UpSide up) {
    std::vector<FormSide> sides;
    const auto pattern = flatten(sheet, {.up = up});
    for (const FlatFeature& feature : pattern->features)
      sides.push_back(feature.side);
    return sides;
  };
  EXPECT_EQ(seen(UpSide::reference), (std::vector{FormSide::up, FormSide::down, FormSide::both}));
  EXPECT_EQ(seen(UpSide::other), (std::vector{FormSide::down, FormSide::up, FormSide::both}));
}

TEST(FlattenMetamorphic, MovingChangesNothingAndScalingScales) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized())).pretranslate(Vec3(100, -50, 7));
  for (const Sheet& sheet : {z_profile(), cone_joined(), box(), hole_across_bend(30.0, kK)}) {
    const FlatPattern plain = flat(sheet);
    EXPECT_NEAR(flat(moved(sheet, motion)).area, plain.area, 1e-8 * plain.area);
    EXPECT_NEAR(flat(scaled(sheet, 10.0)).area, 100 * plain.area, 1e-6 * 100 * plain.area);
  }
}

TEST(BorderTrihedra, BothFormsOfTheUnfoldingMotionAgreeWithThePlacement) {
  for (const double degrees : {30.0, 90.0, 200.0})
    for (const BendDirection direction : {BendDirection::up, BendDirection::down}) {
      const Sheet sheet = strip(
          {Straight{50}, Turn{Angle::degrees(degrees), 3.0, direction}, Straight{30}}, 40.0, 2.0);
      const double sign = direction == BendDirection::up ? 1.0 : -1.0;
      const double allowance = Angle::degrees(degrees).radians() * (3.0 + kK * 2.0);
      // The flanges' own borders at the bend: joints run flange–bend and bend–flange.
      const auto flange_side = [&](const Joint& joint) {
        const bool a_flat = std::holds_alternative<Frame>(sheet[joint.a.face].surface);
        return a_flat ? joint.a : joint.b;
      };
      const Frame parent = border_trihedron(sheet, flange_side(sheet.joints.front()));
      const Frame child = border_trihedron(sheet, flange_side(sheet.joints.back()));
      const auto steps = unfolding_by_steps(
          parent, child, Angle::radians(sign * Angle::degrees(degrees).radians()), allowance);
      const auto trihedra = unfolding_by_trihedra(parent, child, 40.0, allowance);
      EXPECT_LT((steps.matrix() - trihedra.matrix()).cwiseAbs().maxCoeff(), 1e-12) << degrees;
      const auto flat = flat_sheet(sheet,
                                   {.allowance = ConstantK{kK, "test"}, .up = UpSide::reference});
      ASSERT_TRUE(flat);
      // Distances in the pattern are distances after T: both far corners of the child flange.
      const FaceId far_id = sheet.flanges.back().faces.front();
      const FaceId near_id = sheet.flanges.front().faces.front();
      const Face &far = sheet[far_id], &near = sheet[near_id];
      for (const Border& border : far.loops.front()) {
        const Vec2 uv = start_of(border.curve);
        const Vec3 unfolded = trihedra * skin_point(far, uv);
        const Vec2 in_pattern = flat->layout.placement[far_id] * uv;
        const Vec2 origin = flat->layout.placement[near_id] * Vec2(0, 0);
        EXPECT_NEAR((unfolded - skin_point(near, Vec2(0, 0))).norm(), (in_pattern - origin).norm(),
                    1e-10);
        EXPECT_NEAR(std::get<Frame>(near.surface).local(unfolded).z(), 0.0, 1e-10);
      }
    }
}

TEST(CertificateOfAStrip, HasTheVolumeLengthsAndRefoldOfItsSolid) {
  for (const Sheet& sheet :
       {l_bracket(), u_channel(), z_profile(), box(), cone_joined(), plate_with_holes(),
        hole_across_bend(30.0, kK), truncated_cone(30, 50, 40, Angle::degrees(300), 1.5)}) {
    const FlattenOptions options{.allowance = ConstantK{kK, "test"}};
    const auto pattern = flatten(sheet, options);
    ASSERT_TRUE(pattern);
    const auto certificate = certify(sheet, *pattern, edge_distance(sheet));
    ASSERT_TRUE(certificate);
    EXPECT_NEAR(*certificate->volume_ratio, 1.0, 1e-6);
    EXPECT_LT(certificate->length_error, 1e-5);
    EXPECT_LT(*certificate->refold_deviation, 1e-3);
  }
}

TEST(CertificateOfAStrip, NoticesAWrongContour) {
  const Sheet sheet = l_bracket();
  auto pattern = flatten(sheet);
  ASSERT_TRUE(pattern);
  for (Curve2& curve : pattern->outer.loop)
    if (auto* line = std::get_if<Segment>(&curve)) line->a.x() += 0.5, line->b.x() += 0.5;
  const auto certificate = certify(sheet, *pattern, edge_distance(sheet));
  ASSERT_TRUE(certificate);
  EXPECT_GT(*certificate->refold_deviation, 0.4);
}

TEST(CertificateOfAStrip, NoticesAWrongThicknessByTheVolume) {
  Sheet sheet = l_bracket();
  *sheet.volume *= 1.01;
  const auto pattern = flatten(sheet);
  ASSERT_TRUE(pattern);
  const auto certificate = certify(sheet, *pattern, edge_distance(sheet));
  ASSERT_TRUE(certificate);
  EXPECT_NEAR(*certificate->volume_ratio, 1 / 1.01, 1e-6);
}

TEST(FlattenAlign, LaysTheLongestBendLineAlongXWhicheverComesFirst) {
  // A triangle with low flanges on two sides of 60 and 70, at 50° to each other.
  for (const double first : {60.0, 70.0}) {
    const Vec2 tip = (130.0 - first) * Vec2(std::cos(50 * pi / 180), std::sin(50 * pi / 180));
    SheetBuilder builder(1.0);
    const FaceId base = builder.flange(Frame{}, {polygon({{0, 0}, {first, 0}, tip})});
    for (const int side : {0, 2}) {
      const Rim far = builder.bend(builder.rim(base, side), Turn{Angle::degrees(90), 1.0});
      builder.flange_behind(far, {rectangle(far.length, 5)});
    }
    const FlatPattern pattern = flat(builder.finish());
    ASSERT_EQ(pattern.bends.size(), 2u);
    for (const FlatBend& bend : pattern.bends) {
      const Vec2 along = bend.lines.at(0).b - bend.lines.at(0).a;
      EXPECT_EQ(std::abs(along.y()) < 1e-9, along.norm() > 65.0) << first;
    }
    EXPECT_LT(bounds(pattern.outer.loop).lo.norm(), 1e-9);
  }
}

}  // namespace
}  // namespace planish::test
