#include "side_files.hpp"

#include <planish/job/rules_json.hpp>

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

namespace planish::cli {
namespace {

std::string all_of(std::istream& stream) {
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// A small text file, or standard input for "-"; `what` names its part in messages.
Result<std::string> read_text(const std::string& name, const std::string& what) {
  if (name == "-") return all_of(std::cin);
  std::error_code ignored;
  const auto refuse = [&](const std::string& why) {
    return fail(ErrorCode::cannot_read, fmt::format("cannot read the {} {}: {}", what, name, why),
                name);
  };
  if (std::filesystem::is_directory(name, ignored)) return refuse("it is a folder");
  std::ifstream file(name, std::ios::binary);
  if (!file) return refuse(std::generic_category().message(errno));
  std::string text = all_of(file);
  if (file.bad()) return refuse("reading it failed");
  return text;
}

Result<AllowanceRule> allowance_of(const UnfoldArguments& arguments) {
  if (arguments.k) return ConstantK{*arguments.k, "constant"};
  if (arguments.din6935) return Din6935{};
  if (arguments.k_table.empty()) return ConstantK{};
  const auto text = read_text(arguments.k_table, "bend table");
  if (!text) return tl::unexpected(text.error());
  const std::string name = std::filesystem::path(arguments.k_table).filename().string();
  auto table = parse_bend_table(*text, name);
  if (!table) return tl::unexpected(table.error());
  return AllowanceRule(std::move(*table));
}

Result<Rules> rules_of(const UnfoldArguments& arguments) {
  Rules rules;
  rules.enabled = !arguments.no_rules;
  if (arguments.rules.empty()) return rules;
  const auto text = read_text(arguments.rules, "rules file");
  if (!text) return tl::unexpected(text.error());
  return job::parse_rules(*text, arguments.rules);
}

}  // namespace

Result<job::UnfoldRequest> request_of(const UnfoldArguments& arguments) {
  auto allowance = allowance_of(arguments);
  if (!allowance) return tl::unexpected(allowance.error());
  auto rules = rules_of(arguments);
  if (!rules) return tl::unexpected(rules.error());
  job::UnfoldRequest request;
  request.input = arguments.input;
  request.body = arguments.body;
  request.allowance = std::move(*allowance);
  request.root = arguments.root;
  request.up = arguments.up;
  request.rules = *rules;
  request.write_overlapping = arguments.write_overlapping;
  request.units = arguments.units;
  request.density = arguments.density;
  return request;
}

}  // namespace planish::cli
