#include "observation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace planish::inspect_detail {
namespace {

constexpr size_t kMany = 10;

std::string term_text(double factor, const char* name) {
  return factor == 1.0 ? name : fmt::format("{} {}", number_text(factor), name);
}

Finding merged(const std::vector<const Observation*>& alike) {
  const Observation* worst = alike.front();
  Finding result = alike.front()->finding;
  result.at.clear();
  for (const Observation* one : alike) {
    if (one->excess < worst->excess) worst = one;
    result.at.insert(result.at.end(), one->finding.at.begin(), one->finding.at.end());
  }
  result.message = fmt::format("{} {}; the worst: {}", alike.size(), worst->many,
                               worst->finding.message);
  return result;
}

}  // namespace

std::vector<Finding> grouped(std::vector<Observation> observations) {
  std::map<std::pair<std::string, std::string>, std::vector<const Observation*>> kinds;
  const auto key = [](const Observation& o) { return std::pair{o.finding.code, o.kind}; };
  for (const Observation& one : observations)
    kinds[key(one)].push_back(&one);
  std::vector<Finding> findings;
  for (const Observation& one : observations) {
    const auto& alike = kinds[key(one)];
    if (alike.size() <= kMany) {
      findings.push_back(one.finding);
    } else if (alike.front() == &one) {
      findings.push_back(merged(alike));
    }
  }
  return findings;
}

std::string number_text(double value) {
  constexpr double kHalfDigit = 0.0005;
  std::string text = fmt::format("{:.3f}", std::abs(value) < kHalfDigit ? 0.0 : value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string mm_text(double value) { return number_text(value) + " mm"; }

std::string point_text(const Vec2& p) {
  return fmt::format("({}, {})", number_text(p.x()), number_text(p.y()));
}

std::string factors_text(double t_factor, double r_factor) {
  if (r_factor == 0.0) return term_text(t_factor, "T");
  if (t_factor == 0.0) return term_text(r_factor, "R");
  return term_text(t_factor, "T") + " + " + term_text(r_factor, "R");
}

}  // namespace planish::inspect_detail
