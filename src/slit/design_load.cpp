// The weight and the loads of a design, as what bends each strip (math.md#standing), and what they
// need: a material, as forces bend a sheet by their share of its rigidity, and least energy, as
// smoothness has no equilibrium.
#include "design_load.hpp"

#include "reach_checks.hpp"
#include "refusals.hpp"
#include "value_checks.hpp"

#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace planish::slit_detail {
namespace {

constexpr std::string_view kNewton = "N", kStress = "N/mm²";
constexpr double kMostForce = 1e9;  // N

tl::unexpected<Error> bad_number(const char* name, double value, std::string_view unit,
                                 const char* range, const std::string& where) {
  return fail(refuse::bad_value,
              {{"name", name}, {"value", value, unit}, {"range", range}, {"field", field(where)}});
}

Result<void> check_material(const SlitMaterial& material) {
  const std::string where = "/material/";
  const auto above_zero = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (!above_zero(material.young))
    return bad_number("Young's modulus", material.young, kStress, "a number above 0",
                      where + "young");
  if (!(material.poisson >= 0.0 && material.poisson < 0.5))
    return bad_number("Poisson's ratio", material.poisson, {}, "a number from 0 to below 0.5",
                      where + "poisson");
  if (material.density && !above_zero(*material.density))
    return bad_number("The density", *material.density, {}, "a number above 0 (kg/dm³)",
                      where + "density");
  if (material.yield && !above_zero(*material.yield))
    return bad_number("The yield stress", *material.yield, kStress, "a number above 0",
                      where + "yield");
  return {};
}

Result<void> check_one(const SlitDesign& design, int index) {
  const SlitLoad& load = design.loads[index];
  const std::string where = "/loads/" + std::to_string(index);
  if (auto sound = check_strip_number(design, load.strip, where + "/strip"); !sound) return sound;
  if (load.at && !(*load.at >= 0.0 && *load.at <= 1.0))
    return bad_number("The place of a load", *load.at, {},
                      "a share of the strip's length, from 0 to 1", where + "/at");
  if (!load.force.allFinite() || load.force.cwiseAbs().maxCoeff() > kMostForce)
    return fail(refuse::bad_force, {{"strip", place::strip(load.strip)},
                                    {"most", kMostForce, kNewton},
                                    {"field", field(where, "/force")}});
  if (design.sheet.symmetric && load.force.x() != 0.0)
    return fail(refuse::force_across_plane, {{"strip", place::strip(load.strip)},
                                             {"force", load.force.x(), kNewton},
                                             {"field", field(where, "/force")}});
  return {};
}

}  // namespace

double weight_per_area(const SlitDesign& design) {
  if (!design.gravity || !design.material || !design.material->density) return 0.0;
  constexpr double kPerCubicMillimetre = 1e-6;  // kg of a density in kg/dm³
  return *design.material->density * kPerCubicMillimetre * kGravity * design.sheet.thickness;
}

Vec3 force_on(const SlitDesign& design, const SlitLoad& load) {
  return design.sheet.symmetric ? Vec3(0.5 * load.force) : load.force;
}

StripLoad load_of(const SlitDesign& design, int strip) {
  if (!design.material || design.objective != SlitObjective::energy) return {};
  const double share = 1.0 / design.material->rigidity(design.sheet.thickness);
  const double area = design.sheet.area_of(strip);
  StripLoad all;
  all.spread = -share * weight_per_area(design) * Vec3::UnitY();
  for (const SlitLoad& load : design.loads) {
    if (load.strip != strip) continue;
    const Vec3 force = share * force_on(design, load);
    if (load.at)
      all.forces.push_back({*load.at, force});
    else
      all.spread += force / area;
  }
  return all;
}

bool same_load(const SlitDesign& a, const SlitDesign& b) {
  return a.material == b.material && a.gravity == b.gravity && a.loads == b.loads;
}

Result<void> check_load(const SlitDesign& design) {
  if (design.material)
    if (auto sound = check_material(*design.material); !sound) return sound;
  const bool is_loaded = !design.loads.empty();
  const char* key = design.gravity ? "/gravity" : "/loads";
  if ((design.gravity || is_loaded) && !design.material)
    return fail(refuse::load_without_material, {{"field", field(key)}});
  if ((design.gravity || is_loaded) && design.objective != SlitObjective::energy)
    return fail(refuse::load_without_energy, {{"field", field(key)}});
  if (design.gravity && !design.material->density)
    return fail(refuse::weight_without_density, {{"field", field("/gravity")}});
  for (int i = 0; i < std::ssize(design.loads); ++i)
    if (auto sound = check_one(design, i); !sound) return sound;
  return {};
}

}  // namespace planish::slit_detail
