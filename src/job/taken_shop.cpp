#include "taken_shop.hpp"

#include "refusals.hpp"

#include <planish/base/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace planish::job {
using namespace shop;
namespace {

void choose_material(Request& to, int material) {
  to.shop->material = material;
  const ShopMaterial& chosen = to.shop->chosen();
  if (!to.shop->density_given) to.density = chosen.density;
  if (!to.shop->strength_given)
    to.bending.plan.tensile_strength = chosen.tensile_strength.value_or(
        PlanOptions{}.tensile_strength);
}

bool same_word(const std::string& one, const std::string& other) {
  return lower_case(one) == lower_case(other);
}

int place_in(const Shop& shop, const std::string& name) {
  const auto found = std::ranges::find_if(
      shop.materials, [&](const ShopMaterial& material) { return same_word(material.name, name); });
  return found == shop.materials.end() ? -1 : static_cast<int>(found - shop.materials.begin());
}

/// The row of the list that is about the part.
const PartMaterial* row_of(const Request& request, const Report& report) {
  if (!request.materials) return nullptr;
  const std::filesystem::path& input = request.input;
  return request.materials->find({report.body, input.stem().string(), input.filename().string()},
                                 report.colour);
}

}  // namespace

void take_shop(Request& to, Shop shop) {
  if (shop.profile) to.dxf.profile = *shop.profile;
  if (shop.bend_linetype) to.dxf.bend_linetype = *shop.bend_linetype;
  if (shop.release) to.dxf.version = *shop.release;
  to.dxf.layers = shop.layers;
  for (const auto& [rule, value] : shop.rules)
    to.rules.*rule = value;
  if (shop.strict) to.rules.strict = *shop.strict;
  if (shop.tools) to.bending.tools = shop.tools;
  to.shop = ShopChoice{.shop = std::move(shop), .material = std::nullopt};
  if (to.shop->shop.materials.size() == 1) choose_material(to, 0);
}

bool take_material(Request& to, const std::string& name) {
  const int place = place_in(to.shop->shop, name);
  if (place < 0) return false;
  choose_material(to, place);
  return true;
}

void enter_material(Report& report, const Request& request) {
  const PartMaterial* row = row_of(request, report);
  if (row && row->quantity) report.quantity = *row->quantity;
  std::string said = request.material;
  if (said.empty() && request.shop && request.shop->material) said = request.shop->chosen().name;
  if (row) said = row->material;
  if (said.empty()) return;
  if (!same_word(said, report.material)) report.density.reset();
  report.material = said;
}

Result<Request> request_of_part(const Request& request, Report& report) {
  Request mine = request;
  StrokeLimits& limits = mine.bending.plan.limits;  // one time for all pieces and rounds
  limits.until = limits.end(std::chrono::steady_clock::now());
  enter_material(report, request);
  const PartMaterial* row = row_of(request, report);
  if (mine.shop && (row || !mine.shop->material)) {
    if (!take_material(mine, report.material)) mine.shop->material.reset();
    if (auto wrong = unchosen(mine, report.material)) return tl::unexpected(std::move(*wrong));
    report.material = mine.shop->chosen().name;
  }
  if (!row) return mine;
  if (row->density) mine.density = row->density;
  // The curves of a material are not those of another.
  const bool curves = mine.allowance && std::holds_alternative<MaterialCurves>(*mine.allowance);
  if (curves && !same_word(row->material, request.material)) mine.allowance.reset();
  return mine;
}

std::optional<Error> unstocked(const Request& request) {
  if (!request.shop || !request.materials) return std::nullopt;
  const Shop& shop = request.shop->shop;
  for (const PartMaterial& row : request.materials->rows())
    if (place_in(shop, row.material) < 0)
      return error_of(refuse::row_not_stocked,
                      {{"file", request.materials->name()},
                       {"line", place::line(row.line)},
                       {"material", row.material},
                       {"known", material_names(shop)}},
                      "materials");
  return std::nullopt;
}

std::optional<Error> unstocked_file(const Request& request) {
  if (!request.shop || request.shop->material || request.material.empty()) return std::nullopt;
  return error_of(refuse::file_not_stocked,
                  {{"material", request.material}, {"known", material_names(request.shop->shop)}},
                  "material");
}

std::optional<Error> unchosen(const Request& request, const std::string& material) {
  if (!request.shop || request.shop->material) return std::nullopt;
  const std::string known = material_names(request.shop->shop);
  return error_of(material.empty() ? refuse::material_unsaid : refuse::material_not_stocked,
                  {{"known", known}, {"material", material}}, "material");
}

}  // namespace planish::job
