#pragma once

#include "refusals.hpp"

#include <planish/base/result.hpp>

#include <string>

namespace planish::slit_detail {

constexpr double kLargest = 1e7;  // mm, of lengths and coordinates: 10 km

/// Where a value stands in the file: "/sheet/strips/2", "/width".
inline Place field(const std::string& where, const char* key = "") {
  return place::pointer(where + key);
}

/// Of points and poles.
inline bool in_range(const auto& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() <= kLargest; }

inline Result<void> check_place(const auto& p, const std::string& what, const std::string& where) {
  if (in_range(p)) return {};
  return fail(refuse::bad_coordinate,
              {{"what", what}, {"most", kLargest, unit::mm}, {"field", field(where)}});
}

}  // namespace planish::slit_detail
