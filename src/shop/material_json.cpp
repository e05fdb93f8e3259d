#include "refusals.hpp"

#include <planish/schema/json_reading.hpp>
#include <planish/shop/material_json.hpp>
#include <planish/shop/schemas.hpp>

#include <filesystem>

namespace planish::shop {
using namespace schema;
namespace {

constexpr auto kMaterialFormat = "planish/material";
constexpr int kMaterialVersion = 1;
constexpr std::size_t kMostPoints = 100'000;
constexpr Range kPoisson{"a number from 0 to 0.49", 0.0, 0.49};
constexpr Range kExponent{"a number from 0 to 1", 0.0, 1.0};

Schema curve_schema(std::string description) {
  const Schema points = list(tuple(2, number(kAtLeastZero), "a point [strain, stress]"))
                            .of_length(1, kMostPoints, "a list of 1 to 100000 points");
  const Schema law = object(
      {required("strength", number(kAboveZero).said("stress at a strain of 1, N/mm²")),
       required("exponent", number(kExponent).said("0: perfectly plastic"))});
  return one_key({optional("points", points.said("engineering strain, ascending, and N/mm²")),
                  optional("power_law", law.said("stress = strength · strain ^ exponent"))})
      .said(std::move(description));
}

Schema make_material_schema() {
  std::vector<Field> fields = header_fields(kMaterialFormat, kMaterialVersion);
  fields.push_back(optional("name", text().said("for reports; the file's name if left out")));
  fields.push_back(required("tension", curve_schema("of the stretched side")));
  fields.push_back(
      optional("compression", curve_schema("of the compressed side; that of tension if left out")));
  // Of slit sheets, which are elastic.
  fields.push_back(optional("young", number(kAboveZero).said("modulus, N/mm²")));
  fields.push_back(optional("poisson", number(kPoisson).said("ratio")));
  fields.push_back(optional("density", number(kAboveZero).said("kg/dm³")));
  fields.push_back(optional("yield", number(kAboveZero).said("stress, N/mm²")));
  return object(std::move(fields)).said("Stress-strain curves of a sheet, from which K follows");
}

MeasuredCurve measured(const JsonPlace& points) {
  MeasuredCurve curve;
  double before = 0.0, largest = 0.0;
  for (const JsonPlace& place : points.items()) {
    const std::vector<JsonPlace> pair = place.items();
    const double strain = pair[0].number(), stress = pair[1].number();
    if (strain < before) {
      place.mistake(refuse::strain_falls);
      return curve;
    }
    before = strain;
    largest = std::max(largest, stress);
    curve.points.push_back({strain, stress});
  }
  if (before == 0.0 || largest == 0.0) points.mistake(refuse::flat_curve);
  return curve;
}

StressStrain curve_of(const JsonPlace& place) {
  if (const JsonPlace points = place["points"]; points.given()) return measured(points);
  const JsonPlace law = place["power_law"];
  return PowerLaw{law["strength"].number(), law["exponent"].number()};
}

}  // namespace

const Schema& material_schema() {
  static const Schema schema = make_material_schema();
  return schema;
}

Result<MaterialCurves> parse_material(const std::string& json, const std::string& name) {
  JsonReading reading(json, "material file", name, material_schema());
  const JsonPlace file(reading);
  MaterialCurves material;
  material.name = file["name"].text();
  if (material.name.empty()) material.name = std::filesystem::path(name).filename().string();
  material.tension = curve_of(file["tension"]);
  const JsonPlace compression = file["compression"];
  material.compression = compression.given() ? curve_of(compression) : material.tension;
  material.young = file["young"].maybe_number();
  material.poisson = file["poisson"].maybe_number();
  material.density = file["density"].maybe_number();
  material.yield = file["yield"].maybe_number();
  if (reading.error()) return tl::unexpected(*reading.error());
  return material;
}

}  // namespace planish::shop
