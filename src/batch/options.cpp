#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/batch/options.hpp>
#include <planish/brep/step_archive.hpp>
#include <planish/job/options.hpp>
#include <planish/job/part_materials.hpp>
#include <planish/job/run.hpp>
#include <planish/shop/shop_checks.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

// A mistake in the options would refuse part after part, each with the same sentence; it is found
// before the first. What a part is made of only the part itself says, but a file in which no word
// is the name of a material of the shop says none of them.

namespace planish::batch {
namespace {

using Json = nlohmann::ordered_json;

/// What a file may have in it: letters, or a whole name in quotes.
struct SoughtName {
  std::string letters;
  bool is_whole = false;
};

/// Whether a file may have one of them. What a STEP file writes otherwise than it is spelled may be
/// anywhere.
bool may_name(const Input& input, const std::vector<SoughtName>& wanted) {
  if (step_files_in(input.file)) return true;  // what is packed is not looked into
  const auto read = job::read_input_file(input.file, "input file");
  if (!read) return false;
  const std::string content = lower_case(read->content);
  return std::ranges::any_of(wanted, [&](const SoughtName& one) {
    constexpr unsigned char kLastOfAscii = 0x7e;
    const bool plain = std::ranges::all_of(one.letters, [](unsigned char c) {
      return c >= ' ' && c <= kLastOfAscii && c != '\'' && c != '\\';
    });
    const std::string letters = lower_case(one.letters);
    return !plain ||
           content.find(one.is_whole ? "'" + letters + "'" : letters) != std::string::npos;
  });
}

std::vector<SoughtName> names_of(const shop::Shop& shop) {
  std::vector<SoughtName> names;
  for (const shop::ShopMaterial& material : shop.materials)
    names.push_back({material.name});
  return names;
}

/// The longest part of a pattern without * and ?.
std::string longest_letters(const std::string& pattern) {
  std::string longest;
  for (std::size_t at = 0; at <= pattern.size();) {
    const std::size_t end = std::min(pattern.find_first_of("*?", at), pattern.size());
    if (end - at > longest.size()) longest = pattern.substr(at, end - at);
    at = end + 1;
  }
  return longest;
}

/// Whether a row of the list fits a file, or may fit a body in it.
bool may_be_listed(const Input& input, const shop::PartMaterials& list) {
  std::vector<SoughtName> names;
  for (const shop::PartMaterial& row : list.rows()) {
    if (row.pattern.empty() || shop::fits(row.pattern, input.file.stem().string()) ||
        shop::fits(row.pattern, input.file.filename().string()))
      return true;
    const bool is_whole = row.pattern.find_first_of("*?") == std::string::npos;
    names.push_back({longest_letters(row.pattern), is_whole});
  }
  return may_name(input, names);
}

/// The list says nothing of some parts, and they name no material themselves.
std::optional<Error> not_listed(const std::vector<Input>& inputs, const job::Request& request) {
  constexpr std::size_t kMostNamed = 5;
  const std::vector<SoughtName> known = names_of(request.shop->shop);
  Facts facts{{"list", request.materials->name()}};
  std::size_t count = 0;
  for (const Input& input : inputs)
    if (!may_be_listed(input, *request.materials) && !may_name(input, known) &&
        ++count <= kMostNamed)
      facts.emplace_back("files", input.file.filename().string());
  if (count == 0) return std::nullopt;
  if (count > kMostNamed) facts.emplace_back("files", "others");
  facts.emplace_back("count", count);
  return error_of(refuse::not_in_list, facts, "materials");
}

std::optional<Error> nobody_chooses(const std::vector<Input>& inputs, const job::Request& request) {
  if (!request.shop || request.shop->material) return std::nullopt;
  if (request.materials) return not_listed(inputs, request);
  const shop::Shop& shop = request.shop->shop;
  const bool chosen = std::ranges::any_of(
      inputs, [&](const Input& input) { return may_name(input, names_of(shop)); });
  if (chosen) return std::nullopt;
  return error_of(refuse::no_input_says, {{"known", shop::material_names(shop)}}, "material");
}

bool orders_pieces(const shop::PartMaterials& list) {
  return std::ranges::any_of(list.rows(), [](const auto& row) { return row.quantity.has_value(); });
}

/// A list that orders pieces, but none of any of these parts; one of materials alone may be kept
/// for other jobs.
std::optional<Error> about_nothing(const std::vector<Input>& inputs, const job::Request& request) {
  if (!request.materials || !orders_pieces(*request.materials) ||
      std::ranges::any_of(
          inputs, [&](const Input& input) { return may_be_listed(input, *request.materials); }))
    return std::nullopt;
  return error_of(
      refuse::no_row_fits,
      {{"list", request.materials->name()}, {"pattern", request.materials->rows().front().pattern}},
      "materials");
}

std::optional<Error> said_twice(const std::vector<Input>& inputs, const job::Request& request) {
  const bool listed = request.materials && orders_pieces(*request.materials);
  const auto counted = std::ranges::find_if(
      inputs, [](const Input& input) { return !input.said_by.empty(); });
  if (!listed || counted == inputs.end()) return std::nullopt;
  return error_of(refuse::quantities_twice, {{"said_by", counted->said_by}}, "materials");
}

}  // namespace

Result<job::Request> request_of(const std::string& options, const job::Catalogue& catalogue) {
  const Json given = Json::parse(options);
  job::OptionValues values;
  for (const job::Maker& maker : catalogue.makers) {
    Json taken = Json::object();
    for (const auto& [name, value] : given.items())
      if (maker.takes(name)) taken[name] = value;
    const auto read = job::read_options(taken.dump(), maker, job::OptionFiles::path_or_content, "");
    if (!read) return pass_on(read);
    for (const auto& [option, value] : read->all())
      if (!values.given(option->name)) values.set(*option, value);
  }
  job::Request request;
  if (const auto entered = values.enter(request); !entered) return pass_on(entered);
  return request;
}

std::optional<Error> useless_options(const std::vector<Input>& inputs, const std::string& options,
                                     const job::Catalogue& catalogue) {
  const auto request = request_of(options, catalogue);
  if (!request) return request.error();
  if (auto wrong = job::unstocked(*request)) return wrong;
  if (auto wrong = said_twice(inputs, *request)) return wrong;
  if (auto wrong = nobody_chooses(inputs, *request)) return wrong;
  return about_nothing(inputs, *request);
}

}  // namespace planish::batch
