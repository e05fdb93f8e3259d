// A change is tried by a search that ends at its first plan, within what is left of its share of
// the work; obstacles of the shop's own tools are kept from one to the next.
#include "proposing.hpp"

#include "blocked_way.hpp"
#include "plan_search.hpp"
#include "prepared.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace planish::brake_detail {
namespace {

constexpr std::int64_t kLeastChecks = 20;  // that a change counts as, for what is made ready

std::set<int> lines_of(const std::vector<FittingTools>& fitting, int punch) {
  std::set<int> lines;
  for (int line = 0; line < std::ssize(fitting); ++line)
    if (std::ranges::count(fitting[line].pairs, punch, &ToolPair::punch)) lines.insert(line);
  return lines;
}

BrakeTools without_likes(BrakeTools tools, const Workpiece& work, const PlanOptions& options) {
  const auto fitting = mapped(
      work.lines, [&](const BrakeLine& line) { return fitting_tools(line, tools, options); });
  std::vector<int> kept;
  for (int punch = 0; punch < std::ssize(tools.punches); ++punch) {
    const std::set<int> lines = lines_of(fitting, punch);
    const bool adds = std::ranges::none_of(kept, [&](int other) {
      return are_alike(tools.punches[other], tools.punches[punch]) &&
             std::ranges::includes(lines_of(fitting, other), lines);
    });
    if (adds) kept.push_back(punch);
  }
  tools.punches = mapped(kept, [&](int punch) { return tools.punches[punch]; });
  return tools;
}

std::vector<BlockedBend> in_the_way_of(const Plan& plan) {
  std::vector<BlockedBend> all = plan.blocked;
  all.insert(all.end(), plan.in_the_way.begin(), plan.in_the_way.end());
  return all;
}

}  // namespace

bool are_alike(const Punch& a, const Punch& b) {
  const auto ears = [](const Punch& punch) {
    const Ears none{}, &of = punch.ears ? *punch.ears : none;
    return std::array{of.left, of.right, of.height, of.reach};
  };
  return a.profile == b.profile && a.angle.radians() == b.angle.radians() &&
         a.max_force == b.max_force && a.segments == b.segments && ears(a) == ears(b);
}

Trying::Trying(const Sheet& sheet, const Layout& layout, const BrakeTools& tools,
               const PlanOptions& options, const Plan& plan, const ProposalOptions& trying,
               const Progress& progress)
    : sheet_(sheet),
      layout_(layout),
      all_tools_(tools),
      tools_(tools),
      options_(options),
      plan_(plan),
      others_(trying.others),
      progress_(progress),
      until_(trying.until),
      left_(trying.checks),
      blocked_(in_the_way_of(plan)) {
  auto work = work_for(options, plan_.large);
  if (work) work_ = std::move(*work);
  tools_ = without_likes(tools, work_, options);
  obstacles_ = std::make_shared<ToolRoom>(tools_, options.clearance);
  own_tools_ = tools_;
}

Result<Workpiece> Trying::work_for(const PlanOptions& options,
                                   const std::vector<LargeBend>& large) const {
  return workpiece_of(sheet_, layout_, workpiece_options(sheet_.thickness, tools_, options, large));
}

void Trying::share_out(int shares, int of) {
  left_ += std::max<std::int64_t>(share_, 0);
  share_ = left_ * shares / of;
  left_ -= share_;
}

bool Trying::is_spent() const {
  return share_ <= 0 || Clock::now() >= until_ || progress_.should_stop();
}

bool Trying::can_bend(Workpiece work, const BrakeTools& tools, PlanOptions options,
                      std::vector<BlockedBend>* reasons) {
  if (reasons) reasons->clear();
  if (is_spent()) return false;
  const std::chrono::duration<double> time = until_ - Clock::now();
  options.limits.first = true;
  options.limits.reasons = reasons != nullptr;
  options.limits.seconds = std::min(options.limits.seconds, time.count());
  options.limits.checks = share_;
  share_ -= kLeastChecks;
  const StrokeInputs inputs = stroke_inputs(std::move(work), tools, options);
  if (line_without_tool(inputs)) return false;
  StageCache cache(inputs, &tools == &tools_ ? obstacles_ : nullptr);
  const auto search = search_plan(cache, progress_);
  const bool ordered = search && (search->status == PlanStatus::optimal ||
                                  search->status == PlanStatus::feasible);
  if (search && !ordered && reasons) {
    for (int line = 0; line < inputs.lines(); ++line)
      if (std::ranges::count(search->blocked, line))
        reasons->push_back(brake_detail::blocked(cache, search->furthest, line, until_));
  }
  share_ -= cache.checks();
  return ordered;
}

bool Trying::can_bend_in_full(const PlanOptions& options) {
  const std::int64_t share = std::exchange(share_, left_ > 0 ? options.limits.checks : 0);
  const bool can = can_bend(work_, tools_, options);
  share_ = share;
  return can;
}

void Trying::propose(Proposal proposal) {
  if (first_) proposal.also = {*first_};
  found.push_back(std::move(proposal));
}

void Trying::change_first(BrakeTools tools, Proposal first) {
  change_nothing_first();
  tools_ = std::move(tools);
  obstacles_ = std::make_shared<ToolRoom>(tools_, options_.clearance);
  std::vector<BlockedBend> blocked;
  if (!can_bend(work_, tools_, options_, &blocked) && !blocked.empty())
    blocked_ = std::move(blocked);
  first_ = std::move(first);
}

void Trying::change_nothing_first() {
  if (!first_) return;
  first_.reset();
  tools_ = own_tools_;
  obstacles_ = std::make_shared<ToolRoom>(tools_, options_.clearance);
  blocked_ = in_the_way_of(plan_);
}

std::vector<BlockedBend> Trying::hits() const {
  std::vector<BlockedBend> all = blocked_;
  std::erase_if(all, [](const BlockedBend& one) { return !one.hits; });
  return all;
}

int Trying::body_of(FlangeId flange) const {
  for (int i = 0; i < std::ssize(work_.bodies); ++i)
    if (work_.bodies[i].flange == flange) return i;
  return -1;
}

int Trying::line_of(BendId bend) const {
  for (int i = 0; i < std::ssize(work_.lines); ++i)
    if (std::ranges::count(work_.lines[i].bends, bend)) return i;
  return -1;
}

bool Trying::has(Proposal::Kind kind) const {
  return std::ranges::count(found, kind, &Proposal::kind) > 0;
}

}  // namespace planish::brake_detail
