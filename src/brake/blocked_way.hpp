#pragma once

#include <planish/brake/plan.hpp>

#include <chrono>

namespace planish::brake_detail {

class StageCache;

using Clock = std::chrono::steady_clock;
inline constexpr Clock::time_point kNoEnd = Clock::time_point::max();

/// Why lines cannot be pressed together, with the way of pressing them that comes nearest.
struct BlockedWay {
  BlockedBend bend;
  StrokeChoice choice;
};

/// Why lines cannot be pressed in a stage, by the tools that come nearest to it; of those looked at
/// until a time, the first at least.
BlockedWay blocked_way(StageCache& cache, const LineSet& formed, const LineSet& pressed,
                       Clock::time_point until = kNoEnd);

/// The same for one line alone.
BlockedBend blocked(StageCache& cache, const LineSet& formed, int line,
                    Clock::time_point until = kNoEnd);

}  // namespace planish::brake_detail
