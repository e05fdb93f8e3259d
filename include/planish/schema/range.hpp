#pragma once

#include <limits>
#include <string_view>

namespace planish::schema {

/// A range of allowed numbers, and how messages describe it.
struct Range {
  std::string_view words;  ///< "a number above 0"
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_too = true, high_too = true;  ///< whether the limits are included

  bool holds(double x) const {
    return (low_too ? x >= low : x > low) && (high_too ? x <= high : x < high);
  }
};
inline constexpr Range kAnyNumber{"a number"};
inline constexpr Range kAtLeastZero{"a number of at least 0", 0.0};
inline constexpr Range kAboveZero{"a number above 0", 0.0, std::numeric_limits<double>::infinity(),
                                  false};
inline constexpr Range kShare{"a number from 0 to 1", 0.0, 1.0};

}  // namespace planish::schema
