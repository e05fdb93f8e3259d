#include "taken_shop.hpp"

#include "refusals.hpp"

#include <planish/base/text.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::job {
using namespace shop;
namespace {

void choose_material(Request& to, int material) {
  to.shop->material = material;
  const ShopMaterial& chosen = to.shop->chosen();
  if (chosen.density && !to.shop->density_given) to.density = chosen.density;
  if (chosen.tensile_strength && !to.shop->strength_given)
    to.bending.plan.tensile_strength = *chosen.tensile_strength;
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
  const auto& materials = to.shop->shop.materials;
  const auto found = std::ranges::find_if(materials, [&](const ShopMaterial& material) {
    return lower_case(material.name) == lower_case(name);
  });
  if (found == materials.end()) return false;
  choose_material(to, static_cast<int>(found - materials.begin()));
  return true;
}

std::optional<Error> unchosen(const Request& request, const std::string& material) {
  if (!request.shop || request.shop->material) return std::nullopt;
  const std::string known = material_names(request.shop->shop);
  return error_of(material.empty() ? refuse::material_unsaid : refuse::material_not_stocked,
                  {{"known", known}, {"material", material}}, "material");
}

}  // namespace planish::job
