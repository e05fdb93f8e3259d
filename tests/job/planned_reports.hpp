#pragma once

#include "job/sample_reports.hpp"
#include "support/sample_strokes.hpp"

#include <planish/job/report.hpp>

namespace planish::test {

/// The sample with a second bend at x = 20, its hole nearer to y = 0, and a plan of two strokes.
inline job::Report planned_report() {
  job::Report report = sample_report();
  report.flat.openings[0].loop = {Arc{{70, 15}, 5.0, 0.0, -2.0 * std::numbers::pi}};
  FlatBend second = report.flat.bends[0];
  second.id = "B2";
  second.bend = BendId{1};
  second.direction = BendDirection::up;
  second.angle = Angle::degrees(30);
  second.lines = {Segment{{20, 0}, {20, 60}}};
  second.length = 60.0;
  report.flat.bends.push_back(second);
  report.layout.placement.push_back(Isometry2::Identity());
  Plan plan;
  plan.status = PlanStatus::optimal;
  plan.cost = 7.5;
  plan.turn_overs = 1;
  plan.rotations = 2;
  plan.tool_changes = 3;
  plan.ungauged = 4;
  plan.states = 17;
  plan.strokes = {stroke_at_40(), stroke_at_20()};
  report.plan = plan;
  return report;
}

/// The same, with what is in the way of B2 instead of strokes.
inline job::Report infeasible_report() {
  job::Report report = planned_report();
  Plan& plan = *report.plan;
  plan.status = PlanStatus::infeasible;
  plan.strokes.clear();
  BlockedBend blocked;
  blocked.bend = BendId{1};
  blocked.hits = ToolName{ToolKind::punch, "P88"};
  blocked.with = FlangeId{3};
  blocked.depth = 3.175;
  blocked.at_turn = Angle::degrees(72);
  plan.blocked = {blocked};
  Proposal smaller;
  smaller.kind = Proposal::Kind::smaller_v;
  smaller.opening = 10.16;
  smaller.tools = {"V10-88", "V10-85"};
  plan.proposals = {smaller};
  return report;
}

}  // namespace planish::test
