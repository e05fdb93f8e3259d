#pragma once

#include <planish/job/report.hpp>
#include <planish/job/request.hpp>
#include <planish/job/shop.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::job {

/// Puts what a shop says into a request: layers, rules, tools; and its material if it has but one.
void take_shop(Request& to, Shop shop);

/// Puts the material of that name, upper or lower case, into a request with a shop. False where the
/// shop has none of that name.
bool take_material(Request& to, const std::string& name);

/// What is wrong with a request whose shop has several materials and none is chosen; `material`:
/// what the part's file says.
std::optional<Error> unchosen(const Request& request, const std::string& material = {});

/// "mild steel, stainless"
std::string material_names(const Shop& shop);

/// The rules with what the gauge says of flanges and openings.
Rules rules_with_gauge(const Rules& rules, const ShopChoice& choice, double thickness);

/// What the shop would say about a flat pattern: `shop_gauge`, `shop_radius`, `shop_limit`.
std::vector<Finding> shop_findings(const Report& report, const ShopChoice& choice);

}  // namespace planish::job
