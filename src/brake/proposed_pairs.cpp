// Two changes of tools where one does not do. A first one is taken whole, and what is in the way
// then leads to the second, of which the least is found as if it were alone; then as few tools as
// will do get segments.
#include "proposed_pairs.hpp"

#include "proposed_tools.hpp"

#include <algorithm>
#include <utility>

namespace planish::brake_detail {
namespace {

using Kind = Proposal::Kind;
using Second = void (*)(Trying&);

constexpr std::size_t kMostPunches = 6;  // that are tried as a first change

struct First {
  BrakeTools tools;
  Proposal change;
  std::vector<Second> seconds = {};  ///< that are tried beside it
};

First segments_for(const Trying& trying, const std::vector<std::string>& ids) {
  return {with_segments(trying.own_tools(), ids),
          {.kind = Kind::segments, .tools = ids},
          {try_lower_ears, try_short_punch, try_punches, try_dies, try_taller}};
}

/// Those with ears first: a lip is what mostly takes two changes.
std::vector<First> firsts_of(Trying& trying) {
  std::vector<First> firsts{segments_for(trying, ids_of(trying.own_tools()))};
  std::vector<Punch> punches = punches_to_get(trying);
  std::ranges::stable_partition(punches, [](const Punch& one) { return one.ears.has_value(); });
  punches.resize(std::min(punches.size(), kMostPunches));
  for (const Punch& punch : punches)
    firsts.push_back({with_punch(trying.own_tools(), punch),
                      proposal_of(trying, punch),
                      {try_segments, try_lower_ears, try_short_punch, try_taller, try_dies}});
  return firsts;
}

/// Whether it helps besides the first change; what is found is kept.
bool helps(Trying& trying, const First& first, Second second) {
  trying.change_first(first.tools, first.change);
  second(trying);
  return !trying.found.empty();
}

/// Leaves what is found with segments for as few tools as will do.
void narrow_segments(Trying& trying, Second second) {
  std::vector<Proposal> least = trying.found;
  const std::vector<std::string> all = least.front().also.front().tools;
  fewest(all, [&](std::span<const std::string> some) {
    trying.found.clear();
    const bool does = helps(trying, segments_for(trying, {some.begin(), some.end()}), second);
    if (does) least = trying.found;
    return does;
  });
  trying.found = std::move(least);
}

}  // namespace

void try_pairs(Trying& trying) {
  const std::vector<First> firsts = firsts_of(trying);
  int left = 2;  // one share for narrowing, one for what is tried after
  for (const First& first : firsts)
    left += static_cast<int>(first.seconds.size());
  for (const First& first : firsts)
    for (const Second second : first.seconds) {
      trying.share_out(1, left--);
      if (!helps(trying, first, second)) continue;
      trying.share_out(1, 2);
      if (first.change.kind == Kind::segments) narrow_segments(trying, second);
      trying.change_nothing_first();
      return;
    }
  trying.change_nothing_first();
}

}  // namespace planish::brake_detail
