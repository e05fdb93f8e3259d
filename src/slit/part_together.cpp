// Neighbours that run into each other are solved as one system with their contacts, an augmented
// Lagrangian whose points of contact are found anew in every round. Which of two strips lies on the
// other where they overlap is chosen by what is missing to it; only what has moved gives way.
#include "part_together.hpp"

#include "contacts.hpp"
#include "crossing.hpp"
#include "newton.hpp"
#include "strip_limits.hpp"
#include "strip_start.hpp"
#include "strip_work.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace planish::slit_detail {
namespace {

constexpr double kFirstPenalty = 1.0, kPenaltyGrowth = 4.0, kMostPenalty = 1000.0;
constexpr int kMostRounds = 12, kStepsOfRound = 20;
constexpr double kFine = 1e-6;
constexpr double kWorth = 20.0;  // times the objective that parting may cost

/// Which strip of a pair lies on the other.
enum class Choice { nearest, left, right };

/// What an attempt to part strips has led to.
struct Parting {
  Shapes shapes;
  std::vector<StripProblem> problems = {};  ///< with the inequalities that were needed
  std::vector<bool> touches = {};           ///< by strip: contacts keep it where it is
  int together = 0;                         ///< pairs that still need the same space
  bool apart = false;
  double objective = 0.0;  ///< with what contacts cost
  int iterations = 0;
};

/// Less is better.
std::tuple<bool, int, double> rank(const Parting& parting) {
  return {!parting.apart, parting.together, parting.objective};
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
      system_.strips.push_back(std::move(problem));
      system_.held.push_back(std::ranges::find(moved, strip) == moved.end());
      shapes_.push_back(now.slot(strip).p);
    }
  }

  bool moves(int member) const { return !system_.held[member]; }
  /// How many pairs need the same space as the strips lie now.
  int together() const { return run_together(pairs_of(Choice::nearest), shapes_); }

  /// Rounds until the strips are apart and at rest.
  Parting parted(Choice choice, const DescentOptions& options) const {
    Parting now{shapes_}, best{shapes_};
    best.together = together();
    best.problems = system_.strips;
    best.touches.resize(system_.count());
    StripSystem system = system_;
    system.penalty = kFirstPenalty;
    const std::vector<StripPair> pairs = pairs_of(choice);
    for (int round = 0; round < kMostRounds; ++round) {
      if (options.stop && options.stop()) break;
      if (round > 0) {
        system.penalty = std::min(kMostPenalty, kPenaltyGrowth * system.penalty);
        raise_multipliers(system, now.shapes);
      }
      take_limits(system, pairs, now.shapes);
      DescentOptions of_round = options;
      of_round.max_iterations = kStepsOfRound;
      of_round.function_tolerance = std::max(options.function_tolerance, kFine);
      SystemDescent descent = descend_by_newton(system, std::move(now.shapes), of_round);
      now.shapes = std::move(descent.shapes);
      now.iterations += descent.iterations;
      now.objective = descent.objective;
      now.together = run_together(pairs, now.shapes);
      now.apart = now.together == 0 && holds_all(system, now.shapes);
      if (now.objective > kWorth * alone_) break;
      if (rank(now) <= rank(best))
        best = now, best.problems = system.strips, best.touches = touching(system);
      if (now.apart && descent.converged) break;
    }
    best.iterations = now.iterations;
    return best;
  }

 private:
  /// That a strip could not keep by itself.
  static void give_up_radius(StripProblem& problem) {
    problem.min_radius = 0.0;
    std::erase_if(problem.inequalities, [](const Inequality& known) {
      return std::holds_alternative<RadiusLimit>(known.what);
    });
  }

  FoldedStrip folded(const Shapes& shapes, int member) const {
    return folded_strip(system_.strips[member].base, shapes[member]);
  }
  static std::vector<bool> touching(const StripSystem& system) {
    std::vector<bool> touches(system.count());
    for (const Contact& contact : system.contacts)
      if (contact.multiplier > 0.0)
        touches[contact.here.strip] = touches[contact.there.strip] = true;
    return touches;
  }

  bool is_beside(const StripPair& pair) const {
    return strips_[pair.right] == strips_[pair.left] + 1;
  }
  double thickness() const { return now_.design->sheet.thickness; }

  std::vector<StripPair> pairs_of(Choice choice) const {
    std::vector<StripPair> pairs;
    for (int left = 0; left < system_.count(); ++left)
      for (int right = left + 1; right < system_.count(); ++right)
        if (moves(left) || moves(right)) pairs.push_back(pair_of(choice, left, right));
    return pairs;
  }

  StripPair pair_of(Choice choice, int left, int right) const {
    const FoldedStrip shape = folded(shapes_, left);
    if (choice == Choice::nearest)
      return nearest_pair(left, right, shape, folded(shapes_, right), thickness());
    return slit_detail::pair_of(left, right, shape,
                                choice == Choice::left ? OnTop::left : OnTop::right);
  }

  PlanesBroken planes_of(int member) const {
    return planes_broken(now_, strips_[member], Clear::of_mirror);
  }

  /// How many pairs need the same space.
  int run_together(const std::vector<StripPair>& pairs, const Shapes& shapes) const {
    const double pressed = kPressed * thickness();
    return static_cast<int>(std::ranges::count_if(pairs, [&](const StripPair& pair) {
      const FoldedStrip left = folded(shapes, pair.left), right = folded(shapes, pair.right);
      return (is_beside(pair) && missing(pair, left, right, thickness()).most > pressed) ||
             cross(left, right, pressed);
    }));
  }

  bool holds_all(const StripSystem& system, const Shapes& shapes) const {
    for (int member = 0; member < system.count(); ++member) {
      const StripProblem& problem = system.strips[member];
      if (moves(member) &&
          (is_too_tight(problem, shapes[member]) || !firm_ones_hold(problem, shapes[member]) ||
           !planes_of(member)(folded(shapes, member)).empty()))
        return false;
    }
    return true;
  }

  void raise_multipliers(StripSystem& system, const Shapes& shapes) const {
    const Eigen::VectorXd values = contact_values(system, shapes);
    for (int i = 0; i < std::ssize(system.contacts); ++i) {
      double& multiplier = system.contacts[i].multiplier;
      multiplier = std::max(0.0, multiplier + system.penalty * values[i]);
    }
    for (int member = 0; member < system.count(); ++member) {
      StripProblem& problem = system.strips[member];
      problem.penalty = system.penalty;
      if (moves(member)) problem.inequalities = with_new_multipliers(problem, shapes[member]);
    }
  }

  /// What strips now violate; what they violated before keeps its multiplier.
  void take_limits(StripSystem& system, const std::vector<StripPair>& pairs,
                   const Shapes& shapes) const {
    const std::vector<Contact> before = std::exchange(system.contacts, {});
    for (const StripPair& pair : pairs) {
      const FoldedStrip left = folded(shapes, pair.left), right = folded(shapes, pair.right);
      std::vector<Contact> known;
      std::ranges::copy_if(before, std::back_inserter(known), [&](const Contact& contact) {
        return std::minmax(contact.here.strip, contact.there.strip) ==
               std::minmax(pair.left, pair.right);
      });
      // Strips that are not beside each other have nothing to do with each other until they meet.
      if (!is_beside(pair) && known.empty() && !cross(left, right)) continue;
      for (Contact& contact : contacts_of(pair, left, right, thickness())) {
        const auto same = std::ranges::find_if(
            known, [&](const Contact& other) { return is_same(other, contact); });
        if (same != known.end()) contact.multiplier = same->multiplier;
        system.contacts.push_back(std::move(contact));
      }
    }
    for (int member = 0; member < system.count(); ++member) {
      StripProblem& problem = system.strips[member];
      problem.penalty = system.penalty;
      if (moves(member))
        problem.inequalities = with_broken(problem, shapes[member],
                                           planes_of(member)(folded(shapes, member)));
    }
  }

  static bool is_same(const Contact& a, const Contact& b) {
    constexpr double kAlike = 0.5, kNear = 0.25;
    const StripPoint::Share &first = a.here.shares.front(), &second = b.here.shares.front();
    return a.here.strip == b.here.strip && a.there.strip == b.there.strip &&
           first.side == second.side && first.ridge == second.ridge &&
           std::abs(first.weight - second.weight) < kNear && a.normal.dot(b.normal) > kAlike;
  }

  const Snapshot& now_;
  const std::vector<int>& strips_;
  StripSystem system_;  ///< as it begins
  Shapes shapes_;
  double alone_ = 0.0;  ///< what the strips' objectives are before they are parted
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
Parting best_parting(const Group& group, const DescentOptions& options) {
  Parting best = group.parted(Choice::nearest, options);
  if (best.apart) return best;
  int iterations = best.iterations;
  for (const Choice choice : {Choice::left, Choice::right}) {
    if (options.stop && options.stop()) break;
    Parting other = group.parted(choice, options);
    iterations += other.iterations;
    if (rank(other) < rank(best)) best = std::move(other);
  }
  best.iterations = iterations;
  return best;
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
    const Parting parting = best_parting(group, options);
    iterations += parting.iterations;
    if (!parting.apart && parting.together > 0 && parting.together >= group.together()) break;
    for (int member = 0; member < std::ssize(strips); ++member)
      if (group.moves(member))
        take_shape(now, strips[member], parting.shapes[member],
                   parting.problems[member].inequalities, parting.touches[member]);
    note_crossings(now, moved);
  }
  return iterations;
}

}  // namespace planish::slit_detail
