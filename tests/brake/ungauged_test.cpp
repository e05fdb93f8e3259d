#include "ungauged.hpp"

#include "brake/gauged_parts.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace brake_detail;

/// Of what stands upright it is told whether it is too low, too narrow or out of range: its outer
/// face begins R above the sheet's upper skin, and stands R + T beyond the tangent line.
TEST(Ungauged, TellsWhyAFormedFlangeIsNoStop) {
  const auto why = [](double lip, double width, double web) {
    const Turn turn{Angle::degrees(90), 2, BendDirection::up};
    const Sheet sheet = strip({Straight{lip}, turn, Straight{web}, turn, Straight{60}}, width, 1.5);
    BrakeTools tools = gauged_tools();
    tools.machine.gauge->highest = 80.0;
    for (const Stroke& stroke : strokes_of(sheet, tools, {1}, 2))
      if (stroke.to_gauge == FlangeId(1))
        return std::string(stroke.ungauged ? stroke.ungauged->code : "gauged");
    return std::string("no way");
  };
  EXPECT_EQ(why(12.0, 80.0, 60.0), "gauged");
  EXPECT_EQ(why(1.6, 80.0, 60.0), "gauged");
  EXPECT_EQ(why(1.4, 80.0, 60.0), "face_too_low");
  EXPECT_EQ(why(12.0, 4.9, 60.0), "edge_too_short");
  EXPECT_EQ(why(12.0, 80.0, 300.0), "edge_out_of_range");
}

/// A lip that leans has an edge that is parallel, and nothing that a finger touches. What only the
/// other side has is told of that.
TEST(Ungauged, TellsOfEdgesElsewhere) {
  const auto why = [](double lip, double far_slope, double near_slope,
                      const std::vector<int>& formed) {
    SheetBuilder builder(1.5);
    const FaceId web = builder.flange(Frame{}, {polygon({{0, 0}, {80, 0}, {80, 60}, {0, 60}})});
    builder.flange_behind(
        builder.bend(builder.rim(web, 0), {Angle::degrees(90), 2, BendDirection::up}),
        {polygon({{0, 0}, {80, 0}, {80, 50 + near_slope}, {0, 50}})});
    builder.flange_behind(
        builder.bend(builder.rim(web, 2), {Angle::degrees(lip), 2, BendDirection::up}),
        {polygon({{0, 0}, {80, 0}, {80, 30 + far_slope}, {0, 30}})});
    for (const Stroke& stroke : strokes_of(builder.finish(), gauged_tools(), formed))
      if (stroke.to_gauge == FlangeId(0))
        return std::string(stroke.ungauged ? stroke.ungauged->code : "gauged");
    return std::string("no way");
  };
  EXPECT_EQ(why(60.0, 0.0, 5.0, {}), "gauged");
  EXPECT_EQ(why(60.0, 0.0, 5.0, {2}), "edge_leans");
  EXPECT_EQ(why(60.0, 5.0, 5.0, {2}), "no_parallel_edge");
  EXPECT_EQ(why(60.0, 5.0, 0.0, {2}), "edge_on_other_side");
}

/// Of edges out of reach on both sides the one that lacks less, whichever side the stroke is told
/// from.
TEST(Ungauged, TellsOfTheNearestEdgeOnEitherSide) {
  BrakeTools tools = gauged_tools();
  tools.machine.gauge->to = 40.0;
  const Sheet sheet = strip(
      {Straight{45}, Turn{Angle::degrees(90), 2, BendDirection::up}, Straight{60}}, 80, 1.5);
  for (const Stroke& stroke : strokes_of(sheet, tools)) {
    ASSERT_TRUE(stroke.ungauged);
    EXPECT_EQ(stroke.ungauged->code, "edge_out_of_range");
    EXPECT_NEAR(stroke.ungauged->told.numbers.at(0).quantity.value, 45.0 + kHalfZone, 1e-9);
  }
}

/// Where only an opening would do, the reason names the option; where nothing would, it does not.
TEST(Ungauged, NamesTheOptionWhereAnOpeningWouldDo) {
  const auto named = [](const OpenedPart& part, const BrakeTools& tools, const char* words) {
    Room room(part.sheet(), tools, {});
    for (const StrokeChoice& choice : room.ways(1, {}))
      if (const auto why = describe(room.cache(), room.lines({}), choice).ungauged)
        if (why->told.sentence.find("--gauge-openings") != std::string::npos)
          return why->told.sentence.find(words) != std::string::npos;
    return false;
  };
  EXPECT_FALSE(named({.wide = 9.9}, tools_with_nose(), "the nose of the fingers"));
  EXPECT_TRUE(named({.wide = 10.1}, tools_with_nose(), "the nose of the fingers"));
  BrakeTools tools = tools_with_nose();
  tools.machine.gauge->finger_width = 30.0;
  tools.machine.gauge->nose.reset();
  EXPECT_FALSE(named({.deep = 79.8, .wide = 50.0}, tools, "the fingers touch"));
  EXPECT_TRUE(named({.deep = 80.1, .wide = 50.0}, tools, "the fingers touch"));
}

}  // namespace
}  // namespace planish::test
