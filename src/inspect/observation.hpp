#pragma once

#include <planish/inspect/findings.hpp>

#include <string>
#include <vector>

namespace planish::inspect_detail {

/// How far a dimension may miss a limit and still satisfy it: ten times the tolerance to which
/// curves are flattened, so that a feature drawn at the limit passes.
constexpr double kDrawn = 10.0 * 1e-4;  // mm

/// One violation, before many of a kind become one finding.
struct Observation {
  Finding finding;
  std::string kind;   ///< observations of one code and kind differ only in place
  std::string many;   ///< follows the count: "openings Ø 3 mm are …"
  double excess = 0;  ///< measured less wanted, mm: the smallest is the worst
};

/// Findings in the order of the observations. More than ten of one code and kind become one finding
/// with their count, the worst of them and all their places.
std::vector<Finding> grouped(std::vector<Observation> observations);

/// A number as a shop writes it: at most three decimals, no trailing zeros.
std::string number_text(double value);
std::string mm_text(double value);
/// "(12.5, 40)".
std::string point_text(const Vec2& p);
/// The terms of a limit, "1.5 T + R"; a factor of 0 omits its term.
std::string factors_text(double t_factor, double r_factor = 0.0);

}  // namespace planish::inspect_detail
