#pragma once

#include <planish/brake/plan.hpp>

#include <chrono>
#include <cstdint>
#include <vector>

namespace planish {

/// What is tried.
struct ProposalOptions {
  const BrakeTools* others = nullptr;  ///< tools that the shop might get; may be null
  std::int64_t checks = 10'000;        ///< all kinds together, as in `StrokeLimits`
  /// A guard: after this nothing more is tried.
  std::chrono::steady_clock::time_point until = std::chrono::steady_clock::time_point::max();
};

/// Looks for changes by which an infeasible sheet can be bent: of each kind the smallest that is
/// found in time. Lengths are told to 0.1 mm, of punches to 10 mm. Requires what the plan was made
/// from.
std::vector<Proposal> proposals(const Sheet& sheet, const Layout& layout, const BrakeTools& tools,
                                const PlanOptions& options, const Plan& infeasible,
                                const ProposalOptions& trying = {}, const Progress& progress = {});

}  // namespace planish
