#include "bend_spans.hpp"

#include "sentences.hpp"

#include <planish/base/message.hpp>
#include <planish/base/text.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

// Bends that hold, but that a shop would ask about (connect.md#the-report). They are judged by
// ratios, so no limit depends on the size of the part, and none refuses it.

namespace planish::job {
namespace {

// A bend this many times longer from plate to plate than it is wide.
constexpr double kManyTimes = 5.0;
constexpr double kHalfTurn = 180.0;

using Said = std::optional<Told>;

Said round_the_back(const FittedBend& bend) {
  if (bend.edge_kind == EdgeKind::facing || bend.frame.parallel()) return std::nullopt;
  if (bend.angle.degrees() <= kHalfTurn) return std::nullopt;
  return tell(say::round_the_back,
              {{"turn", bend.angle.degrees(), unit::degrees},
               {"other", kHalfTurn - bend.frame.beta.degrees(), unit::degrees}});
}

Said long_span(const FittedBend& bend) {
  if (bend.reach <= kManyTimes * bend.joined) return std::nullopt;
  return tell(say::long_span, {{"reach", bend.reach, unit::mm},
                               {"wide", bend.joined, unit::mm},
                               {"times", bend.reach / bend.joined, unit::none}});
}

Said unused_edge(const FittedBend& bend) {
  const double unused = std::min(bend.unused[0], bend.unused[1]);
  if (unused <= bend.joined) return std::nullopt;
  return tell(say::unused_edge, {{"wide", bend.joined, unit::mm},
                                 {"first", bend.unused[0], unit::mm},
                                 {"second", bend.unused[1], unit::mm}});
}

Said edges_beside(const FittedBend& bend) {
  if (!bend.beside) return std::nullopt;
  return tell(say::edges_beside, {{"apart", *bend.beside, unit::mm}});
}

Vec2 middle_of(const FlatBend& bend) {
  const Segment& line = bend.lines[bend.lines.size() / 2];
  return 0.5 * (line.a + line.b);
}

Told between(const FittedBend& bend, const FlatBend& flat, const PlateStructure& structure) {
  Facts facts{{"bend", place::at(place::bend(flat.id), middle_of(flat))}};
  for (const int plate : bend.plates)
    facts.emplace_back("plate", place::plate(structure.plates[plate].id));
  return tell(say::between_plates, facts);
}

/// Why a bend is not the shortest.
std::optional<Finding> shorter_bend(const ConnectReport& report, const FittedBend& bend,
                                    const FlatBend& flat) {
  if (!bend.passed_over) return std::nullopt;
  const PassedOver& shorter = *bend.passed_over;
  const auto edges_of = [&](std::size_t side) {
    return fmt::format("edges {} of \"{}\"", fmt::join(shorter.edges[side], ", "),
                       report.connection.structure.plates[bend.plates[side]].id);
  };
  return finding_of("shorter_bend", Severity::info, say::shorter_bend,
                    {{"bend", part_place(report.flat, PartId(bend.bend))},
                     {"span", bend.span, unit::mm},
                     {"other", fmt::format("{} and {}", edges_of(0), edges_of(1))},
                     {"shorter", shorter.span, unit::mm},
                     {"reason", going_on(shorter.why)}},
                    {middle_of(flat)});
}

std::optional<Finding> plates_trimmed(const Connection& connection) {
  if (connection.trimmed.empty()) return std::nullopt;
  Facts facts;
  double by = 0.0;
  for (const TrimmedPlate& trimmed : connection.trimmed) {
    facts.emplace_back("plate", place::plate(connection.structure.plates[trimmed.plate].id));
    by = std::max(by, trimmed.by);
  }
  facts.emplace_back("are", connection.trimmed.size() == 1 ? "is" : "are");
  facts.emplace_back("by", by, unit::mm);
  Finding finding = finding_of("plates_trimmed", Severity::info, say::plates_trimmed, facts, {});
  finding.remedies = {{"trim", "no", "Leave them as they are drawn"}};
  return finding;
}

/// The plates of a joint, and from where to where they touch.
Facts facts_of(const SharedEdge& edge, const Connection& connection) {
  Facts facts;
  for (const int plate : edge.plates)
    facts.emplace_back("plate", place::plate(connection.structure.plates[plate].id));
  const double length = (edge.to - edge.from).norm();
  facts.emplace_back("from", place::point(edge.from));
  if (length > 0.0) {
    facts.emplace_back("to", place::point(edge.to));
    facts.emplace_back("length", length, unit::mm);
  }
  return facts;
}

/// One finding for all joints, with the data of each.
Finding joints_left_open(const Connection& connection) {
  constexpr std::size_t kNamed = 3;
  const std::vector<SharedEdge>& open = connection.left_open;
  if (open.size() == 1)
    return finding_of("joint_left_open", Severity::info,
                      open[0].from == open[0].to ? say::corner_left_open : say::joint_left_open,
                      facts_of(open[0], connection), {});
  Facts facts{{"count", open.size()}};
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto id = [&](std::size_t side) {
      return connection.structure.plates[open[i].plates[side]].id;
    };
    if (i < kNamed) facts.emplace_back("first", fmt::format("\"{}\" – \"{}\"", id(0), id(1)));
    for (Fact& fact : facts_of(open[i], connection))
      facts.push_back(std::move(fact));
  }
  if (open.size() <= kNamed)
    return finding_of("joint_left_open", Severity::info, say::joints_left_open, facts, {});
  facts.emplace_back("more", open.size() - kNamed);
  return finding_of("joint_left_open", Severity::info, say::joints_left_open_more, facts, {});
}

}  // namespace

std::vector<Finding> trim_findings(const Connection& connection) {
  std::vector<Finding> findings;
  if (auto trimmed = plates_trimmed(connection)) findings.push_back(std::move(*trimmed));
  if (!connection.left_open.empty()) findings.push_back(joints_left_open(connection));
  return findings;
}

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
      const Said said = look.said(*bend);
      if (!said) continue;
      Told told = between(*bend, flat, report.connection.structure);
      say_after(told, " ", *said);
      findings.push_back(
          finding_of(look.code, Severity::warning, std::move(told), {middle_of(flat)}));
    }
  for (const FlatBend& flat : report.flat.bends)
    for (const FittedBend& bend : report.connection.bends)
      if (bend.bend == flat.bend && bend.plates.size() == 2 && !flat.lines.empty())
        if (auto finding = shorter_bend(report, bend, flat))
          findings.push_back(std::move(*finding));
  return findings;
}

}  // namespace planish::job
