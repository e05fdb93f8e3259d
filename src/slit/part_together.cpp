// Neighbours that run into each other are solved as one system with their contacts, an augmented
// Lagrangian whose points of contact are found anew in every round. Which of two strips lies on the
// other where they overlap is chosen by what is missing to it; only what has moved gives way.
#include "part_together.hpp"

#include "contacts.hpp"
#include "coupling.hpp"
#include "crossing.hpp"
#include "folded_strips.hpp"
#include "newton.hpp"
#include "strip_limits.hpp"
#include "strip_start.hpp"
#include "strip_work.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace planish::slit_detail {
namespace {

constexpr double kFirstPenalty = 1.0, kPenaltyGrowth = 4.0, kMostPenalty = 1000.0;
constexpr double kSofter = 1.0 / 16.0;  // where strips go on: their multipliers do the most
constexpr double kLessViolated = 0.25;  // than in the round before, else the penalty grows
constexpr int kMostRounds = 12, kRoundsOfCoupled = 30, kStepsOfRound = 20;
constexpr int kRoundsOfGap = 8;  // in which gaps go from what they are to what they should be
constexpr double kFine = 1e-8, kFineOfCoupled = 1e-5;
constexpr double kWorth = 20.0;  // times the objective that parting may cost

/// Which strip of a pair lies on the other.
enum class Choice { nearest, left, right };

/// What an attempt to part strips has led to.
struct Parting {
  Shapes shapes;
  std::vector<StripProblem> problems = {};  ///< with the inequalities that were needed
  Pressing pressing = {};                   ///< of the sheet's strips
  int together = 0;                         ///< pairs that still need the same space
  double gap_missed = 0.0;                  ///< most of all gaps, of the strips' length
  bool apart = false;
  double objective = 0.0;  ///< with what contacts cost
  int iterations = 0;
};

/// Less is better.
std::tuple<bool, int, double, double> rank(const Parting& parting) {
  return {!parting.apart, parting.together, parting.gap_missed, parting.objective};
}

/// Strips of a snapshot that are solved together.
class Group {
 public:
  Group(const Snapshot& now, const std::vector<int>& strips, const std::vector<int>& moved)
      : now_(now), strips_(strips) {
    for (const int strip : strips_) {
      StripProblem problem = problem_of(now, strip);
      problem.min_radius *= 1.0 + kRadiusMargin;
      if (now.slot(strip).state.too_tight) give_up_radius(problem);
      alone_ += now.slot(strip).state.objective;
      undivided_ += now.slot(strip).undivided > 0.0 ? now.slot(strip).undivided : kUnknown;
      system_.strips.push_back(std::move(problem));
      system_.held.push_back(!coupling() && std::ranges::find(moved, strip) == moved.end());
      shapes_.push_back(now.slot(strip).p);
    }
    at_start_ = folded_strips(system_, shapes_);
    if (coupling()) system_.bonds = bonds_of(system_.strips, coupling()->smooth);
    pressing_.penalty = now.pressing.penalty;
    for (Contact contact : now.pressing.contacts) {
      contact.here.strip = member_of(contact.here.strip);
      contact.there.strip = member_of(contact.there.strip);
      if (contact.here.strip >= 0 && contact.there.strip >= 0)
        pressing_.contacts.push_back(std::move(contact));
    }
  }

  /// Whether strips press each other from before.
  bool has_pressed() const { return !pressing_.contacts.empty(); }
  /// A strip's number here, −1 if it is not in the group.
  int member_of(int strip) const {
    const auto found = std::ranges::find(strips_, strip);
    return found == strips_.end() ? -1 : static_cast<int>(found - strips_.begin());
  }

  /// Whether strips whose quads were divided have lost by it.
  bool has_lost(const Parting& parting) const {
    constexpr double kLost = 1.04;  // finer strips differ by less
    return !coupling() && parting.objective > kLost * undivided_;
  }

  bool moves(int member) const { return !system_.held[member]; }
  /// How many pairs need the same space as the strips lie now.
  int together() const { return run_together(pairs_of(Choice::nearest), at_start_); }

  /// Rounds until the strips are apart and at rest, with what they press each other from before or
  /// from nothing.
  Parting parted(Choice choice, bool from_before, const DescentOptions& options) const {
    Parting now{shapes_}, best{shapes_};
    best.together = together();
    best.gap_missed = missed_gap(at_start_);
    best.problems = system_.strips;
    StripSystem system = system_;
    system.penalty = from_before ? std::max(kFirstPenalty, kSofter * pressing_.penalty)
                                 : kFirstPenalty;
    if (from_before) system.contacts = pressing_.contacts;
    std::vector<StripPair> pairs = pairs_of(choice);
    const DescentOptions of_round{
        kStepsOfRound, std::max(options.function_tolerance, coupling() ? kFineOfCoupled : kFine),
        options.stop};
    double before = std::numeric_limits<double>::infinity();
    for (int round = 0; round < (coupling() ? kRoundsOfCoupled : kMostRounds); ++round) {
      if (options.stop && options.stop()) break;
      if (round > 0) {
        const Eigen::VectorXd values = contact_values(system, now.shapes);
        const double violated = values.size() > 0 ? std::max(0.0, values.maxCoeff()) : 0.0;
        // While gaps are on their way, what is violated grows with what is asked for.
        const bool is_under_way = coupling() && coupling()->gap && round < kRoundsOfGap;
        if (!is_under_way && ((!from_before && !coupling()) || violated > kLessViolated * before))
          system.penalty = std::min(kMostPenalty, kPenaltyGrowth * system.penalty);
        before = violated;
        raise_multipliers(system, now.shapes, values);
      }
      take_limits(system, choice, pairs, now.shapes, std::min(1.0, (round + 1.0) / kRoundsOfGap));
      SystemDescent descent = descend_by_newton(system, std::move(now.shapes), of_round);
      now.shapes = std::move(descent.shapes);
      now.iterations += descent.iterations;
      now.objective = descent.objective;
      judge(now, pairs, system);
      if (!coupling() && now.objective > kWorth * alone_) break;
      if (rank(now) <= rank(best))
        best = now, best.problems = system.strips, best.pressing = pressing_of(system, now.shapes);
      if (now.apart && descent.converged) break;
    }
    best.iterations = now.iterations;
    return best;
  }

 private:
  static constexpr double kUnknown = std::numeric_limits<double>::infinity();

  /// That a strip could not keep by itself.
  static void give_up_radius(StripProblem& problem) {
    problem.min_radius = 0.0;
    std::erase_if(problem.inequalities, [](const Inequality& known) {
      return std::holds_alternative<RadiusLimit>(known.what);
    });
  }

  void judge(Parting& now, const std::vector<StripPair>& pairs, const StripSystem& system) const {
    const FoldedStrips all = folded_strips(system, now.shapes);
    now.together = run_together(pairs, all);
    now.gap_missed = missed_gap(all);
    now.apart = now.together == 0 && now.gap_missed == 0.0 && holds_all(system, now.shapes, all);
  }

  /// Only the strips of the whole sheet are coupled.
  const std::optional<SlitCoupling>& coupling() const { return now_.design->coupling; }

  Pressing pressing_of(StripSystem system, const Shapes& shapes) const {
    raise_contacts(system, contact_values(system, shapes));
    std::erase_if(system.contacts, [](const Contact& known) { return known.multiplier == 0.0; });
    for (Contact& contact : system.contacts) {
      contact.here.strip = strips_[contact.here.strip];
      contact.there.strip = strips_[contact.there.strip];
    }
    const double unit = system.unit();
    return {std::move(system.contacts), system.penalty, unit};
  }

  bool is_beside(const StripPair& pair) const {
    return strips_[pair.right] == strips_[pair.left] + 1;
  }
  double thickness() const { return now_.design->sheet.thickness; }

  /// Of strips that are not beside each other nothing is chosen until they meet.
  std::vector<StripPair> pairs_of(Choice choice) const {
    std::vector<StripPair> pairs;
    for (int left = 0; left < system_.count(); ++left)
      for (int right = left + 1; right < system_.count(); ++right)
        if (StripPair pair{left, right, {}}; moves(left) || moves(right))
          pairs.push_back(is_beside(pair) ? pair_of(choice, left, right) : std::move(pair));
    return pairs;
  }

  StripPair pair_of(Choice choice, int left, int right) const {
    const FoldedStrip& shape = at_start_.strips[left];
    if (choice == Choice::nearest)
      return nearest_pair(left, right, shape, at_start_.strips[right], thickness());
    return slit_detail::pair_of(left, right, shape,
                                choice == Choice::left ? OnTop::left : OnTop::right);
  }

  PlanesBroken planes_of(int member) const {
    return planes_broken(now_, strips_[member], Clear::of_mirror);
  }

  /// How many pairs need the same space.
  int run_together(const std::vector<StripPair>& pairs, const FoldedStrips& all) const {
    const double pressed = kPressed * thickness();
    return static_cast<int>(std::ranges::count_if(pairs, [&](const StripPair& pair) {
      const FoldedStrip &left = all.strips[pair.left], &right = all.strips[pair.right];
      return (is_beside(pair) && missing(pair, left, right, thickness()).most > pressed) ||
             all.cross(pair.left, pair.right, pressed);
    }));
  }

  bool holds_all(const StripSystem& system, const Shapes& shapes, const FoldedStrips& all) const {
    for (int member = 0; member < system.count(); ++member) {
      const StripProblem& problem = system.strips[member];
      if (moves(member) &&
          (is_too_tight(problem, shapes[member]) || !firm_ones_hold(problem, shapes[member]) ||
           !planes_of(member)(all.strips[member]).empty()))
        return false;
    }
    return true;
  }

  /// Of the strips' length; 0 if it cannot be seen.
  double missed_gap(const FoldedStrips& all) const {
    constexpr double kSeen = 1e-6;
    if (!coupling() || !coupling()->gap) return 0.0;
    const double missed = gap_missed(all.strips, *coupling()->gap) / system_.unit();
    return missed > kSeen ? missed : 0.0;
  }

  void raise_multipliers(StripSystem& system, const Shapes& shapes,
                         const Eigen::VectorXd& values) const {
    raise_contacts(system, values);
    for (int member = 0; member < system.count(); ++member) {
      StripProblem& problem = system.strips[member];
      problem.penalty = system.penalty;
      if (moves(member)) problem.inequalities = with_new_multipliers(problem, shapes[member]);
    }
  }

  /// What strips now violate; what they violated before keeps its multiplier.
  /// `share`: of the way from gaps as they were to those asked for.
  void take_limits(StripSystem& system, Choice choice, std::vector<StripPair>& pairs,
                   const Shapes& shapes, double share) const {
    std::map<std::pair<int, int>, std::vector<Contact>> before;
    for (Contact& contact : std::exchange(system.contacts, {}))
      before[std::minmax(contact.here.strip, contact.there.strip)].push_back(std::move(contact));
    const FoldedStrips now = folded_strips(system_, shapes);
    for (StripPair& pair : pairs) {
      const FoldedStrip &left = now.strips[pair.left], &right = now.strips[pair.right];
      const std::vector<Contact>& known = before[{pair.left, pair.right}];
      // Strips that are not beside each other have nothing to do with each other until they meet.
      if (!is_beside(pair) && known.empty() && !now.cross(pair.left, pair.right)) continue;
      if (pair.on_top.empty()) pair = pair_of(choice, pair.left, pair.right);
      std::vector<Contact> all = contacts_of(pair, left, right, thickness());
      if (coupling() && coupling()->gap && is_beside(pair)) {
        const double at_first = gap_between(at_start_.strips[pair.left],
                                            at_start_.strips[pair.right]);
        std::ranges::move(kept_gap(pair.left, pair.right, left, right,
                                   on_the_way(*coupling()->gap, at_first, share)),
                          std::back_inserter(all));
      }
      for (Contact& contact : all) {
        for (const Contact& other : known)
          if (is_same(other, contact)) contact.multiplier += other.multiplier;
        system.contacts.push_back(std::move(contact));
      }
    }
    for (int member = 0; member < system.count(); ++member) {
      StripProblem& problem = system.strips[member];
      problem.penalty = system.penalty;
      if (moves(member))
        problem.inequalities = with_broken(problem, shapes[member],
                                           planes_of(member)(now.strips[member]));
    }
  }

  const Snapshot& now_;
  const std::vector<int>& strips_;
  StripSystem system_;  ///< as it begins
  Pressing pressing_;   ///< from before, of the group's members
  Shapes shapes_;
  FoldedStrips at_start_;
  double undivided_ = 0.0;  ///< the strips' objectives before their quads were divided
  double alone_ = 0.0;      ///< what the strips' objectives are before they are parted
};

/// Whether neighbours lie so that their bodies need the same space.
bool press(const Snapshot& now, int strip) {
  const double thickness = now.design->sheet.thickness;
  if (now.slot(strip).p.size() == 0 || now.slot(strip + 1).p.size() == 0) return false;
  const FoldedStrip left = folded_of(now, strip), right = folded_of(now, strip + 1);
  const StripPair pair = nearest_pair(0, 1, left, right, thickness);
  return missing(pair, left, right, thickness).most > kPressed * thickness;
}

/// Strips that run into others, at least one of which has moved, and those beside them.
void add_together(std::vector<bool>& wanted, const Snapshot& now, const std::vector<int>& moved) {
  std::vector<bool> has_moved(now.count());
  for (const int strip : moved)
    has_moved[strip] = true;
  if (now.design->coupling && !moved.empty()) {
    for (int strip = 0; strip < now.count(); ++strip)
      wanted[strip] = now.slot(strip).p.size() > 0;
    return;
  }
  const auto want = [&](int strip) {
    for (int near = std::max(0, strip - 1); near <= std::min(now.count() - 1, strip + 1); ++near)
      if (now.slot(near).p.size() > 0) wanted[near] = true;
  };
  for (int strip = 0; strip < now.count(); ++strip) {
    if (has_moved[strip] && now.slot(strip).touches) want(strip);
    for (const int other : now.slot(strip).state.crosses)
      if (has_moved[strip] || has_moved[other]) want(strip), want(other);
    const int next = strip + 1;
    if (next < now.count() && (has_moved[strip] || has_moved[next]) && press(now, strip))
      want(strip), want(next);
  }
}

std::vector<int> those(const std::vector<bool>& wanted) {
  std::vector<int> strips;
  for (int strip = 0; strip < std::ssize(wanted); ++strip)
    if (wanted[strip]) strips.push_back(strip);
  return strips;
}

/// What parts the strips at the nearest, else the better of one strip on top everywhere and the
/// other: judged by what is left together, then by the objective.
Parting best_parting(const Group& group, bool is_coupled, const DescentOptions& options) {
  std::optional<Parting> best;
  int iterations = 0;
  const auto try_to = [&](Choice choice, bool from_before) {
    // On which side a strip lies has nothing to do with gaps where strips end.
    const bool is_enough = best && (best->apart || (is_coupled && best->together == 0)) &&
                           !(choice == Choice::nearest && group.has_lost(*best));
    if (is_enough || (best && options.stop && options.stop())) return;
    Parting other = group.parted(choice, from_before, options);
    iterations += other.iterations;
    if (!best || rank(other) < rank(*best)) best = std::move(other);
  };
  if (group.has_pressed()) try_to(Choice::nearest, true);
  for (const Choice choice : {Choice::nearest, Choice::left, Choice::right})
    try_to(choice, false);
  best->iterations = iterations;
  return *std::move(best);
}

/// Takes what strips of a group press each other, in place of what they did.
void take_pressing(Snapshot& now, const std::vector<bool>& in_group, const Pressing& pressing) {
  std::vector<Contact>& all = now.pressing.contacts;
  std::erase_if(all, [&](const Contact& known) {
    return in_group[known.here.strip] && in_group[known.there.strip];
  });
  all.insert(all.end(), pressing.contacts.begin(), pressing.contacts.end());
  now.pressing.penalty = pressing.penalty;
  now.pressing.unit = pressing.unit;
}

/// Strips that meet at a panel touch there too, as good as without pressing each other.
bool presses(const Pressing& pressing, int strip) {
  constexpr double kPresses = 0.01;  // of what is pressed most
  double most = 0.0, own = 0.0;
  for (const Contact& contact : pressing.contacts) {
    most = std::max(most, contact.multiplier);
    if (contact.here.strip == strip || contact.there.strip == strip)
      own = std::max(own, contact.multiplier);
  }
  return own > kPresses * most;
}

}  // namespace

int part_together(Snapshot& now, const std::vector<int>& moved, const DescentOptions& options) {
  constexpr int kMostGroups = 4;  // each larger by strips into which others were led
  std::vector<bool> wanted(now.count());
  int iterations = 0;
  for (int attempt = 0; attempt < kMostGroups; ++attempt) {
    const std::vector<bool> before = wanted;
    add_together(wanted, now, moved);
    if (wanted == before) break;
    const std::vector<int> strips = those(wanted);
    const Group group(now, strips, moved);
    const Parting parting = best_parting(group, now.design->coupling.has_value(), options);
    iterations += parting.iterations;
    if (!parting.apart && parting.together > 0 && parting.together >= group.together()) break;
    for (int member = 0; member < std::ssize(strips); ++member)
      if (group.moves(member))
        take_shape(now, strips[member], parting.shapes[member],
                   parting.problems[member].inequalities,
                   now.design->coupling || presses(parting.pressing, strips[member]));
    take_pressing(now, wanted, parting.pressing);
    note_crossings(now, moved);
  }
  return iterations;
}

}  // namespace planish::slit_detail
