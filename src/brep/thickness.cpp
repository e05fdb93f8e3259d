#include "thickness.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

// The likely thicknesses of a solid. Large faces vote for the depth of the nearest face opposite
// them, ledges left out, with the area that both share; votes within the tolerance of each other
// are counted together, and at most three are returned. The number of voters bounds the cost, and
// small general surfaces, mostly the walls of letters, do not vote.

namespace planish::brep {
namespace {

/// A face's vote for the depth of its nearest opposite face, weighted by the area that both share.
struct Vote {
  double depth = 0.0;
  double area = 0.0;
};

/// General surfaces are expensive to compare, and most are walls of engraved letters.
bool is_general(const SolidFace& face) {
  const auto* surface = std::get_if<Developable>(&face.surface);
  return surface && std::holds_alternative<Ruled>(*surface);
}

/// The faces that vote, largest first: large ones decide, and their number bounds the cost. Small
/// general ones do not vote.
std::vector<int> voters(const SolidModel& model, const std::vector<Outline>& outlines) {
  constexpr size_t kMost = 60;
  constexpr double kWorthwhile = 0.05;  // of the largest face
  double largest = 0.0;
  for (const Outline& outline : outlines)
    largest = std::max(largest, outline.area);
  std::vector<int> faces;
  for (int f = 0; f < std::ssize(outlines); ++f)
    if (!outlines[f].flat.empty() &&
        (!is_general(model.faces[f]) || outlines[f].area > kWorthwhile * largest))
      faces.push_back(f);
  std::ranges::sort(faces, [&](int a, int b) { return outlines[a].area > outlines[b].area; });
  if (faces.size() > kMost) faces.resize(kMost);
  return faces;
}

/// The depths of the faces opposite a face, each with the area that both share.
std::vector<Vote> opposite_depths(const SolidModel& model, const std::vector<Outline>& outlines,
                                  int a) {
  constexpr double kLeastShare = 0.1;  // of the smaller face: less is a coincidence
  constexpr double kEven = 0.1;        // spread, of the depth
  std::vector<Vote> found;
  for (int b = 0; b < std::ssize(outlines); ++b) {
    if (a == b || outlines[b].flat.empty()) continue;
    const auto seen = opposite(model, outlines, a, b);
    if (!seen || seen->depth <= 0 || seen->spread > kEven * seen->depth) continue;
    if (seen->overlap < kLeastShare * std::min(outlines[a].area, outlines[b].area)) continue;
    found.push_back({seen->depth, seen->overlap});
  }
  std::ranges::stable_sort(found, {}, &Vote::depth);
  return found;
}

/// The nearest opposite face; the ledges of counterbores and grooves are nearer than the other
/// skin, but share little with a face.
std::optional<Vote> vote_of(const SolidModel& model, const std::vector<Outline>& outlines, int a) {
  constexpr double kLedge = 0.3;  // of the largest area shared at one depth
  constexpr double kSameDepth = 0.01;
  const std::vector<Vote> found = opposite_depths(model, outlines, a);
  const auto shared = [&](const Vote& vote) {
    return sum_of(found, [&](const Vote& other) {
      return std::abs(other.depth - vote.depth) <= kSameDepth * vote.depth ? other.area : 0.0;
    });
  };
  double largest = 0.0;
  for (const Vote& vote : found)
    largest = std::max(largest, shared(vote));
  const auto nearest = std::ranges::find_if(
      found, [&](const Vote& vote) { return shared(vote) >= kLedge * largest; });
  if (nearest == found.end() || nearest->area <= 0) return {};
  return *nearest;
}

/// Merges votes within the tolerance of each other, with their mean depth and total area.
std::vector<Vote> counted(std::vector<Vote> votes, double tolerance) {
  std::ranges::sort(votes, {}, [](const Vote& vote) { return std::pair(vote.depth, vote.area); });
  std::vector<Vote> rows;
  for (size_t first = 0; first < votes.size();) {
    double area = 0.0;
    double moment = 0.0;
    size_t i = first;
    for (; i < votes.size() && votes[i].depth <= votes[first].depth * (1 + tolerance); ++i) {
      area += votes[i].area;
      moment += votes[i].depth * votes[i].area;
    }
    rows.push_back({moment / area, area});
    first = i;
  }
  return rows;
}

}  // namespace

std::vector<double> likely_thicknesses(const SolidModel& model,
                                       const std::vector<Outline>& outlines, double tolerance) {
  constexpr double kWorthTrying = 0.15;  // of the heaviest
  constexpr size_t kMost = 3;
  std::vector<Vote> votes;
  for (const int face : voters(model, outlines))
    if (const auto vote = vote_of(model, outlines, face)) votes.push_back(*vote);
  std::vector<Vote> rows = counted(std::move(votes), tolerance);
  std::ranges::sort(rows, std::ranges::greater(), &Vote::area);
  std::vector<double> depths;
  for (const Vote& row : rows)
    if (depths.size() < kMost && row.area >= kWorthTrying * rows.front().area)
      depths.push_back(row.depth);
  return depths;
}

std::optional<double> plate_thickness(const SolidModel& model,
                                      const std::vector<Outline>& outlines) {
  int largest = -1;
  for (int f = 0; f < std::ssize(outlines); ++f)
    if (std::holds_alternative<Frame>(model.faces[f].surface) &&
        (largest < 0 || outlines[f].area > outlines[largest].area))
      largest = f;
  if (largest < 0) return {};
  const auto vote = vote_of(model, outlines, largest);
  if (!vote) return {};
  return vote->depth;
}

}  // namespace planish::brep
