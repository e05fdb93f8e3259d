#pragma once

#include "sentences.hpp"

#include <planish/inspect/findings.hpp>

#include <string>
#include <vector>

namespace planish::inspect_detail {

/// How far a dimension may miss a limit and still satisfy it: ten times the tolerance to which
/// curves are flattened, so that a feature drawn at the limit passes.
constexpr double kDrawn = 10.0 * 1e-4;  // mm

/// One place where a rule is broken, before all places of a rule become one finding.
struct Observation {
  const char* code = "";
  FindingPlace place;
  double excess = 0;  ///< measured less wanted, mm: the smallest is the worst
};

/// Shares of a limit below which a shop would call, not shrug.
constexpr double kHalf = 0.5, kQuarter = 0.25;

/// Warning where a measure falls below this share of its limit, and everywhere if the rules are
/// strict.
Severity severity_of(double measured, double limit, double share, const Rules& rules);

/// One finding for each code, warnings before info, else in the order of the first observations;
/// its places the worst first: warnings before info, then by excess.
std::vector<Finding> grouped(const std::vector<Observation>& observations);

/// `tell`, with no capital at a place that a sentence begins with.
Told told(say::Sentence sentence, const Facts& facts);
/// A place where a rule is broken, as a sentence tells it; {limit} in it is what the rule asks for,
/// {wanted} by its {rule}.
FindingPlace breach(Severity severity, say::Sentence sentence, Facts facts, std::vector<Vec2> at);

/// The terms of a limit, "1.5 T + R"; a factor of 0 omits its term.
std::string factors_text(double t_factor, double r_factor = 0.0);

}  // namespace planish::inspect_detail
