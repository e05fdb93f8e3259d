#include "support/real_parts.hpp"

#include <planish/job/connect.hpp>
#include <planish/job/plates_of.hpp>
#include <planish/job/unfold.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>

// The flanges of real bent parts, given as bare plates, come back as the part they were taken from:
// tree, angles, radii and flat area. The part itself is the expectation; `connect` knows nothing of
// it but its plates.

namespace planish::test {
namespace {

namespace fs = std::filesystem;

constexpr int kFewest = 2, kMost = 15;  // bends
constexpr double kAngle = 0.1;          // degrees
constexpr double kRadius = 0.01;        // mm, as the chord of the plates
constexpr double kArea = 2e-3;          // share: curved borders are polygons within the chord
constexpr double kFolded = 1e-3;        // mm: inside radii below are folds drawn sharp
constexpr double kShare = 0.97;

/// Parts that do not come back, and why.
const std::map<std::string, std::string> kNamed{
    {"sm135", "sides of two bends lean by 48°; connect keeps to 45° unless straight is asked for"},
    {"sm122", "a flange of two tabs that a strip 0.0003 mm wide holds together: no plate"}};

using FlangePair = std::pair<int, int>;
struct BendSize {
  double angle = 0.0, radius = 0.0;
};
using BendTree = std::map<FlangePair, BendSize>;

FlangePair ordered(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

int flange_of(const Sheet& sheet, FaceId face) {
  const auto* flange = std::get_if<FlangeId>(&sheet[face].part_of);
  return flange ? index_of(*flange) : -1;
}

/// The bends of a part that join two flanges. Bends with a free end, and those that go on into
/// another bend, are none of plates.
BendTree tree_of(const Sheet& sheet) {
  std::map<int, std::set<int>> joined;
  for (const Joint& joint : sheet.joints)
    for (const auto& [at, other] : {std::pair{joint.a, joint.b}, std::pair{joint.b, joint.a}}) {
      const int flange = flange_of(sheet, other.face);
      if (flange < 0) continue;
      if (joint.sharp) joined[index_of(*joint.sharp)].insert(flange);
      if (const auto* bend = std::get_if<BendId>(&sheet[at.face].part_of))
        joined[index_of(*bend)].insert(flange);
    }
  BendTree tree;
  for (const auto& [bend, flanges] : joined)
    if (flanges.size() == 2) {
      const Bend& turned = sheet[static_cast<BendId>(bend)];
      tree[ordered(*flanges.begin(), *flanges.rbegin())] = {turned.angle.degrees(),
                                                            turned.inside_radius};
    }
  return tree;
}

/// The flange whose plate it is: "3", "3a".
int flange_number(const std::string& id) { return std::stoi(id) - 1; }

BendTree tree_of(const Connection& connection) {
  BendTree tree;
  for (const FittedBend& bend : connection.bends) {
    const auto& plates = connection.structure.plates;
    tree[ordered(flange_number(plates[bend.plates[0]].id),
                 flange_number(plates[bend.plates[1]].id))] = {bend.angle.degrees(),
                                                               bend.inside_radius};
  }
  return tree;
}

/// The angle through which the sheet turns between two flanges, by their planes alone, from 0 to
/// 180°.
double between(const Sheet& sheet, const FlangePair& pair) {
  const auto normal = [&](int flange) {
    const FaceId face = sheet[static_cast<FlangeId>(flange)].faces.front();
    return outward_normal(sheet[face], parameter_box(sheet[face]).lo);
  };
  const Vec3 a = normal(pair.first), b = normal(pair.second);
  return Angle::radians(std::atan2(a.cross(b).norm(), a.dot(b))).degrees();
}

/// Why the plates of a part do not hold what it is; empty for parts of plates and bends between
/// them.
std::string not_of_plates(const Sheet& sheet, const BendTree& tree) {
  std::set<int> reached{0};
  for (std::size_t round = 0; round < tree.size(); ++round)
    for (const auto& [pair, turn] : tree)
      if (reached.count(pair.first) + reached.count(pair.second) == 1)
        reached.insert({pair.first, pair.second});
  if (reached.size() != sheet.flanges.size()) return "bends go on into bends";
  for (const auto& [pair, turn] : tree) {
    if (turn.radius < kFolded) return "drawn without a radius";
    const double angle = turn.angle > 180.0 ? 360.0 - turn.angle : turn.angle;
    if (std::abs(angle - between(sheet, pair)) > kAngle)
      return "the bend kinks: it turns by another angle than its flanges";
  }
  return {};
}

std::string difference(const BendTree& part, const BendTree& found) {
  if (part.size() != found.size() ||
      !std::equal(part.begin(), part.end(), found.begin(),
                  [](const auto& a, const auto& b) { return a.first == b.first; }))
    return "another tree";
  for (const auto& [pair, turn] : part) {
    if (std::abs(found.at(pair).angle - turn.angle) > kAngle) return "another angle";
    if (std::abs(found.at(pair).radius - turn.radius) > kRadius) return "another radius";
  }
  return {};
}

/// How the part differs that its plates are joined to; empty if it does not.
std::string brought_back(const job::UnfoldReport& part, const BendTree& tree,
                         const job::PlatesOfOptions& options) {
  const auto file = job::parse_plates(job::plates_text(job::plates_of(part.sheet, options)),
                                      "plates");
  if (!file) return file.error().message;
  job::Request request;
  request.effort = job::Effort::draft;
  const auto made = job::connect_plates(*file, request);
  if (!made) return made.error().message;
  if (auto other = difference(tree, tree_of(made->connection)); !other.empty()) return other;
  const double ratio = made->flat.area / part.flat.area;
  return std::abs(ratio - 1.0) > kArea ? "area ratio " + std::to_string(ratio) : std::string();
}

/// The part that a file holds; empty if it holds several, none, or one that is not bent.
std::optional<job::UnfoldReport> bent_part(const fs::path& path) {
  if (path.extension() != ".step" || path.stem().string().rfind("asm", 0) == 0) return std::nullopt;
  job::Request request;
  request.input = path;
  request.effort = job::Effort::draft;
  auto part = job::unfold(request);
  if (!part) return std::nullopt;
  const int bends = static_cast<int>(part->sheet.bends.size());
  if (bends < kFewest || bends > kMost) return std::nullopt;
  return std::move(*part);
}

/// Whether the whole `unfold` refuses what its draft shows.
bool overlaps_itself(const fs::path& path) {
  job::Request request;
  request.input = path;
  return !job::unfold(request);
}

TEST(PlatesOfRealParts, AreConnectedToThePartAgain) {
  if (!fs::exists(real_parts_folder())) GTEST_SKIP() << kNoRealParts;
  int parts = 0, back = 0;
  for (const auto& entry : fs::directory_iterator(real_parts_folder())) {
    const std::string name = entry.path().stem().string(), key = name.substr(0, 5);
    const auto part = bent_part(entry.path());
    if (!part) continue;
    const BendTree tree = tree_of(part->sheet);
    if (const auto why = not_of_plates(part->sheet, tree); !why.empty()) {
      std::cout << name << " is left out: " << why << "\n";
      continue;
    }
    ++parts;
    std::string bare = brought_back(*part, tree, {}),
                listed = brought_back(*part, tree, {.with_bends = true});
    if (bare.empty() && listed.empty()) {
      ++back;
      continue;
    }
    if (overlaps_itself(entry.path())) {
      --parts;
      std::cout << name << " is left out: its own pattern overlaps itself\n";
      continue;
    }
    EXPECT_TRUE(kNamed.count(key)) << name << ": " << bare << " / with bends: " << listed;
  }
  if (parts == 0) GTEST_SKIP() << kNoRealParts;
  std::cout << back << " of " << parts << " parts come back\n";
  EXPECT_GE(back, kShare * parts);
}

}  // namespace
}  // namespace planish::test
