#pragma once

#include <planish/geometry/frame.hpp>
#include <planish/inspect/findings.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <planish/shop/shop.hpp>

#include <string>
#include <vector>

namespace planish::shop {

/// "mild steel, stainless"
std::string material_names(const Shop& shop);

/// The rules with what the gauge says of flanges and openings.
Rules rules_with_gauge(const Rules& rules, const ShopChoice& choice, double thickness);

/// What a shop looks at in a part. Lengths in mm.
struct ShopPart {
  double thickness = 0.0;
  Vec2 size = Vec2::Zero();  ///< of its blank, longer side first
  const FlatPattern& flat;
};

/// What the shop would say about a flat pattern: `shop_gauge`, `shop_radius`, `shop_limit`.
std::vector<Finding> shop_findings(const ShopPart& part, const ShopChoice& choice);

}  // namespace planish::shop
