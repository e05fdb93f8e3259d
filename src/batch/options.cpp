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

/// Whether a file may name one of the materials. Names that a STEP file writes otherwise than they
/// are spelled may be anywhere.
bool may_name(const Input& input, const std::vector<shop::ShopMaterial>& materials) {
  if (step_files_in(input.file)) return true;  // what is packed is not looked into
  const auto read = job::read_input_file(input.file, "input file");
  if (!read) return false;
  const std::string lower = lower_case(read->content);
  return std::ranges::any_of(materials, [&](const shop::ShopMaterial& material) {
    constexpr unsigned char kLastOfAscii = 0x7e;
    const bool plain = std::ranges::all_of(material.name, [](unsigned char c) {
      return c >= ' ' && c <= kLastOfAscii && c != '\'' && c != '\\';
    });
    return !plain || lower.find(lower_case(material.name)) != std::string::npos;
  });
}

std::optional<Error> nobody_chooses(const std::vector<Input>& inputs, const job::Request& request) {
  if (!request.shop || request.shop->material || request.materials) return std::nullopt;
  const shop::Shop& shop = request.shop->shop;
  const bool chosen = std::ranges::any_of(
      inputs, [&](const Input& input) { return may_name(input, shop.materials); });
  if (chosen) return std::nullopt;
  return error_of(refuse::no_input_says, {{"known", shop::material_names(shop)}}, "material");
}

std::optional<Error> said_twice(const std::vector<Input>& inputs, const job::Request& request) {
  const bool listed = request.materials &&
                      std::ranges::any_of(request.materials->rows(),
                                          [](const auto& row) { return row.quantity.has_value(); });
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
  return nobody_chooses(inputs, *request);
}

}  // namespace planish::batch
