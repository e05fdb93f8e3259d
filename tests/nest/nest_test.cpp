#include "support/nesting_check.hpp"

#include <planish/nest/nest.hpp>
#include <planish/sheet/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace planish {
namespace {

using std::numbers::pi;
using test::expect_sound;
using testing::ElementsAre;
using testing::HasSubstr;

FlatPattern pattern_of(Loop outer) {
  FlatPattern flat;
  flat.thickness = 1.0;
  flat.outer.loop = std::move(outer);
  return flat;
}

FlatPattern polygon_part(const std::vector<Vec2>& corners) {
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
    loop.emplace_back(Segment{corners[i], corners[(i + 1) % corners.size()]});
  return pattern_of(loop);
}

FlatPattern rectangle_part(double length, double width) {
  return polygon_part({{0, 0}, {length, 0}, {length, width}, {0, width}});
}

FlatPattern disc_part(double radius) { return pattern_of({Arc{{0, 0}, radius, 0.0, 2.0 * pi}}); }

FlatPattern rounded_part(double length, double width, double r) {
  const double x = length - r, y = width - r;
  return pattern_of({Segment{{r, 0}, {x, 0}}, Arc{{x, r}, r, -pi / 2, pi / 2},
                     Segment{{length, r}, {length, y}}, Arc{{x, y}, r, 0.0, pi / 2},
                     Segment{{x, width}, {r, width}}, Arc{{r, y}, r, pi / 2, pi / 2},
                     Segment{{0, y}, {0, r}}, Arc{{r, r}, r, pi, pi / 2}});
}

/// Two legs, `leg` wide.
FlatPattern angle_part(double size, double leg) {
  return polygon_part({{0, 0}, {size, 0}, {size, leg}, {leg, leg}, {leg, size}, {0, size}});
}

FlatPattern turned(FlatPattern flat, double angle) {
  Isometry2 motion = Isometry2::Identity();
  motion.translate(Vec2(1000.0, -300.0)).rotate(angle);
  flat.outer.loop = transformed(flat.outer.loop, motion);
  for (Contour& opening : flat.openings)
    opening.loop = transformed(opening.loop, motion);
  return flat;
}

Nesting nested(const std::vector<NestPart>& parts, const NestOptions& options) {
  const auto nesting = nest(parts, options);
  EXPECT_TRUE(nesting) << nesting.error().message;
  if (!nesting) return {};
  expect_sound(*nesting, parts, options);
  return *nesting;
}

TEST(Nest, FourQuartersOfASheetFillIt) {
  const FlatPattern quarter = rectangle_part(1500.0, 750.0);
  const Nesting nesting = nested({{&quarter, 4}}, {.length = 3000, .width = 1500, .gap = 0});
  ASSERT_EQ(nesting.sheets.size(), 1u);
  EXPECT_NEAR(nesting.sheets[0].use, 1.0, 1e-12);
}

TEST(Nest, QuartersDrawnAtAnyAngleFillTheSheetToo) {
  const FlatPattern quarter = rectangle_part(1500.0, 750.0);
  for (const double degrees : {1.0, 30.0, 45.0, 90.0, 133.0, 270.0}) {
    const FlatPattern drawn = turned(quarter, degrees * pi / 180.0);
    const Nesting nesting = nested({{&drawn, 4}}, {.length = 3000, .width = 1500, .gap = 0});
    EXPECT_EQ(nesting.sheets.size(), 1u) << degrees;
  }
}

TEST(Nest, TakesASecondSheetWhenAMillimetreIsMissing) {
  // Five columns and two rows of 100 mm with 4 mm between and 2 mm to the edge: 520 × 208.
  const FlatPattern square = rectangle_part(100.0, 100.0);
  NestOptions options{.length = 520, .width = 208, .gap = 4, .margin = 2};
  EXPECT_EQ(nested({{&square, 10}}, options).sheets.size(), 1u);
  options.length = 519;
  EXPECT_EQ(nested({{&square, 10}}, options).sheets.size(), 2u);
  options.length = 520;
  options.width = 207;
  EXPECT_EQ(nested({{&square, 10}}, options).sheets.size(), 2u);
}

TEST(Nest, RoundedCornersAndDiscsFitWhereTheirBoxFits) {
  const FlatPattern plate = rounded_part(990.0, 490.0, 8.0), disc = disc_part(245.0);
  const NestOptions options{.length = 1000, .width = 500, .gap = 5};
  EXPECT_EQ(nested({{&plate, 1}}, options).sheets.size(), 1u);
  EXPECT_EQ(nested({{&disc, 2}}, {.length = 995, .width = 500, .gap = 5}).sheets.size(), 1u);
}

TEST(Nest, PointedPartsFitWhereTheirBoxFits) {
  // Grown by half the gap, the points of a rhombus of 60° would reach 6 mm beyond its box.
  const double height = 100.0 * std::sqrt(3.0);
  const FlatPattern rhombus = polygon_part(
      {{50, 0}, {100, 0.5 * height}, {50, height}, {0, 0.5 * height}});
  const NestOptions options{
      .length = 140, .width = height + 40, .gap = 12.5, .margin = 20, .grain = true};
  EXPECT_EQ(nested({{&rhombus, 1}}, options).sheets.size(), 1u);
}

TEST(Nest, AnglesLieInEachOther) {
  // The second, turned by 180°, begins 70 mm along and up: 270 × 270 holds both, their hulls not.
  const FlatPattern angle = angle_part(200.0, 60.0);
  const Nesting nesting = nested({{&angle, 2}},
                                 {.length = 270, .width = 270, .gap = 5, .margin = 0});
  EXPECT_EQ(nesting.sheets.size(), 1u);
}

TEST(Nest, NamesPartsThatFitOnNoSheetAndNestsTheOthers) {
  const FlatPattern large = rectangle_part(600.0, 400.0), small = rectangle_part(100.0, 50.0);
  const NestOptions options{.length = 1000, .width = 300, .gap = 5, .margin = 10};
  const Nesting nesting = nested({{&large, 3}, {&small, 2}}, options);
  ASSERT_EQ(nesting.too_large.size(), 1u);
  EXPECT_EQ(nesting.too_large[0].part, 0);
  EXPECT_NEAR((nesting.too_large[0].needed - Vec2(620.0, 420.0)).norm(), 0.0, 1e-9);
  ASSERT_EQ(nesting.sheets.size(), 1u);
  EXPECT_EQ(nesting.sheets[0].placed.size(), 2u);
}

TEST(Nest, WithGrainAPartIsOnlyTurnedRound) {
  const FlatPattern upright = rectangle_part(100.0, 300.0);
  NestOptions options{.length = 1000, .width = 150, .gap = 5};
  EXPECT_EQ(nested({{&upright, 1}}, options).sheets.size(), 1u);
  options.grain = true;
  const Nesting none = nested({{&upright, 1}}, options);
  ASSERT_EQ(none.too_large.size(), 1u);
  EXPECT_NEAR((none.too_large[0].needed - Vec2(110.0, 310.0)).norm(), 0.0, 1e-9);
  EXPECT_TRUE(none.sheets.empty());

  const FlatPattern oblique = turned(angle_part(80.0, 20.0), 0.4);
  const Nesting kept = nested({{&oblique, 20}}, {.length = 800, .width = 400, .grain = true});
  EXPECT_EQ(kept.sheets.size(), 1u);
}

TEST(Nest, CountsOpeningsOutOfTheUse) {
  FlatPattern washer = disc_part(50.0);
  washer.openings.push_back({{Arc{{0, 0}, 20.0, 0.0, -2.0 * pi}}, {}});
  const Nesting nesting = nested({{&washer, 1}}, {.length = 200, .width = 100, .gap = 0});
  ASSERT_EQ(nesting.sheets.size(), 1u);
  EXPECT_NEAR(nesting.sheets[0].use, pi * (2500.0 - 400.0) / 20000.0, 1e-12);
}

TEST(Nest, GivesTheSameForTheSame) {
  const FlatPattern a = angle_part(150.0, 40.0), b = rounded_part(120.0, 80.0, 10.0);
  const std::vector<NestPart> parts{{&a, 9}, {&b, 14}};
  const NestOptions options{.length = 1000, .width = 500};
  const Nesting one = nested(parts, options), two = nested(parts, options);
  ASSERT_EQ(one.sheets.size(), two.sheets.size());
  for (std::size_t s = 0; s < one.sheets.size(); ++s) {
    ASSERT_EQ(one.sheets[s].placed.size(), two.sheets[s].placed.size());
    for (std::size_t i = 0; i < one.sheets[s].placed.size(); ++i)
      EXPECT_EQ(one.sheets[s].placed[i].placement.matrix(),
                two.sheets[s].placed[i].placement.matrix());
  }
}

/// A disc-like part with hollows, corners and arcs.
FlatPattern random_part(std::mt19937& random) {
  std::uniform_real_distribution<double> sizes(20.0, 250.0), shares(0.5, 1.0);
  std::uniform_int_distribution<int> kinds(0, 4), corners(5, 40);
  const double a = sizes(random), b = sizes(random);
  switch (kinds(random)) {
    case 0:
      return rectangle_part(a, b);
    case 1:
      return rounded_part(a, b, 0.4 * std::min(a, b) * shares(random));
    case 2:
      return angle_part(a, 0.5 * a * shares(random));
    case 3:
      return turned(disc_part(0.5 * a), shares(random));
    default:
      break;
  }
  std::vector<Vec2> star;
  const int n = corners(random);
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * pi * k / n, radius = 0.5 * a * shares(random);
    star.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return turned(polygon_part(star), shares(random));
}

RC_GTEST_PROP(NestOfRandomParts, KeepsGapMarginAndQuantities, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  std::vector<FlatPattern> flats;
  const int count = *rc::gen::inRange(1, 12);
  for (int i = 0; i < count; ++i)
    flats.push_back(random_part(random));
  std::vector<NestPart> parts;
  for (const FlatPattern& flat : flats)
    parts.push_back({&flat, *rc::gen::inRange(1, 5)});
  NestOptions options{.length = *rc::gen::element(300.0, 1000.0, 1500.0),
                      .width = *rc::gen::element(200.0, 500.0, 1500.0),
                      .gap = *rc::gen::element(0.0, 0.3, 5.0, 12.5),
                      .grain = *rc::gen::arbitrary<bool>()};
  if (*rc::gen::arbitrary<bool>()) options.margin = *rc::gen::element(0.0, 2.0, 20.0);
  const auto nesting = nest(parts, options);
  if (!nesting) RC_FAIL(nesting.error().message);
  expect_sound(*nesting, parts, options);
  RC_ASSERT(!testing::Test::HasFailure());
}

TEST(NestOfManyCopies, LaysThousandsInBlocks) {
  const FlatPattern small = rounded_part(40.0, 25.0, 4.0), angle = angle_part(60.0, 15.0);
  const std::vector<NestPart> parts{{&small, 1500}, {&angle, 403}};
  const NestOptions options{.length = 2000, .width = 1000, .gap = 3};
  const Nesting nesting = nested(parts, options);
  // 1500 · (1000 − 13.7) + 403 · 1575 = 2.11 m², and three sheets are 6 m².
  EXPECT_LE(nesting.sheets.size(), 3u);
}

TEST(NestOfManyCopies, KeepsTheGrain) {
  const FlatPattern part = turned(angle_part(70.0, 20.0), 0.3);
  nested({{&part, 300}}, {.length = 1000, .width = 1000, .gap = 2, .grain = true});
}

TEST(Nest, RefusesWhatCannotBe) {
  const FlatPattern part = rectangle_part(10.0, 10.0), empty;
  const auto error = [](const std::vector<NestPart>& parts, const NestOptions& options) {
    const auto nesting = nest(parts, options);
    EXPECT_FALSE(nesting);
    return nesting ? Error{} : nesting.error();
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(error({{&part, 1}}, {.length = 0}).message, HasSubstr("The length is 0 mm"));
  EXPECT_THAT(error({{&part, 1}}, {.width = nan}).message, HasSubstr("The width is nan mm"));
  EXPECT_THAT(error({{&part, 1}}, {.gap = -1}).message, HasSubstr("The gap is -1 mm"));
  EXPECT_THAT(error({{&part, 1}}, {.gap = 1000}).message, HasSubstr("750 mm, half the sheet"));
  EXPECT_THAT(error({{&part, 1}}, {.margin = 800}).message, HasSubstr("The margin is 800 mm"));
  EXPECT_THAT(error({{&part, 1}, {&part, 0}}, {}).message, HasSubstr("Part 2 is wanted 0 times"));
  EXPECT_EQ(error({{&empty, 1}}, {}).code, code::invalid_sheet);
  EXPECT_EQ(error({{&part, 1}, {&part, 0}}, {}).where, "part 2");
  const Error gap = error({{&part, 1}}, {.gap = -1});
  EXPECT_EQ(gap.where, "gap");
  ASSERT_EQ(gap.numbers.size(), 1u);
  EXPECT_EQ(gap.numbers[0].quantity, (Quantity{-1.0, unit::mm}));
  EXPECT_EQ(gap.remedies.size(), 1u);
}

TEST(Nest, OfNothingHasNoSheets) { EXPECT_TRUE(nested({}, {}).sheets.empty()); }

TEST(Nest, EndsWhenCancelled) {
  const FlatPattern part = angle_part(50.0, 10.0);
  int asked = 0;
  const Progress progress{{}, [&asked] { return ++asked > 10; }};
  const auto nesting = nest({{&part, 150}}, {}, progress);
  ASSERT_FALSE(nesting);
  EXPECT_EQ(nesting.error().code, code::cancelled);
}

}  // namespace
}  // namespace planish
