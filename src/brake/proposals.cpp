// What would make an infeasible part possible. Each kind of change is tried within its share of
// the time; the least that does is found by doubling and halving, which takes for granted that
// more of a change helps no less, until it does harm elsewhere. Each is told only if it was
// planned again (bend.md#proposals).
#include "blocked_way.hpp"
#include "changed_work.hpp"
#include "obstruction.hpp"
#include "plan_search.hpp"
#include "prepared.hpp"

#include <planish/brake/proposals.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace planish {
namespace {

using namespace brake_detail;

constexpr double kFinest = 0.1;            // mm: to which a flange is told
constexpr double kMostOfFlange = 0.5;      // by which one may be shorter: else it is another part
constexpr double kMostOfWeb = 10.0;        // thicknesses by which one may be wider
constexpr double kTallest = 300.0;         // mm: by which punches may be taller
constexpr double kStepOfPunch = 10.0;      // mm
constexpr double kNarrowestV = 3.0;        // thicknesses: a narrower one cuts
constexpr double kOneOpening = 1e-3;       // mm
constexpr std::int64_t kLeastChecks = 20;  // that a change counts as, for what is made ready
constexpr std::size_t kMostSwaps = 28;     // of 8 bends in an order

using Kind = Proposal::Kind;

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

/// Tries changes, each within its share of the time.
class Trying {
 public:
  Trying(const Sheet& sheet, const Layout& layout, const BrakeTools& tools,
         const PlanOptions& options, const Plan& plan, const ProposalOptions& trying,
         const Progress& progress)
      : sheet_(sheet),
        layout_(layout),
        tools_(tools),
        options_(options),
        plan_(plan),
        others_(trying.others),
        progress_(progress),
        until_(trying.until),
        left_(trying.checks) {
    auto work = work_for(options, plan_.large);
    if (work) work_ = std::move(*work);
    obstacles_ = std::make_shared<ToolRoom>(tools, options.clearance);
  }

  std::vector<Proposal> all() {
    if (work_.lines.empty()) return {};
    const std::vector<void (Trying::*)()> kinds{
        &Trying::try_rolled, &Trying::try_orders,  &Trying::try_openings,
        &Trying::try_longer, &Trying::try_wider,   &Trying::try_punches,
        &Trying::try_taller, &Trying::try_shorter, &Trying::try_split};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      // What one kind leaves of its share the others may use.
      share_ = left_ / static_cast<std::int64_t>(kinds.size() - i);
      left_ -= share_;
      (this->*kinds[i])();
      left_ += std::max<std::int64_t>(share_, 0);
    }
    return std::move(found_);
  }

 private:
  Result<Workpiece> work_for(const PlanOptions& options,
                             const std::vector<LargeBend>& large) const {
    return workpiece_of(sheet_, layout_,
                        workpiece_options(sheet_.thickness, tools_, options, large));
  }

  /// Whether an order is found in what is left of the share; if not, `reasons` gets what is in the
  /// way of bends.
  bool can_bend(Workpiece work, const BrakeTools& tools, PlanOptions options,
                std::vector<BlockedBend>* reasons = nullptr) {
    if (reasons) reasons->clear();
    const std::chrono::duration<double> time = until_ - Clock::now();
    if (share_ <= 0 || time.count() <= 0.0 || progress_.should_stop()) return false;
    options.limits.first = true;
    options.limits.reasons = reasons != nullptr;
    options.limits.seconds = std::min(options.limits.seconds, time.count());
    options.limits.checks = share_;
    share_ -= kLeastChecks;
    const StrokeInputs inputs = stroke_inputs(std::move(work), tools, options);
    if (line_without_tool(inputs)) return false;
    StageCache cache(inputs, &tools == &tools_ ? obstacles_ : nullptr);
    const auto search = search_plan(cache, progress_);
    const bool found = search && (search->status == PlanStatus::optimal ||
                                  search->status == PlanStatus::feasible);
    if (search && !found && reasons) {
      for (int line = 0; line < inputs.lines(); ++line)
        if (std::ranges::count(search->blocked, line))
          reasons->push_back(brake_detail::blocked(cache, search->furthest, line, until_));
    }
    share_ -= cache.checks();
    return found;
  }
  bool can_bend(const BrakeTools& tools) { return can_bend(work_, tools, options_); }

  /// Where another way was asked for: else these bends are rolled already.
  void try_rolled() {
    Proposal proposal{.kind = Kind::rolled};
    std::vector<LargeBend> large = plan_.large;
    for (LargeBend& one : large)
      if (std::exchange(one, {one.bend, Forming::rolled}).forming != Forming::rolled)
        proposal.bends.push_back(one.bend);
    if (proposal.bends.empty()) return;
    auto work = work_for(options_, large);
    if (work && can_bend(std::move(*work), tools_, options_)) found_.push_back(std::move(proposal));
  }

  void try_orders() {
    const std::vector<BendId>& order = options_.begin_with;
    if (order.empty()) return;
    PlanOptions changed = options_;
    std::size_t tried = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size() && tried < kMostSwaps; ++j, ++tried) {
        changed.begin_with = order;
        std::swap(changed.begin_with[i], changed.begin_with[j]);
        if (!can_bend(work_, tools_, changed)) continue;
        found_.push_back({.kind = Kind::swap, .bends = {order[i], order[j]}});
        return;
      }
    changed.begin_with.clear();
    if (can_bend(work_, tools_, changed)) found_.push_back({.kind = Kind::any_order});
  }

  /// Openings of all V that some line may be pressed over now.
  std::set<double> taken() const {
    std::set<double> openings;
    for (const BrakeLine& line : work_.lines)
      for (const ToolPair& pair : fitting_tools(line, tools_, options_).pairs)
        openings.insert(tools_.dies[pair.die].opening);
    return openings;
  }

  void try_openings() {
    const std::set<double> now = taken();
    std::set<double, std::greater<>> openings;
    for (const Die& die : tools_.dies)
      if (die.opening >= kNarrowestV * sheet_.thickness && !now.empty() &&
          die.opening < *now.rbegin() - kOneOpening && !now.contains(die.opening))
        openings.insert(die.opening);
    for (const double opening : openings) {
      PlanOptions changed = options_;
      changed.opening = opening;
      auto work = work_for(changed, plan_.large);
      if (!work || !can_bend(std::move(*work), tools_, changed)) continue;
      Proposal proposal{.kind = Kind::smaller_v, .opening = opening};
      for (const Die& die : tools_.dies)
        if (std::abs(die.opening - opening) < kOneOpening) proposal.tools.push_back(die.id);
      found_.push_back(std::move(proposal));
      return;
    }
  }

  /// The shop's own punch of that shape; null if it has none.
  const Punch* own(const Punch& punch) const {
    const auto same = std::ranges::find_if(tools_.punches, [&](const Punch& one) {
      return one.profile == punch.profile && one.tip_radius == punch.tip_radius;
    });
    return same == tools_.punches.end() ? nullptr : &*same;
  }
  /// Also with ears if that has them.
  bool has(const Punch& punch) const {
    const Punch* same = own(punch);
    return same && (same->ears || !punch.ears);
  }

  BrakeTools with(const Punch& punch) const {
    BrakeTools more = tools_;
    more.punches.push_back(punch);
    return more;
  }

  void try_punches() {
    if (!others_) return;
    BrakeTools more = tools_;
    for (const Punch& punch : others_->punches)
      if (!has(punch)) more.punches.push_back(punch);
    if (more.punches.size() == tools_.punches.size() || !can_bend(more)) return;
    for (const Punch& punch : others_->punches) {
      if (has(punch) || !can_bend(with(punch))) continue;
      const Punch* same = own(punch);
      found_.push_back(
          {.kind = Kind::punch, .tools = {same ? same->id : punch.id}, .ears = same != nullptr});
      return;
    }
  }

  /// What is in the way in some stage.
  std::vector<BlockedBend> blocked() const {
    std::vector<BlockedBend> all = plan_.blocked;
    all.insert(all.end(), plan_.in_the_way.begin(), plan_.in_the_way.end());
    return all;
  }

  /// The same, of what hits a tool.
  std::vector<BlockedBend> hits() const {
    std::vector<BlockedBend> all = blocked();
    std::erase_if(all, [](const BlockedBend& one) { return !one.hits; });
    return all;
  }

  void try_taller() {
    const std::vector<BlockedBend> hits = this->hits();
    const bool above = std::ranges::any_of(
        hits, [](const BlockedBend& one) { return is_above(one.hits->kind); });
    if (!above || !can_bend(with_taller_punches(tools_, kTallest))) return;
    double too_low = 0.0, enough = kTallest;
    while (enough - too_low > kStepOfPunch) {
      const double middle = kStepOfPunch * std::round((too_low + enough) / (2.0 * kStepOfPunch));
      (can_bend(with_taller_punches(tools_, middle)) ? enough : too_low) = middle;
    }
    found_.push_back({.kind = Kind::taller_punches, .by = enough});
  }

  int body_of(FlangeId flange) const {
    for (int i = 0; i < std::ssize(work_.bodies); ++i)
      if (work_.bodies[i].flange == flange) return i;
    return -1;
  }

  int line_of(BendId bend) const {
    for (int i = 0; i < std::ssize(work_.lines); ++i)
      if (std::ranges::count(work_.lines[i].bends, bend)) return i;
    return -1;
  }

  /// The flange that hits, one on the way from it to the bend, or another: with another tool it is
  /// another that hits.
  void try_shorter() {
    std::set<ChangedBody> tried;
    for (const BlockedBend& hit : hits()) {
      if (!hit.with) continue;
      const int line = line_of(hit.bend), body = body_of(*hit.with);
      if (line < 0 || body < 0) continue;
      for (const ChangedBody& one : bodies_to_change(work_, body, line))
        if (tried.insert(one).second && resizes(one, Kind::shorter_flange)) return;
    }
  }

  /// The web of a narrow Z.
  void try_wider() {
    if (std::ranges::count(found_, Kind::longer_flanges, &Proposal::kind)) return;
    for (const BlockedBend& one : blocked()) {
      const int line = line_of(one.bend);
      if (line < 0 || (one.hits && is_above(one.hits->kind))) continue;
      for (const int side : work_.lines[line].bodies)
        if (is_web(work_, {side, line}) && resizes({side, line}, Kind::longer_flanges)) return;
    }
  }

  bool resizes(const ChangedBody& one, Kind kind) {
    const auto [body, near] = one;
    const double most = kind == Kind::shorter_flange
                            ? kMostOfFlange * most_shorter(work_, body, near)
                            : kMostOfWeb * work_.thickness;
    const auto steps = static_cast<int>(most / kFinest);
    const auto does = [&](int step) {
      const double by = step * kFinest;
      return can_bend(
          kind == Kind::shorter_flange ? shortened(work_, body, near, by) : widened(work_, one, by),
          tools_, options_);
    };
    if (steps < 1 || !work_.bodies[body].flange) return false;
    // Too much makes it shorter than the die needs.
    int little = 0, enough = 0;
    for (int step = 10; enough == 0 && little < steps; step *= 2) {
      step = std::min(step, steps);
      (does(step) ? enough : little) = step;
    }
    if (enough == 0) return false;
    while (enough - little > 1) {
      const int middle = (little + enough) / 2;
      (does(middle) ? enough : little) = middle;
    }
    found_.push_back(
        {.kind = kind, .by = enough * kFinest, .flanges = {*work_.bodies[body].flange}});
    return true;
  }

  /// A body that ends too near to a line for its die, seen from there.
  struct ShortSide {
    int line = 0;
    double reach = 0.0, lacks = 0.0;
  };

  /// All that end too near to a bend for its die, each by what the shortest of them lacks. Behind a
  /// side that is long enough another may show that is not.
  void try_longer() {
    constexpr int kMostRounds = 4;
    std::map<int, ShortSide> sides;  // by body
    double by = 0.0;
    std::vector<BlockedBend> blocked = this->blocked();
    for (int round = 0; round < kMostRounds && add_short_sides(blocked, by, sides); ++round) {
      for (const auto& [body, side] : sides)
        by = std::max(by, side.lacks);
      Workpiece work = work_;
      Proposal proposal{.kind = Kind::longer_flanges, .by = by};
      for (const auto& [body, side] : sides) {
        if (!can_lengthen(work, body, side.line)) return;
        work = lengthened(work, body, side.line, side.reach, by);
        proposal.flanges.push_back(*work_.bodies[body].flange);
      }
      if (!can_bend(std::move(work), tools_, options_, &blocked)) continue;
      found_.push_back(std::move(proposal));
      return;
    }
  }

  /// Those that are in the way when each told before is longer `by`; false if there are none.
  bool add_short_sides(const std::vector<BlockedBend>& blocked, double by,
                       std::map<int, ShortSide>& sides) {
    bool any = false;
    for (const BlockedBend& one : blocked) {
      const int body = one.with ? body_of(*one.with) : -1, line = line_of(one.bend);
      if (one.needed <= one.reach || body < 0 || line < 0) continue;
      const double lacks = kFinest * std::ceil((one.needed - one.reach) / kFinest);
      const bool is_new = sides.try_emplace(body, ShortSide{line, one.reach, 0.0}).second;
      sides[body].lacks = std::max(sides[body].lacks, is_new ? lacks : by + lacks);
      any = true;
    }
    return any;
  }

  void try_split() {
    if (work_.lines.size() < 2) return;  // two plates are no plan
    std::vector<int> lines;
    const auto add = [&](BendId bend) {
      const int line = line_of(bend);
      if (line >= 0 && !std::ranges::count(lines, line)) lines.push_back(line);
    };
    for (const BlockedBend& one : plan_.blocked)
      add(one.bend);
    for (const BendId bend : plan_.unformed)
      add(bend);
    for (const BendId bend : sheet_.bends.ids())
      add(bend);
    for (const int line : lines) {
      if (work_.lines[line].press_line) continue;
      const auto halves = split_at(work_, line);
      const bool both = std::ranges::all_of(halves, [&](const Workpiece& half) {
        return half.lines.empty() || can_bend(half, tools_, options_);
      });
      if (!both) continue;
      found_.push_back({.kind = Kind::split, .bends = work_.lines[line].bends});
      return;
    }
  }

  const Sheet& sheet_;
  const Layout& layout_;
  const BrakeTools& tools_;
  const PlanOptions& options_;
  const Plan& plan_;
  const BrakeTools* others_;
  const Progress& progress_;
  Clock::time_point until_;
  std::int64_t left_, share_ = 0;  ///< of the work, of all kinds and of this one
  Workpiece work_;
  std::shared_ptr<ToolRoom> obstacles_;
  std::vector<Proposal> found_;
};

}  // namespace

std::vector<Proposal> proposals(const Sheet& sheet, const Layout& layout, const BrakeTools& tools,
                                const PlanOptions& options, const Plan& infeasible,
                                const ProposalOptions& trying, const Progress& progress) {
  return Trying(sheet, layout, tools, options, infeasible, trying, progress).all();
}

}  // namespace planish
