// Finds rips that open a closed sheet (math.md#rips): a largest spanning tree places the faces, and
// the joints that do not fit there are ripped. What the tree takes first is the choice, tried in
// three ways. Ripped corners are set back less, which can make others fit worse: so the search
// repeats with what is open, a few rounds at most. A rip is only named if what it opens passes the
// caller's check.

#include "placement.hpp"
#include "rip_joint.hpp"
#include "set_back.hpp"
#include "unplaced.hpp"

#include <planish/base/union_find.hpp>
#include <planish/sheet/rip.hpp>
#include <planish/sheet/topology.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <queue>
#include <utility>

namespace planish {
namespace {

using namespace sheet_detail;

/// More rips than this make no part of one sheet.
constexpr std::size_t kMostRips = 64;

/// Which joints a sheet keeps before others.
enum class Keep {
  smooth,    ///< bends that are drawn, then the longest: the shortest corners are ripped
  longest,   ///< the shortest rips
  near_root  ///< what surrounds the largest face: walls fall apart as petals
};

/// A joint that does not fit, how far it is off, mm, and whether it is a corner between walls.
struct Misfit {
  int joint = 0;
  double off = 0.0;
  bool corner = false;
};

/// How many flanges and bends away from the root each one is, over joints that have a rank.
std::vector<double> steps_from(int root, const Sheet& sheet, const Topology& topology,
                               const std::vector<JointRank>& ranks) {
  std::vector<double> steps(topology.node_count(), topology.node_count());
  std::queue<int> front;
  steps[root] = 0.0;
  for (front.push(root); !front.empty(); front.pop())
    for (const int number : topology.joints_of(front.front())) {
      const Joint& joint = sheet.joints[number];
      for (const FaceId face : {joint.a.face, joint.b.face}) {
        const int node = topology.node_of(face);
        if (!ranks[number] || steps[node] <= steps[front.front()] + 1.0) continue;
        steps[node] = steps[front.front()] + 1.0;
        front.push(node);
      }
    }
  return steps;
}

/// Ranks for a tree of what is kept. Joints that cannot be ripped come first; those that do not fit
/// by themselves have none.
std::vector<JointRank> ranks_for(Keep keep, const Sheet& sheet, const Topology& topology,
                                 Layout& layout, double tolerance) {
  std::vector<JointRank> ranks;
  const auto node = [&](const BorderRef& ref) { return topology.node_of(ref.face); };
  for (const Joint& joint : sheet.joints) {
    ranks.emplace_back();
    if (node(joint.a) == node(joint.b) || own_mismatch(sheet, layout, joint) > tolerance) continue;
    const bool smooth = keep == Keep::smooth && !joint.sharp;
    ranks.back() = {can_be_ripped(sheet, joint) ? 0.0 : 1.0, smooth ? 1.0 : 0.0,
                    joint_length(sheet, joint)};
  }
  if (keep != Keep::near_root) return ranks;
  const auto steps = steps_from(topology.node_of(layout.root), sheet, topology, ranks);
  for (int j = 0; j < std::ssize(ranks); ++j)
    if (ranks[j])
      (*ranks[j])[1] = -std::max(steps[node(sheet.joints[j].a)], steps[node(sheet.joints[j].b)]);
  return ranks;
}

/// The joints that do not fit where the others place the faces: corners first, since they are
/// straight and open, then the worst. Empty if no tree of joints that fit leads everywhere.
std::optional<std::vector<Misfit>> misfits(Keep keep, const Sheet& made,
                                           const FlattenOptions& options) {
  auto moved = needs_setback(made) ? with_setback(made) : made;
  const Sheet& sheet = moved ? *moved : made;
  auto layout = unplaced(sheet, options);
  if (!layout) return {};
  for ([[maybe_unused]] const Face& face : sheet.faces)
    layout->placement.push_back(Isometry2::Identity());
  const Topology topology(sheet);
  const double tolerance = options.closure_tolerance;
  const auto ranks = ranks_for(keep, sheet, topology, *layout, tolerance);
  auto placed = placed_over(ranks, sheet, topology, *layout);
  if (!placed) return {};
  layout->placement = std::move(placed->placement);
  std::vector<Misfit> found;
  for (int j = 0; j < std::ssize(sheet.joints); ++j)
    if (const double off = mismatch(sheet, *layout, sheet.joints[j]); off > tolerance)
      found.push_back({j, off, sheet.joints[j].sharp.has_value()});
  std::ranges::stable_sort(found, [](const Misfit& a, const Misfit& b) {
    return std::pair(a.corner, a.off) > std::pair(b.corner, b.off);
  });
  return found;
}

/// The parts that joints make of the faces. Those of one flange need not be joined.
int parts_of(const Sheet& sheet) {
  UnionFind parts(static_cast<int>(sheet.faces.size()));
  for (const Joint& joint : sheet.joints)
    parts.unite(index_of(joint.a.face), index_of(joint.b.face));
  return parts.count();
}

tl::unexpected<Error> no_rips() { return fail(ErrorCode::closed_loop, "No rips open the sheet."); }

/// The rips of one way to choose what is kept, if what they open passes.
Result<std::vector<int>> rips_keeping(Keep keep, const Sheet& sheet, FlattenOptions options,
                                      const SheetCheck& passes) {
  constexpr int kRounds = 8;  // corners that are set back move others, so that more is ripped then
  std::vector<int> edges;
  Sheet open = sheet;
  for (int round = 0; round < kRounds; ++round) {
    const auto found = misfits(keep, open, options);
    if (!found || found->empty()) return no_rips();
    for (const Misfit& misfit : *found) {
      const Joint& joint = open.joints[misfit.joint];
      if (!can_be_ripped(open, joint)) return no_rips();
      const int edge = *open[joint.a].edge;
      if (std::ranges::find(edges, edge) == edges.end()) edges.push_back(edge);
    }
    if (edges.size() > kMostRips) return no_rips();
    auto cut = ripped(sheet, edges);
    if (!cut || parts_of(*cut) > parts_of(sheet)) return no_rips();
    const auto passed = passes(*cut);
    if (passed) return edges;
    if (passed.error().code != ErrorCode::closed_loop) return tl::unexpected(passed.error());
    open = std::move(*cut);
    options.bend_k.clear();  // by number, of which rips may have taken some
  }
  return no_rips();
}

/// A refusal and what is added to its sentence.
Error continued(Error refusal, const std::string& text) {
  if (refusal.message.ends_with('.')) refusal.message.pop_back();
  refusal.message += text;
  return refusal;
}

}  // namespace

Result<std::vector<int>> rips_to_open(const Sheet& sheet, const FlattenOptions& options,
                                      const SheetCheck& passes) {
  Result<std::vector<int>> best = no_rips();
  for (const Keep keep : {Keep::smooth, Keep::longest, Keep::near_root}) {
    auto rips = rips_keeping(keep, sheet, options, passes);
    if (rips) return rips;
    if (best.error().code == ErrorCode::closed_loop) best = std::move(rips);
  }
  return best;
}

Error loop_refusal(const Sheet& sheet, const Error& closed, const FlattenOptions& options,
                   const SheetCheck& passes) {
  const auto rips = rips_to_open(sheet, options, passes);
  if (!rips) switch (rips.error().code) {
      case ErrorCode::closed_loop:
      case ErrorCode::unsupported_shape:  // corners without room are mostly closed all around
        return continued(closed, ", and no rips along its edges open it.");
      case ErrorCode::overlap:
        return continued(closed, ", and rips along its edges leave a pattern that covers itself.");
      default:
        return rips.error();
    }
  const int edge = rips->front();
  const auto first = std::ranges::find_if(
      sheet.joints, [&](const Joint& joint) { return sheet[joint.a].edge == edge; });
  const std::string between = between_faces(sheet, *first);
  const bool one = rips->size() == 1;
  Error refusal = continued(
      closed, one ? fmt::format("; a rip along the edge {} would open it.", between)
                  : fmt::format("; rips along {} edges would open it, first along the edge {}.",
                                rips->size(), between));
  refusal.where = fmt::format("edge {} {}", edge, between);
  return refusal;
}

}  // namespace planish
