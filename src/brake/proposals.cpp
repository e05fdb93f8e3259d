// What would make an infeasible part possible: what the shop can do at once; if nothing does, tools
// that it might get and changes of the part; if nothing does, two of these tools, or two parts.
// Each kind of change is tried within its share of the work, and told only if it was planned again
// (bend.md#proposals).
#include "proposed_pairs.hpp"
#include "proposed_shapes.hpp"
#include "proposed_tools.hpp"

#include <planish/brake/proposals.hpp>

#include <algorithm>
#include <utility>

namespace planish {
namespace {

using namespace brake_detail;
using Kind = Proposal::Kind;

constexpr int kSharesOfPairs = 6;       // of the work, for two changes
constexpr std::size_t kMostSwaps = 28;  // of 8 bends in an order

/// Where another way was asked for: else these bends are rolled already.
void try_rolled(Trying& trying) {
  Proposal proposal{.kind = Kind::rolled};
  std::vector<LargeBend> large = trying.plan().large;
  for (LargeBend& one : large)
    if (std::exchange(one, {one.bend, Forming::rolled}).forming != Forming::rolled)
      proposal.bends.push_back(one.bend);
  if (proposal.bends.empty()) return;
  auto work = trying.work_for(trying.options(), large);
  if (work && trying.can_bend(std::move(*work))) trying.propose(std::move(proposal));
}

/// Where no order does, none with two of its bends swapped does.
void try_orders(Trying& trying) {
  const std::vector<BendId>& order = trying.options().begin_with;
  if (order.empty()) return;
  PlanOptions changed = trying.options();
  changed.begin_with.clear();
  if (!trying.can_bend_in_full(changed)) return;
  std::size_t tried = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && tried < kMostSwaps; ++j, ++tried) {
      changed.begin_with = order;
      std::swap(changed.begin_with[i], changed.begin_with[j]);
      if (!trying.can_bend(trying.work(), trying.tools(), changed)) continue;
      trying.propose({.kind = Kind::swap, .bends = {order[i], order[j]}});
      return;
    }
  trying.propose({.kind = Kind::any_order});
}

/// The shop can do these at once, and the bends get as good.
bool helps_now(const Trying& trying) {
  constexpr double kSlightlyShort = 5.0;  // thicknesses: the bend goes on beyond the punch
  return std::ranges::any_of(trying.found, [&](const Proposal& one) {
    return one.kind == Kind::rolled || one.kind == Kind::swap || one.kind == Kind::any_order ||
           (one.kind == Kind::short_punch && one.by <= kSlightlyShort * trying.sheet().thickness);
  });
}

/// A kind of change, and how many shares of the work it may take.
struct Shared {
  void (*tried)(Trying&);
  int shares = 1;
};

int shares_of(const std::vector<Shared>& kinds) {
  int all = 0;
  for (const Shared& kind : kinds)
    all += kind.shares;
  return all;
}

void try_each(Trying& trying, const std::vector<Shared>& kinds, int after) {
  for (int left = shares_of(kinds) + after; const Shared& kind : kinds) {
    trying.share_out(kind.shares, left);
    left -= kind.shares;
    kind.tried(trying);
  }
}

}  // namespace

std::vector<Proposal> proposals(const Sheet& sheet, const Layout& layout, const BrakeTools& tools,
                                const PlanOptions& options, const Plan& infeasible,
                                const ProposalOptions& trying, const Progress& progress) {
  Trying tried(sheet, layout, tools, options, infeasible, trying, progress);
  if (tried.work().lines.empty()) return {};
  const std::vector<Shared> now{
      {try_rolled}, {try_orders}, {try_openings}, {try_lower_ears, 3}, {try_short_punch, 3}},
      later{{try_longer},  {try_wider},  {try_segments}, {try_punches, 3},
            {try_dies, 3}, {try_taller}, {try_shorter}};
  try_each(tried, now, shares_of(later) + kSharesOfPairs + 1);
  if (!helps_now(tried)) try_each(tried, later, kSharesOfPairs + 1);
  if (tried.found.empty()) try_pairs(tried);
  if (tried.found.empty()) try_each(tried, {{try_split}}, 0);
  return std::move(tried.found);
}

}  // namespace planish
