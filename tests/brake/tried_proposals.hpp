#pragma once

#include "brake/stroke_room.hpp"

#include <planish/brake/proposals.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

/// Sheets that cannot be bent, and what is proposed for them.
namespace planish::test {

inline const double kSlope = std::numbers::sqrt2 / 2.0;  // of both sides at 90°

inline Turn bent_up(double radius = 2.0) { return {Angle::degrees(90), radius, BendDirection::up}; }

struct Tried {
  Plan plan;
  std::vector<Proposal> proposals;
  const Proposal* of(Proposal::Kind kind) const {
    const auto found = std::ranges::find(proposals, kind, &Proposal::kind);
    return found == proposals.end() ? nullptr : &*found;
  }
};

inline Tried tried(const Sheet& sheet, const BrakeTools& tools, const PlanOptions& options = {},
                   const BrakeTools* others = nullptr) {
  const auto flat = flat_sheet(sheet);
  EXPECT_TRUE(flat);
  auto plan = plan_bending(sheet, flat->layout, tools, options);
  EXPECT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->status, PlanStatus::infeasible);
  const ProposalOptions trying{.others = others, .checks = 1'000'000};
  return {*plan, proposals(sheet, flat->layout, tools, options, *plan, trying)};
}

/// Two legs of the same length on a web of 60.
inline Sheet channel_of(double leg) {
  return strip({Straight{leg}, bent_up(), Straight{60}, bent_up(), Straight{leg}}, 80, 1.5);
}

/// A tray of 160 by 120 by 30 with mitred lips: the last wall is bent between two of them.
inline Sheet lipped_tray(double lip) {
  const Turn turn{Angle::degrees(90), 1.0, BendDirection::up};
  SheetBuilder builder(1.0);
  const FaceId base = builder.flange(Frame{}, {rectangle(160, 120)});
  for (int rim = 0; rim < 4; ++rim) {
    const Rim foot = builder.bend(builder.rim(base, rim), turn);
    const FaceId wall = builder.flange_behind(foot, {rectangle(foot.length, 28)});
    const Rim top = builder.bend(builder.rim(wall, 2), turn);
    const double w = top.length;
    builder.flange_behind(top, {polygon({{0, 0}, {w, 0}, {w - lip - 1, lip}, {lip + 1, lip}})});
  }
  return builder.finish();
}

/// check_test.cpp: a punch 2 b wide closes a channel whose first leg is at most
/// web + r − (b − ε) / s long.
inline double longest_leg(double half_width) { return 60.0 + 2.0 - (half_width - 0.05) / kSlope; }

}  // namespace planish::test
