#include "bend_spans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

// Bends that hold, but that a shop would ask about (connect.md#the-report). They are judged by
// ratios, so no limit depends on the size of the part, and none refuses it.

namespace planish::job {
namespace {

// A bend this many times longer from plate to plate than it is wide.
constexpr double kManyTimes = 5.0;
constexpr double kHalfTurn = 180.0;

using Said = std::optional<std::string>;

std::string between(const FittedBend& bend, const PlateStructure& structure) {
  return fmt::format("between \"{}\" and \"{}\"", structure.plates[bend.plates[0]].id,
                     structure.plates[bend.plates[1]].id);
}

Said round_the_back(const FittedBend& bend) {
  if (bend.edge_kind == EdgeKind::facing || bend.frame.parallel()) return std::nullopt;
  if (bend.angle.degrees() <= kHalfTurn) return std::nullopt;
  return fmt::format(
      "turns {:.4g}° round the back of the plates; edges that face each other would need {:.4g}°",
      bend.angle.degrees(), kHalfTurn - bend.frame.beta.degrees());
}

Said long_span(const FittedBend& bend) {
  if (bend.reach <= kManyTimes * bend.joined) return std::nullopt;
  return fmt::format(
      "is {:.4g} mm long from plate to plate and {:.4g} mm wide: {:.3g} times as "
      "long as wide",
      bend.reach, bend.joined, bend.reach / bend.joined);
}

Said unused_edge(const FittedBend& bend) {
  const double unused = std::min(bend.unused[0], bend.unused[1]);
  if (unused <= bend.joined) return std::nullopt;
  return fmt::format(
      "is {:.4g} mm wide, and the edges of the plates on its tangent lines have "
      "{:.4g} and {:.4g} mm more",
      bend.joined, bend.unused[0], bend.unused[1]);
}

Said edges_beside(const FittedBend& bend) {
  if (!bend.beside) return std::nullopt;
  return fmt::format(
      "joins edges that lie beside each other, {:.4g} mm apart along the bend, so it never runs "
      "straight from one plate to the other",
      *bend.beside);
}

Vec2 middle_of(const FlatBend& bend) {
  const Segment& line = bend.lines[bend.lines.size() / 2];
  return 0.5 * (line.a + line.b);
}

}  // namespace

std::vector<Finding> span_findings(const ConnectReport& report) {
  struct Look {
    const char* code;
    Said (*said)(const FittedBend&);
  };
  std::vector<Finding> findings;
  for (const Look& look : {Look{"round_the_back", round_the_back}, Look{"long_span", long_span},
                           Look{"unused_edge", unused_edge}, Look{"edges_beside", edges_beside}})
    for (const FlatBend& flat : report.flat.bends) {
      const auto& bends = report.connection.bends;
      const auto bend = std::ranges::find(bends, flat.bend, &FittedBend::bend);
      if (bend == bends.end() || bend->plates.size() != 2 || flat.lines.empty()) continue;
      if (const Said said = look.said(*bend))
        findings.push_back(
            {look.code,
             Severity::warning,
             fmt::format("{} {} {}", flat.id, between(*bend, report.connection.structure), *said),
             {middle_of(flat)}});
    }
  return findings;
}

}  // namespace planish::job
