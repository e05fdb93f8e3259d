#pragma once

#include <planish/base/result.hpp>
#include <planish/brake/tools.hpp>
#include <planish/inspect/findings.hpp>
#include <planish/io/flat_writers.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace planish::shop {

/// A thickness in which a shop stocks a material, and how it bends it. Lengths in mm.
struct Gauge {
  double thickness = 0.0;
  double inside_radius = 0.0;
  double k_factor = 0.0;
  std::string k_from;  ///< "K", "deduction 3.84 mm at 90°"
  std::optional<double> smallest_flange, smallest_opening;
};

struct ShopMaterial {
  std::string name;
  std::optional<double> density;           ///< kg/dm³
  std::optional<double> tensile_strength;  ///< N/mm²
  std::vector<Gauge> gauges;               ///< ascending
};

/// What a part must keep to besides the rules of manufacture. Lengths in mm.
struct ShopLimits {
  std::optional<Vec2> sheet, smallest_part;  ///< length and width, longer first
  std::optional<double> longest_bend;
  std::optional<int> most_bends;
};

/// A shop profile (formats.md#shop).
struct Shop {
  std::string name;  ///< for messages; the file's name where the file has none
  std::vector<ShopMaterial> materials;
  double thickness_tolerance = 0.05;  ///< mm, between a part and a gauge
  std::optional<LayerProfile> profile;
  std::optional<LayerNames> layers;
  std::optional<BendLinetype> bend_linetype;
  std::optional<DxfVersion> release;
  std::vector<std::pair<double Rules::*, double>> rules;
  std::optional<bool> strict;
  ShopLimits limits;
  std::optional<BrakeTools> tools;  ///< of the catalogue, those that the shop names
};

/// A shop, and the material in which it makes a part.
struct ShopChoice {
  Shop shop;
  std::optional<int> material;  ///< its place in `shop.materials`
  bool gauge_limits = true;     ///< whether the gauge's smallest flange and opening hold
  bool density_given = false, strength_given = false;  ///< by options, which win

  const ShopMaterial& chosen() const;  ///< requires a material
};

/// Reads a shop profile. Errors: `invalid_input` for anything that is not JSON (`where` is
/// name:line:column), for what breaks the schema, and for a deduction or allowance whose K is
/// outside 0 to 1, gauges nearer than the tolerance, names given twice, layers that cannot be told
/// apart, tools that the catalogue does not have (`where` is name and JSON pointer).
Result<Shop> parse_shop(const std::string& json, const std::string& name);

/// The gauge of a sheet: the nearest, if it is within the tolerance; null where there is none.
const Gauge* gauge_of(const ShopChoice& choice, double thickness);

/// K of that gauge, or the default where there is none.
ConstantK shop_k(const ShopChoice& choice, double thickness);

}  // namespace planish::shop
