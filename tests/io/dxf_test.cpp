#include "dxf_reading.hpp"
#include "sample_patterns.hpp"

#include <planish/geometry/curve.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/moved_pattern.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace planish {
namespace {

using namespace sample;
using testing::AnyOf;
using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::UnorderedElementsAre;

std::string dxf(const FlatPattern& pattern, const DxfOptions& options = {}) {
  const Result<std::string> text = dxf_text(pattern, options);
  EXPECT_TRUE(text) << text.error().message;
  return text.value_or("");
}

FlatPattern blank(const Loop& outer) {
  FlatPattern pattern;
  pattern.thickness = 1.0;
  pattern.outer.loop = outer;
  return pattern;
}

std::vector<Groups> of_type(const std::string& text, const std::string& type) {
  std::vector<Groups> result;
  for (const Groups& entity : entities(text)) {
    if (entity.front().second == type) result.push_back(entity);
  }
  return result;
}

std::vector<std::string> kinds_and_layers(const std::string& text) {
  std::vector<std::string> result;
  for (const Groups& entity : entities(text)) {
    result.push_back(entity.front().second + " " + value_of(entity, 8));
  }
  return result;
}

TEST(Dxf, MarksFirstThenOpeningsAndTheOuterContourLast) {
  FlatPattern pattern = bracket();
  pattern.features.push_back({"countersink", FormSide::up, {hole({20, 50}, 11.0)}});
  EXPECT_THAT(kinds_and_layers(dxf(pattern, {.tangent_lines = true})),
              ElementsAre("LINE BEND_UP", "LINE BEND_DOWN", "LINE BEND_TANGENT",
                          "LINE BEND_TANGENT", "LINE BEND_TANGENT", "LINE BEND_TANGENT",
                          "CIRCLE FEATURE_PROFILES", "CIRCLE INTERIOR_PROFILES",
                          "LWPOLYLINE INTERIOR_PROFILES", "LWPOLYLINE OUTER_PROFILE"));
}

TEST(Dxf, WritesTextsAtBendsOnRequest) {
  FlatPattern pattern = bracket();
  pattern.bends[0].stroke = 2;
  for (const DxfVersion version : {DxfVersion::r2000, DxfVersion::r12}) {
    const std::string text = dxf(pattern, {.version = version, .bend_text = true});
    const auto texts = of_type(text, "TEXT");
    ASSERT_EQ(texts.size(), pattern.bends.size());
    EXPECT_EQ(value_of(texts[0], 8), "TEXT");
    EXPECT_EQ(value_of(texts[0], 1).rfind("2: B1 UP 90%%d R", 0), 0u) << value_of(texts[0], 1);
    EXPECT_EQ(value_of(texts[1], 1).rfind("B2 DOWN ", 0), 0u) << value_of(texts[1], 1);
    EXPECT_EQ(kinds_and_layers(dxf(pattern, {.version = version})).size(),
              kinds_and_layers(text).size() - 2);
  }
}

std::vector<double> numbers(const Groups& entity, int code) {
  std::vector<double> values;
  for (const std::string& value : values_of(entity, code))
    values.push_back(std::stod(value));
  return values;
}

TEST(Dxf, LiesAlongItsBlankOnRequest) {
  for (const double degrees : {0.0, 17.0, 90.0, 143.0, 180.0, 271.5}) {
    Isometry2 motion = Isometry2::Identity();
    motion.linear() = Eigen::Rotation2Dd(degrees * kPi / 180.0).toRotationMatrix();
    motion.translation() = Vec2(31.0, -470.0);
    const std::string text = dxf(transformed(bracket(), motion), {.turn_to_blank = true});
    const auto outer = of_type(text, "LWPOLYLINE").back();
    // The bracket is 200 × 100, its bends up and down at 60 and 150 along it.
    EXPECT_THAT(numbers(outer, 10),
                UnorderedElementsAre(DoubleNear(0, 1e-9), DoubleNear(0, 1e-9),
                                     DoubleNear(200, 1e-9), DoubleNear(200, 1e-9)));
    EXPECT_THAT(numbers(outer, 20),
                UnorderedElementsAre(DoubleNear(0, 1e-9), DoubleNear(0, 1e-9),
                                     DoubleNear(100, 1e-9), DoubleNear(100, 1e-9)));
    const auto bends = of_type(text, "LINE");
    const double up = numbers(bends[0], 10)[0], down = numbers(bends[1], 10)[0];
    EXPECT_THAT(up, AnyOf(DoubleNear(60, 1e-9), DoubleNear(140, 1e-9))) << degrees;
    EXPECT_NEAR(std::abs(up - down), 90.0, 1e-9);
  }
}

TEST(Dxf, BlanksAlongAnAxisAreTurnedWithoutRounding) {
  const auto upright = [](const Vec2& lo, const Vec2& hi) { return blank(rectangle(lo, hi)); };
  const std::string text = dxf(upright({-3, 7}, {122, 507.25}), {.turn_to_blank = true});
  EXPECT_THAT(numbers(of_type(text, "LWPOLYLINE").front(), 10),
              UnorderedElementsAre(0.0, 0.0, 500.25, 500.25));
  EXPECT_EQ(dxf(upright({0, 0}, {500.25, 125}), {.turn_to_blank = true}),
            dxf(upright({0, 0}, {500.25, 125})));
}

struct ProfileRow {
  LayerProfile profile;
  LayerNames names;
};

// shop-floor.md#layer-sets.
const std::vector<ProfileRow> kProfiles{
    {LayerProfile::standard,
     {"OUTER_PROFILE", "INTERIOR_PROFILES", "BEND_UP", "BEND_DOWN", "BEND_TANGENT", "", "SLITS"}},
    {LayerProfile::inventor,
     {"IV_OUTER_PROFILE", "IV_INTERIOR_PROFILES", "IV_BEND", "IV_BEND_DOWN", "IV_TANGENT", "",
      "SLITS"}},
    {LayerProfile::onshape,
     {"SHEETMETAL_CUT_LINES", "SHEETMETAL_CUT_LINES", "SHEETMETAL_BEND_LINES_UP",
      "SHEETMETAL_BEND_LINES_DOWN", "SHEETMETAL_BEND_TANGENT_LI", "", "SHEETMETAL_CUT_LINES"}},
    {LayerProfile::solid_edge,
     {"OUTER_LOOP", "INTERIOR_LOOPS", "UP_CENTERLINES", "DOWN_CENTERLINES", "", "", "SLITS"}},
};

TEST(Dxf, CutsSlitsOnceAsLinesOnALayerOfTheirOwn) {
  FlatPattern pattern = bracket();
  pattern.slits = {Segment{{70, 60}, {140, 60}}, Segment{{70, 80}, {200, 80}}};
  EXPECT_THAT(kinds_and_layers(dxf(pattern)),
              ElementsAre("LINE BEND_UP", "LINE BEND_DOWN", "LINE SLITS", "LINE SLITS",
                          "CIRCLE INTERIOR_PROFILES", "LWPOLYLINE INTERIOR_PROFILES",
                          "LWPOLYLINE OUTER_PROFILE"));
  for (const auto& [profile, names] : kProfiles) {
    const Reader read(dxf(pattern, {.profile = profile}));
    EXPECT_EQ(read.layers.at(names.slits), names.slits == names.outer ? 7 : 6);
  }
  std::get<Segment>(pattern.slits.front()).a.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(dxf_text(pattern));
}

TEST(Dxf, CutsCurvedSlitsAsArcs) {
  FlatPattern pattern = bracket();
  pattern.slits = {Arc{{100, 60}, 10.0, 0.0, 1.5 * std::numbers::pi}};
  EXPECT_THAT(kinds_and_layers(dxf(pattern)),
              ElementsAre("LINE BEND_UP", "LINE BEND_DOWN", "ARC SLITS", "ARC SLITS",
                          "CIRCLE INTERIOR_PROFILES", "LWPOLYLINE INTERIOR_PROFILES",
                          "LWPOLYLINE OUTER_PROFILE"));
}

TEST(Dxf, KeepsCirclesAndClosesPolylinesWithBulges) {
  const Reader read(dxf(bracket()));
  ASSERT_THAT(read.circles, SizeIs(1));
  EXPECT_EQ(read.circles[0].cx, 20.0);
  EXPECT_EQ(read.circles[0].cy, 50.0);
  EXPECT_EQ(read.circles[0].radius, 8.0);
  ASSERT_THAT(read.polylines, SizeIs(2));
  const auto& slot = read.polylines[0];
  EXPECT_TRUE(slot.closed);
  ASSERT_THAT(slot.vertices, SizeIs(4));
  EXPECT_EQ(slot.vertices[0].bulge, 0.0);
  EXPECT_NEAR(slot.vertices[1].bulge, -1.0, 1e-15);
  EXPECT_EQ(slot.vertices[2].bulge, 0.0);
  EXPECT_NEAR(slot.vertices[3].bulge, -1.0, 1e-15);
  EXPECT_TRUE(read.polylines[1].closed);
  EXPECT_THAT(read.polylines[1].vertices, SizeIs(4));
}

TEST(Dxf, GivesABendLineLayerColourAndLinetypeAtOnce) {
  for (const DxfVersion version : {DxfVersion::r2000, DxfVersion::r12}) {
    const auto lines = of_type(dxf(bracket(), {.version = version}), "LINE");
    ASSERT_THAT(lines, SizeIs(2));
    EXPECT_EQ(value_of(lines[0], 8), "BEND_UP");
    EXPECT_EQ(value_of(lines[0], 62), "5");
    EXPECT_EQ(value_of(lines[1], 8), "BEND_DOWN");
    EXPECT_EQ(value_of(lines[1], 62), "1");
    for (const Groups& line : lines)
      EXPECT_EQ(value_of(line, 6), "DASHED");
  }
}

TEST(Dxf, DoesNotDashTangentLines) {
  for (const Groups& line : of_type(dxf(bracket(), {.tangent_lines = true}), "LINE")) {
    const bool bend = value_of(line, 8) != "BEND_TANGENT";
    EXPECT_EQ(value_of(line, 6), bend ? "DASHED" : "CONTINUOUS");
  }
}

TEST(Dxf, ShortensTheDashesOfAShortBendLine) {
  FlatPattern pattern = bracket();
  pattern.bends = {bend("B1", BendDirection::up, {{60, 50}, {63, 50}}, 1.0)};
  const auto lines = of_type(dxf(pattern), "LINE");
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_LE(std::stod(value_of(lines[0], 48)) * (12.7 + 6.35), 1.5);
}

TEST(Dxf, MarksBendLinesByTicksAtTheirEnds) {
  FlatPattern pattern = bracket();
  pattern.bends[1] = bend("B2", BendDirection::down, {{150, 50}, {150, 56}}, 1.0);
  const Reader read(dxf(pattern, {.bend_marks = BendMarks::ticks, .tick_length = 4.0}));
  ASSERT_THAT(read.lines, SizeIs(4));
  std::vector<double> y;
  for (const DL_LineData& line : read.lines) {
    y.push_back(line.y1);
    y.push_back(line.y2);
  }
  EXPECT_THAT(y, ElementsAre(0, 4, 96, 100, 50, 52, 54, 56));
}

TEST(Dxf, NamesTheLayersOfEachProfile) {
  for (const auto& [profile, names] : kProfiles) {
    std::map<std::string, int> expected{
        {"0", 7}, {names.openings, 4}, {names.outer, 7}, {names.bend_up, 5}, {names.bend_down, 1}};
    if (names.openings == names.outer) expected[names.outer] = 7;
    if (!names.bend_zone.empty()) expected[names.bend_zone] = 8;
    const Reader read(dxf(bracket(), {.profile = profile, .tangent_lines = true}));
    EXPECT_EQ(read.layers, expected);
  }
}

TEST(Dxf, TablesOnlyTheLayersInUse) {
  const Reader read(dxf(blank(rectangle({0, 0}, {10, 10}))));
  EXPECT_EQ(read.layers, (std::map<std::string, int>{{"0", 7}, {"OUTER_PROFILE", 7}}));
}

TEST(Dxf, KeepsFormedFeaturesOffTheCuttingLayersAndTheWordsReadersLookFor) {
  for (const auto& [profile, names] : kProfiles) {
    const std::string features = layer_names(profile).features;
    EXPECT_NE(features, names.outer);
    EXPECT_NE(features, names.openings);
    EXPECT_THAT(features, Not(HasSubstr("BEND")));
    EXPECT_THAT(features, Not(HasSubstr("TANGENT")));
    EXPECT_LE(features.size(), 31U) << "R12's limit";
  }
}

TEST(Dxf, TellsItsUnitsAndExtents) {
  const struct {
    LengthUnit unit;
    int insunits, measurement;
    double mm;
  } rows[] = {
      {LengthUnit::mm, 4, 1, 1.0}, {LengthUnit::inch, 1, 0, 25.4}, {LengthUnit::m, 6, 1, 1000.0}};
  for (const auto& row : rows) {
    for (const DxfVersion version : {DxfVersion::r2000, DxfVersion::r12}) {
      const std::string text = dxf(bracket(), {.version = version, .units = row.unit});
      const Reader read(text);
      EXPECT_EQ(read.settings.at("$INSUNITS"), row.insunits);
      EXPECT_EQ(read.settings.at("$MEASUREMENT"), row.measurement);
      EXPECT_DOUBLE_EQ(read.circles.at(0).radius * row.mm, 8.0);
      const Groups all = groups(text);
      const auto max = std::ranges::find(all, std::pair<int, std::string>(9, "$EXTMAX"));
      ASSERT_NE(max, all.end());
      EXPECT_DOUBLE_EQ(std::stod((max + 1)->second) * row.mm, 200.0);
      EXPECT_DOUBLE_EQ(std::stod((max + 2)->second) * row.mm, 100.0);
    }
  }
}

TEST(Dxf, HasNothingInR12ThatR12DoesNotKnow) {
  const std::string text = dxf(bracket_with_petal(),
                               {.version = DxfVersion::r12, .splines = Splines::keep});
  for (const char* word : {"LWPOLYLINE", "SPLINE", "ELLIPSE", "AcDb", "OBJECTS", "BLOCK_RECORD"}) {
    EXPECT_THAT(text, Not(HasSubstr("\n" + std::string(word)))) << word;
  }
  EXPECT_THAT(text, HasSubstr("AC1009"));
  EXPECT_THAT(of_type(text, "POLYLINE"), SizeIs(3));
  EXPECT_THAT(of_type(text, "SEQEND"), SizeIs(3));
}

TEST(Dxf, WritesNoTextDimensionOrExponent) {
  FlatPattern pattern = bracket();
  std::get<Segment>(pattern.outer.loop[0]).a.x() = 1.5e-9;
  const std::string text = dxf(pattern);
  EXPECT_THAT(of_type(text, "TEXT"), IsEmpty());
  EXPECT_THAT(of_type(text, "DIMENSION"), IsEmpty());
  for (const Groups& entity : entities(text)) {
    for (const auto& [code, value] : entity) {
      if (code < 10 || code >= 60) continue;
      EXPECT_EQ(value.find_first_of("eE,"), std::string::npos) << value;
    }
  }
}

TEST(Dxf, WritesRealsThatReadBackTheSame) {
  FlatPattern pattern = blank(
      polygon({{1.0 / 3.0, -2e5 / 7.0}, {1e5 * kPi, 0.1}, {1e-7 / 3.0, 3.0}}));
  const Reader read(dxf(pattern));
  ASSERT_THAT(read.polylines, SizeIs(1));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.polylines[0].vertices[i].x, start_of(pattern.outer.loop[i]).x());
    EXPECT_EQ(read.polylines[0].vertices[i].y, start_of(pattern.outer.loop[i]).y());
  }
}

double area(const Reader::Outline& outline) {
  double area = 0.0;
  for (std::size_t i = 0; i < outline.vertices.size(); ++i) {
    const auto& a = outline.vertices[i];
    const auto& b = outline.vertices[(i + 1) % outline.vertices.size()];
    const double chord = std::hypot(b.x - a.x, b.y - a.y);
    const double sweep = 4.0 * std::atan(a.bulge);
    const double radius = a.bulge == 0.0 ? 0.0 : chord / (2.0 * std::sin(sweep / 2.0));
    area += 0.5 * (a.x * b.y - b.x * a.y) + 0.5 * radius * radius * (sweep - std::sin(sweep));
  }
  return area;
}

/// Corners on a circle of radius 100, joined by lines and by arcs of −108° to 108°.
Loop wheel(const std::vector<int>& sweeps) {
  const auto corner = [&](std::size_t i) {
    const double a = 2.0 * kPi * static_cast<double>(i % sweeps.size()) /
                     static_cast<double>(sweeps.size());
    return Vec2(100.0 * std::cos(a), 100.0 * std::sin(a));
  };
  Loop loop;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const double sweep = Angle::degrees(sweeps[i]).radians();
    if (sweeps[i] == 0) {
      loop.emplace_back(Segment{corner(i), corner(i + 1)});
      continue;
    }
    const Vec2 chord = corner(i + 1) - corner(i);
    const double radius = chord.norm() / (2.0 * std::sin(std::abs(sweep) / 2.0));
    const double start = std::atan2(chord.y(), chord.x()) - sweep / 2.0 -
                         (sweep > 0 ? kPi / 2 : -kPi / 2);
    const Vec2 center = corner(i) - radius * Vec2(std::cos(start), std::sin(start));
    loop.emplace_back(Arc{center, radius, start, sweep});
  }
  return loop;
}

RC_GTEST_PROP(Dxf, KeepsTheAreaOfAnyLinesAndArcs, ()) {
  const auto count = *rc::gen::inRange(3, 20);
  const auto sweeps = *rc::gen::container<std::vector<int>>(static_cast<std::size_t>(count),
                                                            rc::gen::inRange(-108, 109));
  const Loop loop = wheel(sweeps);
  for (const DxfVersion version : {DxfVersion::r2000, DxfVersion::r12}) {
    const Reader read(dxf(blank(loop), {.version = version}));
    RC_ASSERT(read.polylines.size() == 1U);
    RC_ASSERT(read.polylines[0].closed);
    RC_ASSERT(std::abs(area(read.polylines[0]) - signed_area(loop)) < 1e-9 * 3e4);
  }
}

TEST(Dxf, CutsArcsOfMoreThanHalfATurnInTwo) {
  // A disc of radius 10 with a flat at x = 5.
  const Loop disc{Arc{{0, 0}, 10.0, kPi / 3, 4.0 * kPi / 3},
                  Segment{{5, -std::sqrt(75.0)}, {5, std::sqrt(75.0)}}};
  const Reader read(dxf(blank(disc)));
  ASSERT_THAT(read.polylines, SizeIs(1));
  ASSERT_THAT(read.polylines[0].vertices, SizeIs(3));
  EXPECT_NEAR(read.polylines[0].vertices[0].bulge, std::tan(kPi / 6), 1e-15);
  EXPECT_NEAR(read.polylines[0].vertices[1].x, -10.0, 1e-14);
  EXPECT_NEAR(read.polylines[0].vertices[1].bulge, std::tan(kPi / 6), 1e-15);
}

TEST(Dxf, ClosesAContourOfTwoPieces) {
  const Loop lens{Arc{{0, 0}, 10.0, -kPi / 6, kPi / 3},
                  Segment{{10 * std::cos(kPi / 6), 5}, {10 * std::cos(kPi / 6), -5}}};
  const Reader read(dxf(blank(lens)));
  ASSERT_THAT(read.polylines, SizeIs(1));
  EXPECT_TRUE(read.polylines[0].closed);
  EXPECT_THAT(read.polylines[0].vertices, SizeIs(2));
}

TEST(Dxf, LeavesOutCoincidentVerticesAndBulgesOfZero) {
  Loop loop = rectangle({0, 0}, {10, 10});
  loop.insert(loop.begin() + 1, Segment{{10, 0}, {10, 1e-12}});
  // A millimetre of a circle of 10^13 mm.
  loop[0] = Arc{{5, 1e14}, 1e14, -kPi / 2 - 5e-14, 1e-13};
  const Reader read(dxf(blank(loop)));
  ASSERT_THAT(read.polylines, SizeIs(1));
  ASSERT_THAT(read.polylines[0].vertices, SizeIs(4));
  for (const auto& vertex : read.polylines[0].vertices)
    EXPECT_EQ(vertex.bulge, 0.0);
}

TEST(Dxf, MakesArcsOfSplinesUnlessTheyAreKept) {
  const Reader arcs(dxf(bracket_with_petal()));
  EXPECT_THAT(arcs.splines, IsEmpty());
  EXPECT_THAT(arcs.polylines, SizeIs(3));
  const Reader kept(dxf(bracket_with_petal(), {.splines = Splines::keep}));
  ASSERT_THAT(kept.splines, SizeIs(1));
  EXPECT_EQ(kept.splines[0].degree, 3U);
  EXPECT_EQ(kept.splines[0].nControl, 4U);
  EXPECT_THAT(kept.knots, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1));
  EXPECT_THAT(kept.polylines, SizeIs(2)) << "contours without splines stay polylines";
}

TEST(Dxf, TakesADoubleKnotWhereASplineIsSmoothAndATripleWhereItIsNot) {
  // Joints at (10, 0), run through at twice the speed, and at (30, 0), a corner.
  const CubicSpline spline{
      {{0, 0}, {2, 5}, {9, 1}, {10, 0}, {12, -2}, {25, -4}, {30, 0}, {30, 9}, {0, 9}, {0, 0}}};
  const Reader read(dxf(blank({spline}), {.splines = Splines::keep}));
  ASSERT_THAT(read.splines, SizeIs(1));
  EXPECT_EQ(read.splines[0].nControl, 9U);
  EXPECT_THAT(read.knots, ElementsAre(0, 0, 0, 0, 1, 1, 3, 3, 3, 4, 4, 4, 4));
}

TEST(Dxf, RefusesOptionsOutOfRange) {
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const auto tolerance = dxf_text(bracket(), {.arc_tolerance = bad});
    ASSERT_FALSE(tolerance);
    EXPECT_EQ(tolerance.error().code, code::bad_option);
    const auto tick = dxf_text(bracket(), {.tick_length = bad});
    ASSERT_FALSE(tick);
    EXPECT_EQ(tick.error().code, code::bad_option);
  }
}

TEST(Dxf, RefusesAnUnsoundPattern) {
  FlatPattern no_outer = bracket();
  no_outer.outer.loop.clear();
  FlatPattern not_finite = bracket();
  std::get<Segment>(not_finite.outer.loop[2]).a.y() = std::numeric_limits<double>::quiet_NaN();
  FlatPattern no_extent = bracket();
  no_extent.openings.push_back({{Segment{{1, 1}, {1, 1}}}, {}});
  for (const auto& [pattern, code] :
       {std::pair{no_outer, code::invalid_sheet}, std::pair{not_finite, code::invalid_sheet},
        std::pair{no_extent, code::internal}}) {
    const auto text = dxf_text(pattern);
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().code, code);
  }
}

}  // namespace
}  // namespace planish
