#include "side_files.hpp"

#include <planish/job/rules_json.hpp>
#include <planish/job/text_file.hpp>

#include <filesystem>
#include <optional>
#include <utility>

namespace planish::cli {
namespace {

// None: the command line does not say.
Result<std::optional<AllowanceRule>> allowance_of(const PatternArguments& arguments) {
  if (arguments.k) return AllowanceRule(ConstantK{*arguments.k, "constant"});
  if (arguments.din6935) return AllowanceRule(Din6935{});
  if (arguments.k_table.empty()) return std::nullopt;
  const auto text = job::read_text(arguments.k_table, "bend table");
  if (!text) return tl::unexpected(text.error());
  const std::string name = std::filesystem::path(arguments.k_table).filename().string();
  auto table = parse_bend_table(*text, name);
  if (!table) return tl::unexpected(table.error());
  return AllowanceRule(std::move(*table));
}

Result<Rules> rules_of(const PatternArguments& arguments) {
  Rules rules;
  rules.enabled = !arguments.no_rules;
  if (arguments.rules.empty()) return rules;
  const auto text = job::read_text(arguments.rules, "rules file");
  if (!text) return tl::unexpected(text.error());
  return job::parse_rules(*text, arguments.rules);
}

Result<job::PatternChecks> checks_of(const PatternArguments& arguments) {
  const auto rules = rules_of(arguments);
  if (!rules) return tl::unexpected(rules.error());
  job::PatternChecks checks;
  checks.rules = *rules;
  checks.write_overlapping = arguments.write_overlapping;
  checks.density = arguments.density;
  return checks;
}

}  // namespace

Result<job::UnfoldRequest> request_of(const UnfoldArguments& arguments) {
  auto allowance = allowance_of(arguments);
  if (!allowance) return tl::unexpected(allowance.error());
  auto checks = checks_of(arguments);
  if (!checks) return tl::unexpected(checks.error());
  job::UnfoldRequest request;
  static_cast<job::PatternChecks&>(request) = std::move(*checks);
  request.input = arguments.input;
  request.body = arguments.body;
  request.allowance = std::move(*allowance).value_or(ConstantK{});
  request.root = arguments.root;
  request.up = arguments.up;
  request.units = arguments.units.value_or(LengthUnit::mm);
  return request;
}

Result<job::MakeRequest> request_of(const MakeArguments& arguments) {
  auto allowance = allowance_of(arguments);
  if (!allowance) return tl::unexpected(allowance.error());
  auto checks = checks_of(arguments);
  if (!checks) return tl::unexpected(checks.error());
  job::MakeRequest request;
  static_cast<job::PatternChecks&>(request) = std::move(*checks);
  request.input = arguments.input;
  request.allowance = std::move(*allowance);
  request.units = arguments.units;
  return request;
}

}  // namespace planish::cli
