// Random pairs of plates: each is joined, and the result holds against measures of its own, or is
// refused, and then no choice that a person could make joins it. CONTRIBUTING.md says how it is
// run.
#include "connect_pairs/explicit_choices.hpp"
#include "connect_pairs/random_pairs.hpp"
#include "support/random_run.hpp"

#include <planish/geometry/region.hpp>
#include <planish/job/connect.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace planish::pairs {
namespace {

using Options = test::RandomRun;

job::Outcome<job::ConnectReport> joined(const PlateStructure& structure) {
  job::Request request;
  request.input = "pair.json";
  request.rules.enabled = false;
  job::PlatesFile file;
  file.structure = structure;
  return job::connect_plates(file, request);
}

Polygon polygon_on(const Frame& frame, const std::vector<Vec3>& outline) {
  Polygon polygon;
  for (const Vec3& p : outline)
    polygon.outer.push_back(frame.local2(p));
  if (ring_area(polygon.outer) < 0.0) std::ranges::reverse(polygon.outer);
  return polygon;
}

Polygon polygon_of_face(const Face& face) {
  Polygon polygon;
  for (const Border& border : face.loops.front())
    polygon.outer.push_back(point_at(border.curve, 0.0));
  return polygon;
}

// The share of a plate that its face in the sheet does not cover.
double lost_share(const Plate& plate, const Face& face) {
  const Polygon whole = polygon_on(std::get<Frame>(face.surface), plate.outline);
  // The overlay of outlines that coincide may fail for want of digits: it is made with two insets.
  double covered = 0.0;
  for (const double inset : {1e-6, 1e-5}) {
    double area = 0.0;
    for (const Overlap& part : overlaps({whole, polygon_of_face(face)}, inset, 0.0))
      area += part.area;
    covered = std::max(covered, area);
  }
  return 1.0 - covered / ring_area(whole.outer);
}

// What is wrong about a pair that was joined; empty: nothing. Sheets of plates that share a corner
// run into each other there, whatever joins them.
std::string wrong_with(const job::ConnectReport& report, bool touching) {
  constexpr double kShare = 1e-6, kLength = 1e-3, kRefold = 1e-2, kVolume = 1e-3;
  for (const Finding& finding : report.findings)
    if (finding.severity == Severity::error && !(touching && finding.code == "self_intersection"))
      return fmt::format("{}: {}", finding.code, finding.message);
  const Certificate& proof = report.certificate;
  if (!(proof.length_error <= kLength)) return fmt::format("lengths off by {}", proof.length_error);
  if (!(proof.refold_deviation.value_or(HUGE_VAL) <= kRefold))
    return fmt::format("refolded off by {}", proof.refold_deviation.value_or(HUGE_VAL));
  // Of folds the solid's mitres are left out.
  const auto ratio = proof.explained_ratio ? proof.explained_ratio : proof.volume_ratio;
  if (ratio && !(std::abs(*ratio - 1.0) <= kVolume))
    return fmt::format("area × thickness is {} of the volume", *ratio);
  const auto& plates = report.connection.structure.plates;
  for (std::size_t p = 0; p < plates.size(); ++p) {
    if (std::ranges::count(report.connection.trimmed, int(p), &TrimmedPlate::plate) > 0) continue;
    const double lost = lost_share(plates[p],
                                   report.connection.sheet[report.connection.plate_faces[p]]);
    if (!(lost <= kShare)) return fmt::format("plate {} has lost {} of its area", p, lost);
  }
  return {};
}

void keep(const Options& options, int index, const PlateStructure& structure) {
  if (options.keep.empty()) return;
  nlohmann::ordered_json json;
  json["format"] = "planish/plates";
  json["version"] = 1;
  json["thickness"] = structure.thickness;
  for (const Plate& plate : structure.plates) {
    nlohmann::ordered_json row;
    row["id"] = plate.id;
    for (const Vec3& p : plate.outline)
      row["outline"].push_back({p.x(), p.y(), p.z()});
    json["plates"].push_back(row);
  }
  std::ofstream(fmt::format("{}/pair_{}_{}.json", options.keep, options.seed, index))
      << json.dump(1);
}

std::string text_of(const BendRequest& request) {
  constexpr std::array kLaterals{"auto", "straight", "arc", "corner"};
  constexpr std::array kSurfaces{"auto", "cylinder", "cone", "general"};
  std::string text = fmt::format(
      "lateral {}, trade-off {}, surface {}", kLaterals[static_cast<std::size_t>(request.lateral)],
      request.trade_off, kSurfaces[static_cast<std::size_t>(request.surface)]);
  if (request.inside_radius) text += fmt::format(", radius {}", *request.inside_radius);
  for (std::size_t side = 0; side < 2; ++side)
    if (const auto& edges = request.edges[side])
      for (const int e : *edges)
        text += fmt::format(", {}{}", request.between[side], e);
  return text;
}

// Whether plates with a common edge can be folded there.
bool folds(PlateStructure pair) {
  BendRequest fold{.between = {pair.plates[0].id, pair.plates[1].id}, .inside_radius = 0.0};
  pair.bends = {fold};
  return joined(pair).has_value();
}

// The longest bend that joins what a shop would call one part: twice the plates' diagonals.
double largest_span(const PlateStructure& pair) {
  double sum = 0.0;
  for (const Plate& plate : pair.plates) {
    Eigen::AlignedBox3d box;
    for (const Vec3& p : plate.outline)
      box.extend(p);
    sum += box.diagonal().norm();
  }
  return 2.0 * sum;
}

// A choice that joins a refused pair; empty: there is none.
std::optional<std::string> missed_choice(const PlateStructure& pair, bool touching) {
  std::optional<std::string> missed;
  any_choice(pair, [&](const BendRequest& request) {
    PlateStructure asked = pair;
    asked.bends = {request};
    asked.largest_span = largest_span(pair);
    if (!connect(asked)) return false;
    const auto report = joined(asked);
    if (!report || !wrong_with(*report, touching).empty()) return false;
    missed = text_of(request);
    return true;
  });
  return missed;
}

struct Tally {
  int joined = 0, warned = 0, refused = 0, defects = 0;
  std::map<std::string, int> codes;  ///< of refusals and warnings
};

void examine(const Options& options, int index, Tally& tally) {
  const RandomPair pair = random_pair(options.seed, index);
  const bool touching = pair.how.starts_with("at ");
  const auto report = joined(pair.structure);
  const auto tell = [&](const std::string& what) {
    fmt::print("{} ({}): {}\n", index, pair.how, what);
    std::fflush(stdout);
    keep(options, index, pair.structure);
  };
  if (report) {
    ++(report->status() == job::Status::ok ? tally.joined : tally.warned);
    for (const Finding& finding : report->findings)
      if (finding.severity == Severity::warning) ++tally.codes["warning " + finding.code];
    const std::string wrong = wrong_with(*report, touching);
    if (wrong.empty()) return;
    // Plates nearer than their thickness at their borders run into each other whatever joins them.
    if (wrong_with(*report, true).empty() && !missed_choice(pair.structure, false)) {
      ++tally.codes["warning self_intersection that no choice avoids"];
      return;
    }
    ++tally.defects;
    tell("DEFECT: joined wrongly, " + wrong);
    return;
  }
  ++tally.refused;
  const std::string code(code_name(report.error().code));
  ++tally.codes[fmt::format("{} [{}]", pair.how, code)];
  if (pair.how == "at an edge" && folds(pair.structure)) ++tally.codes["… of them folded sharply"];
  const auto missed = missed_choice(pair.structure, touching);
  if (missed) ++tally.defects;
  if (missed || options.list)
    tell(fmt::format("{} {}: {}",
                     missed ? "DEFECT: refused, but " + *missed + " joins it;" : "refused", code,
                     report.error().message));
}

int run(const Options& options) {
  Tally tally;
  for (int i = 0; i < options.count; ++i)
    examine(options, options.first + i, tally);
  fmt::print("{} pairs: {} joined, {} with warnings, {} refused; {} defects\n", options.count,
             tally.joined, tally.warned, tally.refused, tally.defects);
  for (const auto& [code, count] : tally.codes)
    fmt::print("  {:5} {}\n", count, code);
  return tally.defects == 0 ? 0 : 1;
}

}  // namespace
}  // namespace planish::pairs

int main(int argc, char** argv) {
  const auto options = planish::test::random_run({argv + 1, argv + argc}, 60);
  if (options) return planish::pairs::run(*options);
  fmt::print(stderr, "connect_pairs {}\n", planish::test::kRandomRunUsage);
  return 2;
}
