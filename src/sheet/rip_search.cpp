// Finds rips that open a closed sheet (math.md#rips): a largest spanning tree places the faces, and
// the joints that do not fit there are ripped. What the tree takes first is the choice, tried in
// three ways. Ripped corners are set back less, which can make others fit worse: so the search
// repeats with what is open, a few rounds at most. A rip is only named if what it opens passes the
// caller's check.

#include "placement.hpp"
#include "refusals.hpp"
#include "rip_joint.hpp"
#include "set_back.hpp"
#include "unplaced.hpp"

#include <planish/base/union_find.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/places.hpp>
#include <planish/sheet/rip.hpp>
#include <planish/sheet/topology.hpp>

#include <algorithm>
#include <optional>
#include <queue>
#include <string>
#include <utility>

// Where to rip a sheet that does not lie flat (math.md#rips). A layout keeps joints by rank: those
// that cannot be ripped, then smooth or long ones, or what surrounds the root; joints that do not
// fit then are the rips, corners first, then the worst, one round after another. Three ways to rank
// are tried, and what they open must pass the same checks as any sheet.

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
      (*ranks[j])[1] = -(steps[node(sheet.joints[j].a)] + steps[node(sheet.joints[j].b)]);
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
  std::ranges::stable_sort(found, std::ranges::greater(), [](const Misfit& misfit) {
    return std::pair(misfit.corner, misfit.off);
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

tl::unexpected<Error> no_rips() { return fail(refuse::no_rips); }

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
    if (passed.error().code != code::closed_loop) return pass_on(passed);
    open = std::move(*cut);
    options.bend_k.clear();  // by number, of which rips may have taken some
  }
  return no_rips();
}

/// A refusal and what would help.
Error continued(Error refusal, const Error& more) {
  say_after(refusal, more);
  return refusal;
}

/// The edges as an option has them: "21,25".
std::string edges_text(const std::vector<int>& edges) {
  std::string text;
  for (const int edge : edges)
    text += (text.empty() ? "" : ",") + std::to_string(edge);
  return text;
}

const Joint& joint_at(const Sheet& sheet, int edge) {
  return *std::ranges::find_if(sheet.joints,
                               [&](const Joint& joint) { return sheet[joint.a].edge == edge; });
}

/// The places are those of the rips; of the loop nothing is shown any more.
Error opened_by(const std::vector<int>& rips, const Sheet& sheet, const Error& closed) {
  const Joint& first = joint_at(sheet, rips.front());
  Facts facts{{"edge", edge_at(sheet, first, rips.front())}, {"edges", edges_text(rips)}};
  if (rips.size() > 1) facts.emplace_back("count", rips.size());
  for (std::size_t i = 1; i < rips.size(); ++i)
    facts.emplace_back("next", edge_at(sheet, joint_at(sheet, rips[i]), rips[i]));
  Error refusal = error_of(rips.size() == 1 ? refuse::one_rip : refuse::many_rips, facts,
                           text_of(place::edge(rips.front())) + " " + between_faces(sheet, first));
  say_before(refusal, words_of(closed));
  refusal.numbers.insert(refusal.numbers.begin(), closed.numbers.begin(), closed.numbers.end());
  return refusal;
}

}  // namespace

Result<std::vector<int>> rips_to_open(const Sheet& sheet, const FlattenOptions& options,
                                      const SheetCheck& passes) {
  Error best = no_rips().value();
  for (const Keep keep : {Keep::smooth, Keep::longest, Keep::near_root}) {
    auto rips = rips_keeping(keep, sheet, options, passes);
    if (rips) return rips;
    if (best.code == code::closed_loop) best = std::move(rips.error());
  }
  return tl::unexpected(std::move(best));
}

Error loop_refusal(const Sheet& sheet, const Error& closed, const FlattenOptions& options,
                   const SheetCheck& passes) {
  const auto rips = rips_to_open(sheet, options, passes);
  if (!rips) {
    const ErrorCode& why = rips.error().code;
    // Corners without room are mostly closed all around.
    if (why == code::closed_loop || why == code::unsupported_shape)
      return continued(closed, error_of(refuse::no_rips, {}));
    if (why == code::overlap) return continued(closed, error_of(refuse::rips_overlap, {}));
    return rips.error();
  }
  return opened_by(*rips, sheet, closed);
}

}  // namespace planish
