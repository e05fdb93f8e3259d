// Tools that would do. The least that does is found by halving, which takes for granted that more
// of a change helps no less.
#include "proposed_tools.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace planish::brake_detail {
namespace {

using Kind = Proposal::Kind;

constexpr double kTallest = 300.0;     // mm: by which punches may be taller
constexpr double kStepOfPunch = 10.0;  // mm
constexpr double kNarrowestV = 3.0;    // thicknesses: a narrower one cuts
constexpr double kOneOpening = 1e-3;   // mm
const std::vector<double> kCommonSet{10, 15, 20, 40, 50, 100, 100, 200, 300};  // mm
constexpr double kStepOfFoot = 5.0, kLowestFoot = 10.0;                        // mm, of ears
/// By how much a punch may be short of each end: in thicknesses, in mm, of the shortest line.
constexpr double kShortInThicknesses = 15.0, kShortest = 20.0, kShortOfLine = 1.0 / 6.0;

double height_of(const Punch& punch) {
  double top = 0.0;
  for (const Vec2& p : punch.profile)
    top = std::max(top, p.y());
  return top;
}

/// A punch whose upper half is moved up, and the beam with it.
Punch taller(Punch punch, double by) {
  const double top = height_of(punch);
  for (Vec2& p : punch.profile)
    if (p.y() > 0.5 * top) p.y() += by;
  punch.raises_beam += by;
  return punch;
}

/// These punches, each of which then holds the upper beam higher.
BrakeTools with_taller_punches(BrakeTools tools, std::span<const std::string> of, double by) {
  for (Punch& punch : tools.punches)
    if (std::ranges::count(of, punch.id) > 0) punch = taller(std::move(punch), by);
  return tools;
}

/// With ears whose feet are at most so high.
BrakeTools with_low_ears(BrakeTools tools, double height) {
  for (Punch& punch : tools.punches)
    if (punch.ears) punch.ears->height = std::min(punch.ears->height, height);
  return tools;
}

bool lacks_segments(const BlockedBend& one) { return one.why && one.why->code == "no_segments"; }

bool hits_punch(const Trying& trying) {
  const std::vector<BlockedBend> hits = trying.hits();
  return std::ranges::any_of(
      hits, [](const BlockedBend& one) { return one.hits->kind == ToolKind::punch; });
}

/// Openings of all V that some line may be pressed over now.
std::set<double> taken(const Trying& trying) {
  std::set<double> openings;
  for (const BrakeLine& line : trying.work().lines)
    for (const ToolPair& pair : fitting_tools(line, trying.tools(), trying.options()).pairs)
      openings.insert(trying.tools().dies[pair.die].opening);
  return openings;
}

/// The shop's own punch of that shape; null if it has none.
const Punch* own(const Trying& trying, const Punch& punch) {
  const auto same = std::ranges::find_if(trying.all_tools().punches, [&](const Punch& one) {
    return one.profile == punch.profile && one.tip_radius == punch.tip_radius;
  });
  return same == trying.all_tools().punches.end() ? nullptr : &*same;
}
/// Also with ears if that has them.
bool has(const Trying& trying, const Punch& punch) {
  const Punch* same = own(trying, punch);
  return same && (same->ears || !punch.ears);
}

}  // namespace

std::vector<std::string> ids_of(const BrakeTools& tools) {
  std::vector<std::string> ids;
  for (const Punch& punch : tools.punches)
    ids.push_back(punch.id);
  for (const Die& die : tools.dies)
    ids.push_back(die.id);
  return ids;
}

BrakeTools with_segments(BrakeTools tools, std::span<const std::string> of) {
  const auto add = [&](auto& tool) {
    if (std::ranges::count(of, tool.id) > 0)
      tool.segments.insert(tool.segments.end(), kCommonSet.begin(), kCommonSet.end());
  };
  std::ranges::for_each(tools.punches, add);
  std::ranges::for_each(tools.dies, add);
  return tools;
}

BrakeTools with_punch(BrakeTools tools, const Punch& punch) {
  tools.punches.push_back(punch);
  return tools;
}

void try_openings(Trying& trying) {
  const std::set<double> now = taken(trying);
  std::set<double, std::greater<>> openings;
  for (const Die& die : trying.tools().dies)
    if (die.opening >= kNarrowestV * trying.sheet().thickness && !now.empty() &&
        die.opening < *now.rbegin() - kOneOpening && !now.contains(die.opening))
      openings.insert(die.opening);
  for (const double opening : openings) {
    PlanOptions changed = trying.options();
    changed.opening = opening;
    auto work = trying.work_for(changed, trying.plan().large);
    if (!work || !trying.can_bend(std::move(*work), trying.tools(), changed)) continue;
    Proposal proposal{.kind = Kind::smaller_v, .opening = opening};
    for (const Die& die : trying.tools().dies)
      if (std::abs(die.opening - opening) < kOneOpening) proposal.tools.push_back(die.id);
    trying.propose(std::move(proposal));
    return;
  }
}

void try_segments(Trying& trying) {
  const std::vector<std::string> ids = ids_of(trying.tools());
  const auto does = [&](std::span<const std::string> some) {
    return trying.can_bend(with_segments(trying.tools(), some));
  };
  if (std::ranges::none_of(trying.blocked(), lacks_segments) || !does(ids)) return;
  const auto needed = fewest(ids, does);
  trying.propose({.kind = Kind::segments, .tools = {needed.begin(), needed.end()}});
}

std::vector<Punch> punches_to_get(const Trying& trying) {
  if (!trying.others()) return {};
  std::vector<Punch> punches = trying.others()->punches;
  std::ranges::stable_sort(punches, std::greater(),
                           [](const Punch& one) { return one.angle.degrees(); });
  std::ranges::stable_partition(punches, [&](const Punch& one) { return own(trying, one); });
  std::vector<Punch> wanted;
  for (const Punch& punch : punches)
    if (!has(trying, punch) &&
        std::ranges::none_of(wanted, [&](const Punch& one) { return are_alike(one, punch); }))
      wanted.push_back(punch);
  return wanted;
}

Proposal proposal_of(const Trying& trying, const Punch& punch) {
  const Punch* same = own(trying, punch);
  return {.kind = Kind::punch, .tools = {same ? same->id : punch.id}, .ears = same != nullptr};
}

/// The bluntest that does.
void try_punches(Trying& trying) {
  const std::vector<Punch> punches = punches_to_get(trying);
  const auto does = std::ranges::find_if(punches, [&](const Punch& punch) {
    return trying.can_bend(with_punch(trying.tools(), punch));
  });
  if (does != punches.end()) trying.propose(proposal_of(trying, *does));
}

/// Where a die is in the way or too wide.
void try_dies(Trying& trying) {
  const bool by_die = std::ranges::any_of(trying.blocked(), [](const BlockedBend& one) {
    return one.hits ? !is_above(one.hits->kind) : one.needed > one.reach;
  });
  if (!trying.others() || !by_die) return;
  for (const Die& die : trying.others()->dies) {
    const bool owned = std::ranges::any_of(trying.all_tools().dies, [&](const Die& one) {
      return one.profile == die.profile && one.opening == die.opening;
    });
    if (owned) continue;
    BrakeTools more = trying.tools();
    more.dies.push_back(die);
    if (!trying.can_bend(more)) continue;
    trying.propose({.kind = Kind::die, .tools = {die.id}});
    return;
  }
}

void try_lower_ears(Trying& trying) {
  double highest = 0.0;
  for (const Punch& punch : trying.tools().punches)
    if (punch.ears) highest = std::max(highest, punch.ears->height);
  const auto does = [&](double height) {
    return trying.can_bend(with_low_ears(trying.tools(), height));
  };
  double low = kLowestFoot, high = highest;
  if (high <= low || !hits_punch(trying) || !does(low)) return;
  while (high - low > kStepOfFoot && !trying.is_spent()) {
    const double middle = std::max(low + kStepOfFoot,
                                   kStepOfFoot * std::floor((low + high) / (2.0 * kStepOfFoot)));
    (does(middle) ? low : high) = middle;
  }
  trying.propose({.kind = Kind::lower_ears, .by = low});
}

/// To a millimetre.
void try_short_punch(Trying& trying) {
  const double thickness = trying.sheet().thickness;
  double most = std::min(kShortInThicknesses * thickness, kShortest);
  for (const BrakeLine& line : trying.work().lines)
    most = std::min(most, kShortOfLine * line.length());
  const auto does = [&](double shortfall) {
    PlanOptions changed = trying.options();
    changed.shortfall = shortfall;
    return trying.can_bend(trying.work(), trying.tools(), changed);
  };
  double little = std::floor(trying.options().shortfall.value_or(thickness)),
         enough = std::floor(most);
  const bool lacks = std::ranges::any_of(trying.blocked(), lacks_segments);
  if (enough <= little || !(lacks || hits_punch(trying)) || !does(enough)) return;
  while (enough - little > 1.0 && !trying.is_spent()) {
    const double middle = std::floor(0.5 * (little + enough));
    (does(middle) ? enough : little) = middle;
  }
  trying.propose({.kind = Kind::short_punch, .by = enough});
}

void try_taller(Trying& trying) {
  const std::vector<std::string> ids = mapped(trying.tools().punches, &Punch::id);
  const auto does = [&](double by) {
    return trying.can_bend(with_taller_punches(trying.tools(), ids, by));
  };
  double deepest = 0.0;  // what is in the way, above
  for (const BlockedBend& one : trying.hits())
    if (is_above(one.hits->kind)) deepest = std::max(deepest, one.depth);
  if (deepest == 0.0) return;
  double too_low = 0.0, enough = kStepOfPunch * std::ceil(deepest / kStepOfPunch);
  if (enough >= kTallest || !does(enough)) {
    too_low = std::min(enough, kTallest - kStepOfPunch);
    enough = kTallest;
    if (!does(enough)) return;
  }
  while (enough - too_low > kStepOfPunch && !trying.is_spent()) {
    const double middle = kStepOfPunch * std::round((too_low + enough) / (2.0 * kStepOfPunch));
    (does(middle) ? enough : too_low) = middle;
  }
  if (trying.is_spent() && enough - too_low > kStepOfPunch) return;  // far more than is needed
  const auto needed = fewest(ids, [&](std::span<const std::string> some) {
    return trying.can_bend(with_taller_punches(trying.tools(), some, enough));
  });
  Proposal proposal{.kind = Kind::taller_punches, .by = enough};
  if (needed.size() < ids.size()) proposal.tools.assign(needed.begin(), needed.end());
  if (needed.size() == 1) {
    proposal.tools = {needed.front()};
    proposal.height = enough + height_of(*std::ranges::find(trying.tools().punches, needed.front(),
                                                            &Punch::id));
  }
  trying.propose(std::move(proposal));
}

}  // namespace planish::brake_detail
