#include "thickness.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <tuple>

// The likely thicknesses of a solid. Large faces vote for the depths of the nearest faces opposite
// them, with the areas that they share; votes within the tolerance of each other are counted
// together, and at most three are returned. Where most of a skin is milled off, its floor outvotes
// the rim, which is as thick as the sheet. The number of voters bounds the cost, and small general
// surfaces, mostly the walls of letters, do not vote.

namespace planish::brep {
namespace {

/// A face's vote for the depth of an opposite face, weighted by the area that both share.
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

/// The votes of a face, nearest first. A nearer face hides what lies behind it, so all of them
/// together weigh no more than the face: a shallow recess does not outvote the sheet around it.
std::vector<Vote> votes_of(const SolidModel& model, const std::vector<Outline>& outlines, int a) {
  constexpr double kLeastShare = 0.1;  // of the smaller face: less is a coincidence
  constexpr double kEven = 0.1;        // spread, of the depth
  std::vector<Vote> votes;
  for (int b = 0; b < std::ssize(outlines); ++b) {
    if (a == b || outlines[b].flat.empty()) continue;
    const auto seen = opposite(model, outlines, a, b);
    if (!seen || seen->depth <= 0) continue;
    if (seen->overlap < kLeastShare * std::min(outlines[a].area, outlines[b].area)) continue;
    if (seen->spread > kEven * seen->depth) continue;
    votes.push_back({seen->depth, seen->overlap});
  }
  std::ranges::sort(votes, {}, &Vote::depth);
  double open = outlines[a].area;
  for (Vote& vote : votes) {
    vote.area = std::min(vote.area, open);
    open -= vote.area;
  }
  std::erase_if(votes, [](const Vote& vote) { return vote.area <= 0.0; });
  return votes;
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

/// Depths that agree with the areas that they share, heaviest first.
std::vector<Vote> vote_rows(const SolidModel& model, const std::vector<Outline>& outlines,
                            double tolerance) {
  std::vector<Vote> votes;
  for (const int face : voters(model, outlines))
    for (const Vote& vote : votes_of(model, outlines, face))
      votes.push_back(vote);
  std::vector<Vote> rows = counted(std::move(votes), tolerance);
  std::ranges::sort(rows, std::ranges::greater(), &Vote::area);
  return rows;
}

}  // namespace

std::vector<double> likely_thicknesses(const SolidModel& model,
                                       const std::vector<Outline>& outlines, double tolerance) {
  constexpr double kWorthTrying = 0.15;  // of the heaviest
  constexpr size_t kMost = 3;
  const std::vector<Vote> rows = vote_rows(model, outlines, tolerance);
  std::vector<double> depths;
  for (const Vote& row : rows)
    if (depths.size() < kMost && row.area >= kWorthTrying * rows.front().area)
      depths.push_back(row.depth);
  return depths;
}

std::vector<double> milled_thicknesses(const SolidModel& model,
                                       const std::vector<Outline>& outlines, double tolerance) {
  constexpr double kRim = 0.02;  // of the heaviest: a narrower rim is hardly seen
  constexpr size_t kMost = 3;
  const std::vector<Vote> rows = vote_rows(model, outlines, tolerance);
  std::vector<double> depths;
  for (const Vote& row : rows)
    if (row.area >= kRim * rows.front().area && row.depth > (1 + tolerance) * rows.front().depth)
      depths.push_back(row.depth);
  std::ranges::sort(depths);
  if (depths.size() > kMost) depths.resize(kMost);
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
  const auto votes = votes_of(model, outlines, largest);
  if (votes.empty()) return {};
  return std::ranges::max_element(votes, {}, &Vote::area)->depth;
}

}  // namespace planish::brep
