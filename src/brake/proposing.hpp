#pragma once

#include "changed_work.hpp"
#include "stroke_inputs.hpp"
#include "tool_room.hpp"

#include <planish/brake/proposals.hpp>

#include <memory>

namespace planish::brake_detail {

/// Of the same shape but for the radius of the tip, as strong, and of the same segments.
bool are_alike(const Punch& a, const Punch& b);

/// What a proposal is tried with: the sheet that cannot be bent, and the work that may still be
/// done on this kind of change.
class Trying {
 public:
  Trying(const Sheet& sheet, const Layout& layout, const BrakeTools& tools,
         const PlanOptions& options, const Plan& plan, const ProposalOptions& trying,
         const Progress& progress);

  const BrakeTools& all_tools() const { return all_tools_; }
  /// Without punches that stand and reach as another that is kept, and fit no other line; as a
  /// first change leaves them.
  const BrakeTools& tools() const { return tools_; }
  /// The same before a first change.
  const BrakeTools& own_tools() const { return own_tools_; }
  const PlanOptions& options() const { return options_; }
  const Plan& plan() const { return plan_; }
  const Workpiece& work() const { return work_; }
  const Sheet& sheet() const { return sheet_; }
  const BrakeTools* others() const { return others_; }

  Result<Workpiece> work_for(const PlanOptions& options, const std::vector<LargeBend>& large) const;

  /// Whether an order is found in what is left of the share; if not, `reasons` gets what is in the
  /// way of bends.
  bool can_bend(Workpiece work, const BrakeTools& tools, PlanOptions options,
                std::vector<BlockedBend>* reasons = nullptr);
  bool can_bend(const BrakeTools& tools) { return can_bend(work_, tools, options_); }
  bool can_bend(Workpiece work) { return can_bend(std::move(work), tools_, options_); }
  /// With as much work as a plan may take.
  bool can_bend_in_full(const PlanOptions& options);

  /// Whether a change may have failed for want of work or time alone.
  bool is_spent() const;
  /// The checks that what follows may take; what a kind leaves of its share the others may use.
  void share_out(int shares, int of);

  /// What is in the way in some stage, and of that what hits a tool.
  const std::vector<BlockedBend>& blocked() const { return blocked_; }
  std::vector<BlockedBend> hits() const;
  /// −1: there is none.
  int body_of(FlangeId flange) const;
  int line_of(BendId bend) const;

  /// Notes a change by which it can be bent.
  void propose(Proposal proposal);
  /// From now on a second change is looked for, beside a first one that gives these tools and does
  /// not do by itself.
  void change_first(BrakeTools tools, Proposal first);
  void change_nothing_first();

  std::vector<Proposal> found = {};
  bool has(Proposal::Kind kind) const;

 private:
  const Sheet& sheet_;
  const Layout& layout_;
  const BrakeTools& all_tools_;
  BrakeTools tools_;
  const PlanOptions& options_;
  const Plan& plan_;
  const BrakeTools* others_;
  const Progress& progress_;
  std::chrono::steady_clock::time_point until_;
  std::int64_t left_, share_ = 0;  ///< of the work, of all kinds and of this one
  Workpiece work_;
  std::shared_ptr<ToolRoom> obstacles_;
  BrakeTools own_tools_;                ///< before a first change
  std::optional<Proposal> first_ = {};  ///< that change
  std::vector<BlockedBend> blocked_;    ///< with it, or without
};

}  // namespace planish::brake_detail
