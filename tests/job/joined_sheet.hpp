#pragma once

#include "connected.hpp"
#include "support/sheets.hpp"

#include <gtest/gtest.h>

namespace planish::test {

// 50 | 90° r 3 | 30, width 40, t 2, as if made of the plates "base" and "wall".
inline Connection joined() {
  Connection connection;
  connection.structure.thickness = 2.0;
  connection.structure.plates = {{"base", {}, {}}, {"wall", {}, {}}};
  connection.sheet = l_bracket();
  connection.sheet.volume.reset();  // the maker does not know it
  FittedBend bend;
  bend.request.between = {"base", "wall"};
  bend.plates = {0, 1};
  bend.edges = {{{1, 2}, {0}}};
  bend.edge_kind = EdgeKind::averted;
  bend.kind = BendKind::cone;
  bend.frame.origin = {25.4, 0, 0};
  bend.frame.beta = Angle::degrees(90);
  bend.line = {0.25, -5.08};
  bend.apex = -20.32;
  bend.angle = Angle::degrees(90);
  bend.inside_radius = 3.0;
  bend.inside_radii = {2.54, 5.08};
  bend.half_angle = Angle::degrees(12);
  bend.lateral = LateralBoundary::arc;
  bend.width = bend.joined = 50.8;
  bend.span = 25.4;
  bend.extension_area = 25.4 * 25.4;
  BendAlternative other;
  other.request = bend.request;
  other.request.edges = {std::vector<int>{3}, std::vector<int>{2}};
  other.width = 12.7;
  other.span = 2.54;
  bend.alternatives = {other};
  bend.bend = BendId{0};
  connection.bends = {bend};
  return connection;
}

inline job::ConnectReport report_of(Connection connection,
                                    const AllowanceRule& allowance = ConstantK{}) {
  job::ConnectReport report;
  report.input = "shop/plates.json";
  report.body = "plates";
  const auto error = job::finish(report, std::move(connection), allowance, {}, {});
  EXPECT_FALSE(error.has_value()) << (error ? error->message : "");
  return report;
}

}  // namespace planish::test
