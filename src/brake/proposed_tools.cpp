// Tools that would do. The least that does is found by halving, which takes for granted that more
// of a change helps no less.
#include "proposed_tools.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <span>

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

/// A punch whose upper half is moved up.
Punch taller(Punch punch, double by) {
  double top = 0.0;
  for (const Vec2& p : punch.profile)
    top = std::max(top, p.y());
  for (Vec2& p : punch.profile)
    if (p.y() > 0.5 * top) p.y() += by;
  return punch;
}

BrakeTools with_taller_punches(BrakeTools tools, double by) {
  for (Punch& punch : tools.punches)
    punch = taller(punch, by);
  for (Vec2& p : tools.machine.upper_beam)
    p.y() += by;
  return tools;
}

std::vector<std::string> ids_of(const BrakeTools& tools) {
  std::vector<std::string> ids;
  for (const Punch& punch : tools.punches)
    ids.push_back(punch.id);
  for (const Die& die : tools.dies)
    ids.push_back(die.id);
  return ids;
}

/// With the segments of a common set besides, of these tools.
BrakeTools with_segments(BrakeTools tools, std::span<const std::string> of) {
  const auto add = [&](auto& tool) {
    if (std::ranges::count(of, tool.id) > 0)
      tool.segments.insert(tool.segments.end(), kCommonSet.begin(), kCommonSet.end());
  };
  std::ranges::for_each(tools.punches, add);
  std::ranges::for_each(tools.dies, add);
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

BrakeTools with(const Trying& trying, const Punch& punch) {
  BrakeTools more = trying.tools();
  more.punches.push_back(punch);
  return more;
}

}  // namespace

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
    trying.found.push_back(std::move(proposal));
    return;
  }
}

/// Of as few tools as halving finds: mostly of one.
void try_segments(Trying& trying) {
  const std::vector<BlockedBend> blocked = trying.blocked();
  const std::vector<std::string> ids = ids_of(trying.tools());
  std::span<const std::string> needed(ids);
  const auto does = [&](std::span<const std::string> some) {
    return trying.can_bend(with_segments(trying.tools(), some));
  };
  if (std::ranges::none_of(blocked, lacks_segments) || !does(needed)) return;
  while (needed.size() > 1) {
    const std::size_t half = needed.size() / 2;
    if (does(needed.first(half)))
      needed = needed.first(half);
    else if (does(needed.subspan(half)))
      needed = needed.subspan(half);
    else
      break;
  }
  trying.found.push_back({.kind = Kind::segments, .tools = {needed.begin(), needed.end()}});
}

/// The bluntest that does.
void try_punches(Trying& trying) {
  if (!trying.others()) return;
  std::vector<Punch> punches = trying.others()->punches;
  std::ranges::stable_sort(punches, std::greater(),
                           [](const Punch& one) { return one.angle.degrees(); });
  std::vector<const Punch*> tried;
  for (const Punch& punch : punches) {
    const bool alike = std::ranges::any_of(
        tried, [&](const Punch* one) { return are_alike(*one, punch); });
    if (has(trying, punch) || alike) continue;
    tried.push_back(&punch);
    if (!trying.can_bend(with(trying, punch))) continue;
    const Punch* same = own(trying, punch);
    trying.found.push_back(
        {.kind = Kind::punch, .tools = {same ? same->id : punch.id}, .ears = same != nullptr});
    return;
  }
}

/// Where a die is in the way or too wide.
void try_dies(Trying& trying) {
  const std::vector<BlockedBend> blocked = trying.blocked();
  const bool by_die = std::ranges::any_of(blocked, [](const BlockedBend& one) {
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
    trying.found.push_back({.kind = Kind::die, .tools = {die.id}});
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
  trying.found.push_back({.kind = Kind::lower_ears, .by = low});
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
  const std::vector<BlockedBend> blocked = trying.blocked();
  const bool lacks = std::ranges::any_of(blocked, lacks_segments);
  if (enough <= little || !(lacks || hits_punch(trying)) || !does(enough)) return;
  while (enough - little > 1.0 && !trying.is_spent()) {
    const double middle = std::floor(0.5 * (little + enough));
    (does(middle) ? enough : little) = middle;
  }
  trying.found.push_back({.kind = Kind::short_punch, .by = enough});
}

void try_taller(Trying& trying) {
  const std::vector<BlockedBend> hits = trying.hits();
  const auto does = [&](double by) {
    return trying.can_bend(with_taller_punches(trying.tools(), by));
  };
  double deepest = 0.0;  // what is in the way, above
  for (const BlockedBend& one : hits)
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
  trying.found.push_back({.kind = Kind::taller_punches, .by = enough});
}

}  // namespace planish::brake_detail
