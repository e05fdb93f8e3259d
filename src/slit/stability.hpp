#pragma once

#include "resting_strip.hpp"

#include <vector>

namespace planish::slit_detail {

/// Which of the strips stay where they are, all of them free to move together: those that take no
/// part in a motion by which energy is lost and which ends, limits, the ground and contacts allow
/// (math.md#standing). `contacts` name strips by their places in the list; those with a multiplier
/// press and are kept, others touch only and may open. `unit`: in which they count, mm. In a
/// symmetric sheet the one half may also do the opposite of the other. O(strips × quads³) where
/// neighbours touch only.
std::vector<bool> those_that_stay(const std::vector<RestingStrip>& strips,
                                  const std::vector<Contact>& contacts, double unit,
                                  bool symmetric);

}  // namespace planish::slit_detail
