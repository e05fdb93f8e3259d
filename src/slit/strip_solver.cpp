#include "strip_solver.hpp"

#include "bend_energy.hpp"
#include "first_shape.hpp"
#include "snapshot.hpp"
#include "strip_limits.hpp"
#include "strip_start.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

// Solves a strip: end conditions first, then descent among shapes that meet them (descend.cpp),
// then limits that the minimum breaks. Radii are an augmented Lagrangian, whose multipliers are
// kept between calls; planes are only a growing penalty, as a multiplier would throw the strip into
// another shape. What gets worse is taken back: a strip that would be creased to get clear stays.
// From a first shape the wanted places attract weakly at first.

namespace planish::slit_detail {
namespace {

constexpr double kFirstPenalty = 1.0;  // a tenth of the strip's length then weighs as much as its
                                       // smoothness
constexpr double kPenaltyGrowth = 4.0;
constexpr int kMostRounds = 10, kStepsOfRound = 20;
constexpr double kWorth = 20.0;  // times the objective that keeping an inequality may cost
constexpr double kRoughly = 1e-3, kFine = 1e-6;  // gains at which a start and a round end

/// The data for solving one strip.
struct Task {
  const DescentOptions& options;
  const PlanesBroken& planes_broken;

  bool stopped() const { return options.stop && options.stop(); }
};

/// A strip during its descent.
struct Course {
  StripProblem problem;
  StripSolution solution;
  int descended = 0;  ///< iterations

  double objective() const { return slit_detail::objective(problem, solution.p); }
  double radius() const { return tightest_fold(problem, solution.p).radius; }
};

Course descended(const Task& task, Course course, int iterations, double tolerance) {
  DescentOptions rest = task.options;
  rest.max_iterations = std::min(task.options.max_iterations - course.descended, iterations);
  if (rest.max_iterations <= 0) {
    course.solution.converged = false;
    return course;
  }
  rest.function_tolerance = tolerance;
  const Descent descent = descend(course.problem, course.solution.p, rest);
  course.solution.p = descent.p;
  course.solution.objective = descent.objective;
  course.solution.converged = descent.converged && !task.stopped();
  course.descended += descent.iterations;
  course.solution.iterations += descent.iterations;
  return course;
}

/// Going straight from a first shape to the places wanted leads into folds that no later step
/// undoes; so the places first attract weakly, and need not be reached accurately.
Course drawn_softly(const Task& task, Course course, double softness) {
  constexpr int kSteps = 12;
  const SlitWeights given = course.problem.weights;
  course.problem.weights.anchors = softness * given.anchors;
  course.problem.weights.seat = softness * given.seat;
  course.problem.weights.spread = softness * given.spread;
  course.problem.weights.scan = softness * given.scan;
  course = descended(task, std::move(course), kSteps, kRoughly);
  course.problem.weights = given;
  return course;
}

constexpr double kSoftly = 0.001, kLessSoftly = 0.1;

Course softly_descended(const Task& task, Course course) {
  return drawn_softly(task, drawn_softly(task, std::move(course), kSoftly), kLessSoftly);
}

/// Courses from first shapes, roughly at rest, the one of least objective first: the conditions
/// have many solutions, and which is least shows only there.
struct Courses {
  std::vector<Course> all;
  StripSolution nearest = {};            ///< if none ends where it must
  std::optional<double> runner_up = {};  ///< energy of the next best that is another shape

  void sort() {
    std::ranges::stable_sort(all, {},
                             [](const Course& course) { return course.solution.objective; });
  }
  void find_runner_up() {
    constexpr double kAnother = 0.02;  // of the energy: shapes roughly at rest differ less
    std::vector<double> energies;
    for (const Course& course : all)
      energies.push_back(bend_energy(course.problem, course.solution.p));
    for (const double energy : energies)
      if (!runner_up && std::abs(energy - energies.front()) > kAnother * energies.front())
        runner_up = energy;
  }
};

/// Many first shapes lead to the same one, which shows when they are hardly drawn yet.
Courses courses_from(const Task& task, const StripProblem& problem,
                     const std::vector<StripParameters>& shapes) {
  constexpr double kAlike = 0.03;  // radians, of each fold
  Courses courses;
  std::vector<Eigen::VectorXd> begun;
  Found nearest;
  for (const StripParameters& shape : shapes) {
    const bool has_one = !courses.all.empty() || nearest.solution.p.size() > 0;
    if (has_one && task.stopped()) break;
    Found found = met_from(problem, shape, {});
    if (!found.met()) {
      if (found.violation < nearest.violation) nearest = std::move(found);
      continue;
    }
    Course course = drawn_softly(task, {problem, std::move(found.solution)}, kSoftly);
    const Eigen::VectorXd folds = course.solution.p.head(problem.base.quads);
    if (std::ranges::any_of(begun, [&](const Eigen::VectorXd& other) {
          return (folds - other).cwiseAbs().maxCoeff() < kAlike;
        }))
      continue;
    begun.push_back(folds);
    course = drawn_softly(task, std::move(course), kLessSoftly);
    courses.all.push_back(descended(task, std::move(course), kStepsOfRound, kRoughly));
  }
  courses.nearest = std::move(nearest.solution);
  courses.sort();
  courses.find_runner_up();
  return courses;
}

/// With half as many quads, each of two.
StripProblem halved(StripProblem problem) {
  problem.base.quads /= 2;
  for (StripAnchor& anchor : problem.anchors)
    anchor.ridge = (anchor.ridge + 1) / 2;
  return problem;
}

/// Of a fine strip the first courses are those of a coarse one: its shapes differ as much, and cost
/// less.
Courses first_courses(const Task& task, const StripProblem& problem) {
  constexpr int kCoarse = 16;
  constexpr double kWorthwhile = 1.1;  // of the least objective; finer strips differ by less
  if (problem.base.quads < kCoarse || problem.base.quads % 2 != 0)
    return courses_from(task, problem, first_shapes(problem));
  const StripProblem coarse = halved(problem);
  Courses before = first_courses(task, coarse), courses;
  for (Course& course : before.all) {
    if (course.solution.objective > kWorthwhile * before.all.front().solution.objective) break;
    if (!courses.all.empty() && task.stopped()) break;
    Found found = met_from_before(problem, subdivided(coarse.base, course.solution.p));
    if (!found.met()) continue;
    course.problem = problem;
    course.solution.p = std::move(found.solution.p);
    courses.all.push_back(descended(task, std::move(course), kStepsOfRound, kRoughly));
  }
  if (courses.all.empty()) return courses_from(task, problem, first_shapes(problem));
  courses.sort();
  courses.runner_up = before.runner_up;
  return courses;
}

Course least_of(const Task& task, const StripProblem& problem) {
  Courses courses = first_courses(task, problem);
  if (courses.all.empty()) return {problem, std::move(courses.nearest)};
  Course& best = courses.all.front();
  best.descended = 0;
  best.solution.runner_up = courses.runner_up;
  return std::move(best);
}

/// From the strip's present shape, or from the first of the first shapes that leads to its end. A
/// sheet is bent first and loaded then.
Course begun(const Task& task, StripProblem problem, const StripParameters& from) {
  Found found = met_from_before(problem, from);
  if (found.met()) return {std::move(problem), std::move(found.solution)};
  if (problem.objective == SlitObjective::energy) {
    const StripLoad load = std::exchange(problem.load, {});
    Course course = least_of(task, problem);
    course.problem.load = load;
    return course;
  }
  for (const StripParameters& shape : first_shapes(problem)) {
    found = met_from(problem, shape, std::move(found));
    if (found.met()) return softly_descended(task, {std::move(problem), std::move(found.solution)});
  }
  return {std::move(problem), std::move(found.solution)};
}

/// At rest under the load: under all of it at once, or where that fails under more and more of it.
Course loaded(const Task& task, const Course& unloaded) {
  const int most = task.options.max_iterations;
  Course course = descended(task, unloaded, most, task.options.function_tolerance);
  const StripLoad load = unloaded.problem.load;
  if (load.empty() || course.solution.converged || task.stopped()) return course;
  Course slow = unloaded;
  for (const double share : {0.125, 0.25, 0.5, 0.75, 1.0}) {
    slow.problem.load = load.times(share);
    slow.descended = 0;
    slow = descended(task, std::move(slow), most, task.options.function_tolerance);
  }
  return slow.solution.converged ? slow : course;
}

std::vector<HalfSpace> planes_now_broken(const Task& task, const Course& course) {
  return task.planes_broken
             ? task.planes_broken(folded_strip(course.problem.base, course.solution.p))
             : std::vector<HalfSpace>{};
}

/// Rounds are meant to end before they converge; only the time limit matters.
bool had_time(const Task& task, const Course& course) {
  return !task.stopped() && course.descended < task.options.max_iterations;
}

enum class Planes { left_out, kept };

/// Rounds of the augmented Lagrangian until the inequalities hold.
Course held(
    const Task& task, Course course, Planes which,
    const std::function<void(const Course&)>& after_round = [](const Course&) {}) {
  course.problem.penalty = kFirstPenalty;
  for (int round = 0; round < kMostRounds && course.solution.converged &&
                      course.descended < task.options.max_iterations;
       ++round) {
    const std::vector<HalfSpace> planes = which == Planes::kept ? planes_now_broken(task, course)
                                                                : std::vector<HalfSpace>{};
    auto& inequalities = course.problem.inequalities;
    inequalities = with_broken(course.problem, course.solution.p, planes);
    if (inequalities.empty()) return course;
    const bool unbroken = planes.empty() && !is_too_tight(course.problem, course.solution.p);
    if (unbroken && firm_ones_hold(course.problem, course.solution.p) &&
        load_rests(course.problem, course.solution.p))
      return course;
    if (round > 0) {
      course.problem.penalty *= kPenaltyGrowth;
      inequalities = with_new_multipliers(course.problem, course.solution.p);
    }
    course = descended(task, std::move(course), kStepsOfRound,
                       std::max(task.options.function_tolerance, kFine));
    course.solution.converged = had_time(task, course);
    after_round(course);
  }
  return course;
}

/// The course with an earlier shape and inequalities.
Course taken_back(Course course, const StripSolution& before,
                  const std::vector<Inequality>& inequalities) {
  course.solution.p = before.p;
  course.solution.objective = before.objective;
  course.problem.inequalities = inequalities;
  return course;
}

/// If no shape was found that keeps the radii, the least tight one at moderate cost is kept.
Course radii_held(const Task& task, Course course) {
  const std::vector<Inequality> before = course.problem.inequalities;
  const double most = kWorth * course.objective();
  StripSolution widest = course.solution;
  double widest_radius = course.radius();
  course = held(task, std::move(course), Planes::left_out, [&](const Course& now) {
    if (now.radius() <= widest_radius || now.objective() > most) return;
    widest = now.solution;
    widest_radius = now.radius();
  });
  if (!task.stopped() && is_too_tight(course.problem, course.solution.p))
    return taken_back(std::move(course), widest, before);
  return course;
}

/// First only the radii. A strip that would be creased to get clear of its neighbour is left
/// unchanged.
Course all_held(const Task& task, Course course) {
  course = radii_held(task, std::move(course));
  if (!course.solution.converged || planes_now_broken(task, course).empty()) return course;
  const StripSolution before = course.solution;
  const std::vector<Inequality> needed = course.problem.inequalities;
  const double most = kWorth * course.objective();
  const bool was_too_tight = is_too_tight(course.problem, course.solution.p);
  course = held(task, std::move(course), Planes::kept);
  const bool creased = (is_too_tight(course.problem, course.solution.p) && !was_too_tight) ||
                       course.objective() > most;
  if (!task.stopped() && (creased || !planes_now_broken(task, course).empty()))
    course = taken_back(std::move(course), before, needed);
  course.solution.converged = had_time(task, course);
  return course;
}

}  // namespace

StripSolution solve_strip(StripProblem problem, const StripParameters& from,
                          const DescentOptions& options, const PlanesBroken& planes_broken) {
  const Task task{options, planes_broken};
  problem.penalty = kFirstPenalty;
  problem.min_radius *= 1.0 + kRadiusMargin;
  Course course = begun(task, std::move(problem), from);
  if (course.solution.reached) {
    course = loaded(task, course);
    course = all_held(task, std::move(course));
  }
  course.solution.inequalities = std::move(course.problem.inequalities);
  return std::move(course.solution);
}

}  // namespace planish::slit_detail
