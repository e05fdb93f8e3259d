#include "support/sheets.hpp"

#include <planish/brake/check_dimensions.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish {
namespace {

using namespace planish::test;

constexpr double kExact = 1e-9;

/// A sheet, laid flat.
struct Laid {
  Sheet sheet;
  FlatPattern flat;
  Layout layout;
};

Laid laid(const Sheet& sheet) {
  FlatSheet flat = *flat_sheet(sheet);
  return {sheet, std::move(flat.pattern), std::move(flat.layout)};
}

std::vector<std::optional<CheckDimension>> checks_of(const Laid& part,
                                                     const std::vector<Stroke>& strokes) {
  return check_dimensions(part.sheet, part.layout, part.flat, strokes);
}

Stroke stroke_of(const Laid& part, int bend) {
  Stroke stroke;
  stroke.bends = {BendId{bend}};
  stroke.angle = part.sheet[BendId{bend}].angle;
  stroke.radius_made = part.sheet[BendId{bend}].inside_radius;
  return stroke;
}

/// What is measured after each stroke; 0: nothing.
std::vector<double> measured(const Laid& part, const std::vector<int>& order) {
  std::vector<Stroke> strokes;
  for (const int bend : order)
    strokes.push_back(stroke_of(part, bend));
  std::vector<double> lengths;
  for (const auto& check : checks_of(part, strokes))
    lengths.push_back(check ? check->length : 0.0);
  return lengths;
}

void expect_measured(const Laid& part, const std::vector<int>& order,
                     const std::vector<double>& expected) {
  const auto lengths = measured(part, order);
  ASSERT_EQ(lengths.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(lengths[i], expected[i], kExact) << i;
}

/// The sides of the box around a bent sheet, both skins.
Vec3 solid_size(const Sheet& sheet) {
  Eigen::AlignedBox3d box;
  for (const Face& face : sheet.faces)
    for (const BorderLoop& loop : face.loops)
      for (const Border& border : loop)
        for (int i = 0; i <= 64; ++i) {
          const Vec2 uv = point_at(border.curve, i / 64.0);
          const Vec3 skin = skin_point(face, uv);
          box.extend(skin);
          box.extend(skin - sheet.thickness * outward_normal(face, uv));
        }
  return box.sizes();
}

TEST(CheckDimensions, AreTheShorterLegOfAnAngle) {
  // 30 from the tangent line, and R + T = 3 + 2 to the outside.
  for (const Sheet& sheet : {l_bracket(), l_bracket_down()}) {
    const Laid part = laid(sheet);
    expect_measured(part, {0}, {35.0});
    EXPECT_NEAR(solid_size(sheet).z(), 35.0, kExact) << "as the solid is high";
    const auto check = checks_of(part, std::vector{stroke_of(part, 0)}).front();
    EXPECT_EQ(check->flange, FlangeId{1});
  }
}

TEST(CheckDimensions, EndAtTheMouldLineUpToARightAngleAndAtTheOutsideBeyond) {
  for (const double degrees : {30.0, 60.0, 89.0, 90.0, 120.0, 150.0}) {
    const Laid part = laid(
        strip({Straight{50}, Turn{Angle::degrees(degrees), 3.0}, Straight{30}}, 40, 2));
    const double beyond = degrees < 90.0 ? std::tan(Angle::degrees(0.5 * degrees).radians()) : 1.0;
    expect_measured(part, {0}, {30.0 + 5.0 * beyond});
  }
}

TEST(CheckDimensions, RunToTheOutsideOfTheNextBend) {
  // Z: 30 | 20 | 30, R + T = 2. A leg first; then the web is shorter than the other leg.
  const Sheet z = z_profile();
  for (const std::vector<int>& order : {std::vector{0, 1}, std::vector{1, 0}})
    expect_measured(laid(z), order, {32.0, 24.0});
  EXPECT_NEAR(solid_size(z).z(), 24.0, kExact) << "from outside to outside";
  // U: legs of 30 and R + T = 3.5 beside a web of 40.
  const Sheet u = u_channel();
  for (const std::vector<int>& order : {std::vector{0, 1}, std::vector{1, 0}})
    expect_measured(laid(u), order, {33.5, 33.5});
  EXPECT_NEAR(solid_size(u).x(), 33.5, kExact) << "the first leg lies along x";
}

TEST(CheckDimensions, KeepFlatWhatIsNotBentYet) {
  // A hat of 15 | 25 | 50 | 25 | 15 in t 1, r 1: brims, then walls; or the walls first.
  const Turn up{Angle::degrees(90), 1.0}, down{Angle::degrees(90), 1.0, BendDirection::down};
  const Sheet hat = strip(
      {Straight{15}, down, Straight{25}, up, Straight{50}, up, Straight{25}, down, Straight{15}},
      20, 1);
  const Laid part = laid(hat);
  expect_measured(part, {0, 3, 1, 2}, {17.0, 17.0, 29.0, 29.0});
  const double allowance = part.flat.bends[0].allowance.allowance;
  const double wall_and_brim = 25.0 + allowance + 15.0 + 2.0;
  expect_measured(part, {1, 2, 0, 3}, {wall_and_brim, wall_and_brim, 17.0, 17.0});
}

TEST(CheckDimensions, AreMeasuredOnceAHemIsClosed) {
  // 40 | 180° r 0.5 | 15, t 1.
  const Laid part = laid(hem());
  Stroke first = stroke_of(part, 0), second = first;
  first.angle = Angle::degrees(150);
  second.angle = Angle::degrees(30);
  second.flattening = true;
  const auto checks = checks_of(part, std::vector{first, second});
  EXPECT_FALSE(checks[0]) << "half bent";
  ASSERT_TRUE(checks[1]);
  EXPECT_NEAR(checks[1]->length, 16.5, kExact);
}

TEST(CheckDimensions, OfAFoldAreThoseOfItsSkins) {
  for (const auto& [direction, outside] :
       {std::pair{BendDirection::up, 32.0}, {BendDirection::down, 30.0}}) {
    const Laid part = laid(
        strip({Straight{50}, Crease{Angle::degrees(90), direction}, Straight{30}}, 40, 2));
    expect_measured(part, {0}, {outside});
  }
}

/// An L whose second flange ends in a slope.
Sheet sloping() {
  const Sheet straight = l_bracket();
  Sheet sheet = straight;
  Face& face = sheet.faces[sheet.flanges[FlangeId{1}].faces.front()];
  // Border 0 lies at the bend; what lies opposite is turned about one end.
  BorderLoop& loop = face.loops.front();
  auto& right = std::get<Segment>(loop[1].curve);
  right.b.y() += 4.0;
  std::get<Segment>(loop[2].curve).a = right.b;
  return sheet;
}

TEST(CheckDimensions, TakeTheOtherFlangeWhereOneEndsInASlope) {
  const Laid part = laid(sloping());
  expect_measured(part, {0}, {55.0});
  // The edge at the gauge serves as well.
  Stroke stroke = stroke_of(part, 0);
  const FlatBend& bend = part.flat.bends[0];
  const Segment line = bend.lines.front();
  const Vec2 along = (line.b - line.a).normalized();
  const Box2 box = bounds(part.layout.outline(part.sheet[FlangeId{1}].faces.front()));
  const Vec2 to_flange = 0.5 * (box.lo + box.hi) - line.a;
  stroke.gauge_direction = Vec2(-along.y(), along.x());
  if (stroke.gauge_direction.dot(to_flange) < 0.0) stroke.gauge_direction *= -1.0;
  const Vec2 stop = line.a + 20.0 * stroke.gauge_direction;
  stroke.gauge = GaugeStop{20.0, {stop, stop + 5.0 * along}};
  const auto check = checks_of(part, std::vector{stroke}).front();
  ASSERT_TRUE(check);
  EXPECT_EQ(check->flange, FlangeId{1});
  EXPECT_NEAR(check->length, 20.0 - 0.5 * bend.allowance.allowance + 5.0, kExact);
}

/// From the bend line lie half of what the bend takes and the flange; outside of that stands r + T,
/// or at the mould line (r + T) tan(α/2).
TEST(CheckDimensions, AreThoseOfTheRadiusAsMade) {
  constexpr double kT = 2.0, kDrawn = 0.5, kMade = 1.92, kFlange = 40.0;
  for (const double degrees : {45.0, 90.0, 120.0})
    for (const double k : {0.3, 0.44}) {
      const double half = 0.5 * Angle::degrees(degrees).radians();
      const double beyond = (kMade + kT) * (degrees < 90.0 ? std::tan(half) : 1.0);
      const double taken = half * (kMade + k * kT);
      FlattenOptions options{.allowance = ConstantK{k, "test"}};
      for (const bool as_made : {false, true}) {
        if (as_made) options.made_radius = {{BendId{0}, kMade}};
        const Sheet sheet = strip(
            {Straight{90}, Turn{Angle::degrees(degrees), kDrawn}, Straight{kFlange}}, 30, kT);
        const FlatSheet flat = *flat_sheet(sheet, options);
        const double to_edge = kFlange + 0.5 * flat.layout.allowance[BendId{0}].allowance;
        Stroke stroke = stroke_of({sheet, flat.pattern, flat.layout}, 0);
        stroke.radius_made = kMade;
        const auto check = check_dimensions(sheet, flat.layout, flat.pattern, {stroke}, options)
                               .front();
        ASSERT_TRUE(check);
        EXPECT_NEAR(check->length, to_edge - taken + beyond, kExact) << degrees << " " << as_made;
        if (as_made && degrees <= 90.0) {
          EXPECT_NEAR(check->length, kFlange + (kDrawn + kT) * std::tan(half), kExact)
              << "as it is drawn, since flanges keep their planes";
        }
      }
    }
}

TEST(CheckDimensions, AreNoneOfWhatHasNoFlanges) {
  const Laid part = laid(rolled());
  expect_measured(part, {0}, {0.0});
  const Laid cone = laid(cone_joined());
  expect_measured(cone, {0}, {0.0});
  EXPECT_EQ(checks_of(Laid{}, std::vector<Stroke>(2)).size(), 2u);
}

}  // namespace
}  // namespace planish
