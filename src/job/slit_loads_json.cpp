#include "slit_loads_json.hpp"

#include "folded.hpp"
#include "refusals.hpp"

#include <planish/schema/text_file.hpp>
#include <planish/shop/material_json.hpp>

#include <algorithm>
#include <variant>

namespace planish::job {
using namespace schema;
namespace {

constexpr schema::Range kPoisson{"a number from 0 to 0.49", 0.0, 0.49};
constexpr schema::Range kEvenness{"a number from 0 to 10000", 0.0, 1e4};
constexpr schema::Range kEndGap{"a length from 0 to 1e7 mm", 0.0, 1e7};
constexpr schema::Range kForce{"a force from -1e9 to 1e9 N", -1e9, 1e9};

Schema elastic_schema() {
  return object(
      {required("young", number(kAboveZero).said("modulus, N/mm²")),
       optional("poisson", number(kPoisson).defaulting(0.3).said("ratio")),
       optional("density", number(kAboveZero).said("kg/dm³, for the weight")),
       optional("yield", number(kAboveZero).said("stress up to which it springs back, N/mm²"))});
}

Schema load_schema() {
  return object(
      {required("strip", whole()),
       optional("at",
                number(kShare).said("share of the strip's length, from the panel; spread over "
                                    "the strip if left out")),
       required("force", tuple(3, number(kForce), "a force [x, y, z]").said("N, y is up"))});
}

Schema coupling_schema() {
  return object({optional("smooth", number(kEvenness)
                                        .defaulting(SlitCoupling{}.smooth)
                                        .said("weight of an even change from strip to strip")),
                 optional("gap", tuple(2, length(kEndGap), "[least, most]")
                                     .said("from corner to corner where neighbours end"))})
      .said("all strips are solved together");
}

SlitMaterial material_at(const JsonPlace& place) {
  SlitMaterial material;
  material.young = place["young"].number();
  material.poisson = place["poisson"].number();
  material.density = place["density"].maybe_number();
  material.yield = place["yield"].maybe_number();
  return material;
}

SlitLoad load_at(const JsonPlace& place) {
  SlitLoad load{place["strip"].whole(), place["at"].maybe_number()};
  const std::vector<JsonPlace> force = place["force"].items();
  for (int axis = 0; axis < std::min(3, static_cast<int>(force.size())); ++axis)
    load.force[axis] = force[axis].number();
  return load;
}

SlitCoupling coupling_at(const JsonPlace& place) {
  SlitCoupling coupling{place["smooth"].number()};
  if (place["gap"].given()) {
    const Vec2 gap = place["gap"].plane_point();
    coupling.gap = {gap.x(), gap.y()};
  }
  return coupling;
}

Result<SlitMaterial> read_elastic(const std::filesystem::path& path) {
  const auto text = read_text(path, "material file");
  if (!text) return pass_on(text);
  const auto read = shop::parse_material(*text, path.string());
  if (!read) return pass_on(read);
  SlitMaterial material;
  if (const auto* curve = std::get_if<MeasuredCurve>(&read->tension)) {
    const auto first = std::ranges::find_if(
        curve->points, [](const MeasuredCurve::Point& point) { return point.strain > 0.0; });
    material.young = first->stress / first->strain;
    material.yield = first->stress;
  }
  if (read->young) material.young = *read->young;
  if (read->yield) material.yield = *read->yield;
  if (!(material.young > 0.0))
    return tl::unexpected(
        placed(error_of(refuse::material_without_modulus, {{"field", place::pointer("/young")}}),
               path.string()));
  material.poisson = read->poisson.value_or(material.poisson);
  material.density = read->density;
  return material;
}

}  // namespace

std::vector<Field> load_fields() {
  return {optional("material",
                   any_of({elastic_schema(), text()}, "a material or the name of a material file")
                       .said("of the sheet, as far as it is elastic")),
          optional("gravity", flag().defaulting(false).said("the sheet's weight bends it")),
          optional("loads", list(load_schema())
                                .said("forces on strips, of symmetric sheets on both halves "
                                      "together")),
          optional("coupling", coupling_schema())};
}

std::string take_loads(const JsonPlace& place, SlitDesign& design) {
  design.gravity = place["gravity"].yes();
  for (const JsonPlace& load : place["loads"].items())
    design.loads.push_back(load_at(load));
  if (place["coupling"].given()) design.coupling = coupling_at(place["coupling"]);
  const JsonPlace material = place["material"];
  if (material.is_text()) return material.text();
  if (material.given()) design.material = material_at(material);
  return {};
}

Result<void> take_material(const std::string& name,
                           const std::optional<std::filesystem::path>& folder, SlitDesign& design) {
  if (name.empty() || !folder) return {};
  const auto read = read_elastic(*folder / name);
  if (!read) return pass_on(read);
  design.material = *read;
  return {};
}

}  // namespace planish::job
