#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/schema/json_reading.hpp>
#include <planish/sheet/allowance.hpp>
#include <planish/shop/schemas.hpp>
#include <planish/shop/shop.hpp>
#include <planish/shop/tools_json.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>

namespace planish::shop {
using namespace schema;
namespace {

constexpr auto kShopFormat = "planish/shop";
constexpr int kShopVersion = 1;
constexpr std::size_t kMostMaterials = 1'000, kMostGauges = 1'000;
constexpr double kUsualTolerance = 0.05;  // mm
constexpr Range kBendAngle{"an angle above 0 and at most 180 degrees", 0.0, 180.0, false, true};

/// To what a deduction of a bend beyond 90° is measured.
enum class DeductionTo { mould_line, tangent_plane };

const Words<DeductionTo>& deduction_words() {
  static const Words<DeductionTo> words{{"mould_line", DeductionTo::mould_line},
                                        {"tangent_plane", DeductionTo::tangent_plane}};
  return words;
}
const Words<LayerProfile>& profile_words() {
  static const Words<LayerProfile> words{{"default", LayerProfile::standard},
                                         {"inventor", LayerProfile::inventor},
                                         {"onshape", LayerProfile::onshape},
                                         {"solidedge", LayerProfile::solid_edge}};
  return words;
}
const Words<BendLinetype>& linetype_words() {
  static const Words<BendLinetype> words{{"dashed", BendLinetype::dashed},
                                         {"continuous", BendLinetype::continuous}};
  return words;
}
const Words<DxfVersion>& release_words() {
  static const Words<DxfVersion> words{{"r2000", DxfVersion::r2000}, {"r12", DxfVersion::r12}};
  return words;
}

/// The layers that may be named, by their keys.
constexpr std::array<std::pair<const char*, std::string LayerNames::*>, 7> kLayers{
    {{"outer", &LayerNames::outer},
     {"openings", &LayerNames::openings},
     {"bend_up", &LayerNames::bend_up},
     {"bend_down", &LayerNames::bend_down},
     {"bend_zone", &LayerNames::bend_zone},
     {"features", &LayerNames::features},
     {"slits", &LayerNames::slits}}};

Schema gauge_schema_of_shop() {
  return object(
      {required("thickness", length(kAboveZero)),
       required("inside_radius", length(kAtLeastZero).said("to which the shop bends it")),
       optional("k", number(kShare).said("K-factor; one of k, deduction and allowance is given")),
       optional("deduction", length().said("of one bend, of `angle`")),
       optional("allowance", length(kAboveZero).said("of one bend, of `angle`")),
       optional("angle", angle(kBendAngle)
                             .defaulting(90)
                             .said("of the bend of deduction or allowance; 0 is flat")),
       optional("deduction_to", words(deduction_words())
                                    .defaulting("mould_line")
                                    .said("to what a deduction beyond 90 degrees is measured")),
       optional("smallest_flange", length(kAboveZero).said("from the outside of the bend")),
       optional("smallest_opening", length(kAboveZero).said("diameter"))});
}

Schema material_schema_of_shop() {
  return object({required("name", text().said("by which it is chosen")),
                 optional("density", number(kAboveZero).said("kg/dm³")),
                 optional("tensile_strength", number(kAboveZero).said("N/mm²")),
                 required("gauges", list(gauge_schema_of_shop())
                                        .of_length(1, kMostGauges, "a list of 1 to 1000 gauges"))});
}

Schema dxf_schema() {
  std::vector<Field> layers;
  for (const auto& [key, member] : kLayers)
    layers.push_back(optional(key, text()));
  return object(
      {optional("profile", words(profile_words()).said("names of layers that `layers` leaves out")),
       optional("layers", object(std::move(layers)).said("names of layers")),
       optional("bend_lines", words(linetype_words()).said("linetype of bend lines")),
       optional("release", words(release_words()))});
}

Schema rules_of_shop() {
  std::vector<Field> fields{optional("strict", flag().said("whether every breach is a warning"))};
  for (const RuleField& field : rule_fields())
    fields.push_back(optional(std::string(field.name),
                              number(kAtLeastZero).said(std::string(field.description))));
  return object(std::move(fields))
      .said("thresholds of the rules of manufacture, as in a rules file");
}

Schema limits_schema() {
  const auto size = [] { return tuple(2, length(kAboveZero), "a size [length, width]"); };
  return object({optional("sheet", size().said("of the largest sheet")),
                 optional("smallest_part", size().said("of a blank")),
                 optional("longest_bend", length(kAboveZero)), optional("most_bends", whole(1))});
}

Schema make_shop_schema() {
  const Schema ids = list(text());
  std::vector<Field> fields = header_fields(kShopFormat, kShopVersion);
  fields.push_back(optional("units", units()));
  fields.push_back(optional("name", text().said("for messages; the file's name if left out")));
  fields.push_back(optional("thickness_tolerance",
                            length(kAtLeastZero).said("between a part and a gauge; 0.05 mm")));
  fields.push_back(
      required("materials", list(material_schema_of_shop())
                                .of_length(1, kMostMaterials, "a list of 1 to 1000 materials")));
  fields.push_back(optional("dxf", dxf_schema()));
  fields.push_back(optional("rules", rules_of_shop()));
  fields.push_back(optional("limits", limits_schema()));
  fields.push_back(
      optional("tools", object({optional("punches", ids), optional("dies", ids)})
                            .said("ids of those of the built-in press brake tools that it has")));
  return object(std::move(fields)).said("What a shop stocks, and how it bends and cuts");
}

struct ReadK {
  double k = 0.0;
  std::string from;
};

ReadK k_at(const JsonPlace& place, double thickness, double radius) {
  const JsonPlace k = place["k"], deduction = place["deduction"], allowance = place["allowance"];
  if (k.given() + deduction.given() + allowance.given() != 1) {
    place.mistake(refuse::one_of_k);
    return {};
  }
  if (k.given()) return {k.number(), "K"};
  const Angle angle = place["angle"].angle();
  const bool to_plane = place["deduction_to"].choice(deduction_words()) ==
                        DeductionTo::tangent_plane;
  constexpr double kRight = 90.0;
  const double setback = to_plane && angle.degrees() > kRight
                             ? radius + thickness
                             : outside_setback(radius, thickness, angle);
  const JsonPlace& given = deduction.given() ? deduction : allowance;
  const double taken = deduction.given() ? 2.0 * setback - deduction.length() : allowance.length();
  const double value = (taken / angle.radians() - radius) / thickness;
  // What a table rounds to a hundredth may leave the range by so much.
  constexpr double kRoundedK = 0.02;
  if (!(value >= -kRoundedK && value <= 1.0 + kRoundedK))
    given.mistake(refuse::impossible_k,
                  {{"k", value, unit::none}, {"angle", angle.degrees(), unit::degrees}});
  return {std::clamp(value, 0.0, 1.0),
          fmt::format("{} {:.4g} mm at {:.4g}°", deduction.given() ? "deduction" : "allowance",
                      given.length(), angle.degrees())};
}

Gauge shop_gauge_at(const JsonPlace& place) {
  const double thickness = place["thickness"].length(), radius = place["inside_radius"].length();
  const ReadK read = k_at(place, thickness, radius);
  return {.thickness = thickness,
          .inside_radius = radius,
          .k_factor = read.k,
          .k_from = read.from,
          .smallest_flange = place["smallest_flange"].maybe_length(),
          .smallest_opening = place["smallest_opening"].maybe_length()};
}

ShopMaterial material_at(const JsonPlace& place, double tolerance) {
  ShopMaterial material{.name = place["name"].text(),
                        .density = place["density"].maybe_number(),
                        .tensile_strength = place["tensile_strength"].maybe_number(),
                        .gauges = {}};
  for (const JsonPlace& item : place["gauges"].items()) {
    const Gauge gauge = shop_gauge_at(item);
    for (const Gauge& other : material.gauges)
      if (std::abs(other.thickness - gauge.thickness) <= tolerance)
        item["thickness"].mistake(refuse::same_gauge, {{"thickness", gauge.thickness, unit::mm},
                                                       {"other", other.thickness, unit::mm},
                                                       {"tolerance", tolerance, unit::mm}});
    material.gauges.push_back(gauge);
  }
  std::ranges::sort(material.gauges, {}, &Gauge::thickness);
  return material;
}

void read_materials(Shop& shop, const JsonPlace& place) {
  std::set<std::string> names;
  for (const JsonPlace& item : place.items()) {
    shop.materials.push_back(material_at(item, shop.thickness_tolerance));
    if (!names.insert(lower_case(shop.materials.back().name)).second)
      item["name"].mistake(refuse::same_material, {{"name", shop.materials.back().name}});
  }
}

void read_layers(Shop& shop, const JsonPlace& place) {
  if (!place.given()) return;
  LayerNames names = layer_names(shop.profile.value_or(LayerProfile::standard));
  for (const auto& [key, member] : kLayers) {
    const JsonPlace name = place[key];
    if (!name.given()) continue;
    names.*member = name.text();
    constexpr std::string_view kForbidden = "<>/\\\":;?*|=`,";
    const bool odd = std::ranges::any_of(name.text(), [&](char c) {
      return c < ' ' || c > '~' || kForbidden.find(c) != std::string::npos;
    });
    constexpr std::size_t kLongest = 31;  // characters of a layer in release 12
    if (odd || name.text().size() > kLongest)
      name.mistake(refuse::no_layer_name,
                   {{"name", name.text()}, {"most", kLongest}, {"forbidden", kForbidden}});
  }
  // A shop that names its layer of openings looks for all that is cut within the part there.
  if (place["openings"].given() && !place["slits"].given()) names.slits = names.openings;
  for (const auto& bend : {names.bend_up, names.bend_down, names.bend_zone, names.features})
    if (bend == names.outer || bend == names.openings || bend == names.slits)
      place.mistake(refuse::cut_and_uncut, {{"layer", bend}});
  shop.layers = names;
}

void read_dxf(Shop& shop, const JsonPlace& place) {
  if (!place.given()) return;
  if (place["profile"].given()) shop.profile = place["profile"].choice(profile_words());
  if (place["bend_lines"].given())
    shop.bend_linetype = place["bend_lines"].choice(linetype_words());
  if (place["release"].given()) shop.release = place["release"].choice(release_words());
  read_layers(shop, place["layers"]);
}

void read_rules(Shop& shop, const JsonPlace& place) {
  if (!place.given()) return;
  if (place["strict"].given()) shop.strict = place["strict"].yes();
  Rules rules;
  for (const RuleField& field : rule_fields())
    if (const auto value = place[std::string(field.name)].maybe_number()) {
      shop.rules.emplace_back(field.value, *value);
      rules.*(field.value) = *value;
    }
  if (rules.k_low > rules.k_high)
    place.mistake(refuse::k_range_reversed,
                  {{"low", rules.k_low, unit::none}, {"high", rules.k_high, unit::none}});
}

std::optional<Vec2> size_at(const JsonPlace& place) {
  if (!place.given()) return std::nullopt;
  const std::vector<JsonPlace> sizes = place.items();
  const double a = sizes[0].length(), b = sizes[1].length();
  return Vec2(std::max(a, b), std::min(a, b));
}

void read_limits(ShopLimits& limits, const JsonPlace& place) {
  if (!place.given()) return;
  limits.sheet = size_at(place["sheet"]);
  limits.smallest_part = size_at(place["smallest_part"]);
  limits.longest_bend = place["longest_bend"].maybe_length();
  if (place["most_bends"].given()) limits.most_bends = place["most_bends"].whole();
}

/// The tools whose ids are listed, in their order; all where there is no list.
template <typename Tool>
std::vector<Tool> tools_named(const JsonPlace& place, const std::vector<Tool>& known) {
  if (!place.given()) return known;
  std::vector<Tool> tools;
  for (const JsonPlace& item : place.items()) {
    const auto found = std::ranges::find(known, item.text(), &Tool::id);
    if (found != known.end()) {
      tools.push_back(*found);
      continue;
    }
    const auto ids = mapped(known, &Tool::id);
    item.mistake(refuse::no_built_in_tool,
                 {{"name", item.text()}, {"known", fmt::format("{}", fmt::join(ids, ", "))}});
  }
  if (tools.empty()) place.mistake(refuse::no_tool_named);
  return tools;
}

void read_tools(Shop& shop, const JsonPlace& place) {
  if (!place.given()) return;
  const BrakeTools& known = default_tools();
  shop.tools = BrakeTools{known.machine, tools_named(place["punches"], known.punches),
                          tools_named(place["dies"], known.dies)};
}

}  // namespace

const Schema& shop_schema() {
  static const Schema schema = make_shop_schema();
  return schema;
}

Result<Shop> parse_shop(const std::string& json, const std::string& name) {
  JsonReading reading(json, "shop profile", name, shop_schema());
  const JsonPlace file(reading);
  Shop shop;
  shop.name = file["name"].text();
  if (shop.name.empty()) shop.name = std::filesystem::path(name).filename().string();
  shop.thickness_tolerance = file["thickness_tolerance"].maybe_length().value_or(kUsualTolerance);
  read_materials(shop, file["materials"]);
  read_dxf(shop, file["dxf"]);
  read_rules(shop, file["rules"]);
  read_limits(shop.limits, file["limits"]);
  read_tools(shop, file["tools"]);
  if (reading.error()) return tl::unexpected(*reading.error());
  return shop;
}

}  // namespace planish::shop
