#include "proposed_pairs.hpp"

#include "brake/tried_proposals.hpp"

#include <gtest/gtest.h>

namespace planish::test {
namespace {

using namespace brake_detail;
using Kind = Proposal::Kind;

/// The last wall of a tray is bent between two lips: in one piece the punch has no room between the
/// walls, and in segments it does not come out from below the lips without ears.
TEST(ProposedPairs, AreTwoChangesOfWhichNeitherDoes) {
  const Sheet tray = lipped_tray(18.0);
  BrakeTools tools = plain_tools({.half_width = 4.0}, {.half_width = 9.0});
  tools.punches[0].segments = {400.0};
  BrakeTools others = tools;
  others.punches[0].id = "other";
  others.punches[0].ears = Ears{50.0, 50.0, 25.0, 20.0};
  const Tried all = tried(tray, tools, {}, &others);
  ASSERT_EQ(all.proposals.size(), 1u);
  const Proposal& both = all.proposals.front();
  EXPECT_EQ(both.kind, Kind::segments);
  EXPECT_EQ(both.tools.size(), 1u) << "as few tools as will do";
  ASSERT_EQ(both.also.size(), 1u);
  EXPECT_EQ(both.also.front().kind, Kind::punch);
  EXPECT_TRUE(both.also.front().ears);
  // With one of the two at hand the other is all it takes.
  tools.punches[0].segments = plain_tools().punches[0].segments;
  others.punches[0].segments = tools.punches[0].segments;
  const Tried one = tried(tray, tools, {}, &others);
  ASSERT_NE(one.of(Kind::punch), nullptr);
  EXPECT_TRUE(one.of(Kind::punch)->also.empty());
}

/// Nor are two told that do not do.
TEST(ProposedPairs, AreNotMadeUp) {
  BrakeTools tools = plain_tools({.half_width = 4.0}, {.half_width = 9.0});
  tools.punches[0].segments = {400.0};
  BrakeTools others = tools;  // no ears anywhere
  others.punches[0].tip_radius += 0.2;
  const Tried all = tried(lipped_tray(18.0), tools, {}, &others);
  for (const Proposal& one : all.proposals)
    EXPECT_TRUE(one.also.empty());
}

}  // namespace
}  // namespace planish::test
