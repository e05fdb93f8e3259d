// Random transitions: each has a net, whose lengths and area are those of closed forms and of a
// convex hull made here. CONTRIBUTING.md says how it is run.
#include "random_transition.hpp"
#include "support/random_run.hpp"

#include <planish/job/run.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

namespace planish::transitions {
namespace {

using Json = nlohmann::json;

using Options = test::RandomRun;

std::string off_by(const char* what, double value, double expected) {
  constexpr double kShare = 1e-8;
  if (std::abs(value - expected) <= kShare * expected) return {};
  return fmt::format("{} is {}, not {}", what, value, expected);
}

/// What is wrong about the report of a net; empty: nothing.
std::string wrong_with(const Json& file, const Json& report) {
  if (!report["reason"].is_null()) return report["reason"].dump();
  const Json &proof = report["verification"], &made = report["transition"];
  constexpr double kLength = 1e-6, kVolume = 1e-3, kMostTips = 0.2;
  for (const char* figure : {"length_error", "refold_deviation"})
    if (!proof[figure].is_number() || !(proof[figure].get<double>() <= kLength))
      return fmt::format("{} is {}", figure, proof[figure].dump());
  // The folded solid lacks the tips where folds meet in a corner, the net does not.
  if (const Json& ratio = proof["volume_ratio"];
      ratio.is_number() && !(ratio >= 1.0 - kVolume && ratio <= 1.0 + kMostTips))
    return fmt::format("volume_ratio is {}", ratio.dump());
  for (std::size_t end = 0; end < 2; ++end)
    if (const auto length = perimeter_of(file[end == 0 ? "from" : "to"]["profile"]))
      if (auto wrong = off_by("a perimeter", made["perimeters"][end], *length); !wrong.empty())
        return wrong;
  if (const auto area = area_between(file)) return off_by("the area", made["area"], *area);
  return {};
}

int run(const Options& options) {
  int defects = 0;
  std::map<std::string, int> findings;
  for (int i = options.first; i < options.first + options.count; ++i) {
    const Json file = random_transition(options.seed, i);
    const Json request{{"maker", "transition"},
                       {"input", {{"name", "t.json"}, {"content", file}}},
                       {"artifacts", {"dxf", "step"}}};
    const auto result = job::run(request.dump());
    const Json report = result ? Json::parse(result->report) : Json();
    const std::string wrong = result ? wrong_with(file, report) : result.error().message;
    if (result)
      for (const Json& finding : report["checks"]) {
        const std::string severity = finding["severity"], code = finding["code"];
        if (severity != "info") ++findings[severity + " " + code];
        if (severity == "error" || options.list)
          fmt::print("{}: {}\n", i, finding["message"].get<std::string>());
      }
    if (!options.keep.empty() && (!wrong.empty() || options.list))
      std::ofstream(fmt::format("{}/transition_{}_{}.json", options.keep, options.seed, i))
          << file.dump(1);
    if (wrong.empty()) continue;
    ++defects;
    fmt::print("{}: {}\n", i, wrong);
  }
  fmt::print("{} transitions, {} defects\n", options.count, defects);
  for (const auto& [finding, count] : findings)
    fmt::print("  {:5} with {}\n", count, finding);
  return defects == 0 ? 0 : 1;
}

}  // namespace
}  // namespace planish::transitions

int main(int argc, char** argv) {
  const auto options = planish::test::random_run({argv + 1, argv + argc}, 40);
  if (options) return planish::transitions::run(*options);
  fmt::print(stderr, "random_transitions {}\n", planish::test::kRandomRunUsage);
  return 2;
}
