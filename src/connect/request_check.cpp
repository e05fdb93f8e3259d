#include "request_check.hpp"

#include "refusals.hpp"

#include <algorithm>
#include <cmath>

// What a plates file may ask of a bend, checked before any is fitted: plates and edges that exist,
// values within their range, no quantity given twice, such as a cone by its slope and by its
// aperture. Each fault names the key at fault, so that an editor can mark it. What passes can be
// fitted, or is refused by the geometry alone.

namespace planish::connect_detail {
namespace {

/// What is wrong with a request, and the key at fault.
struct Fault {
  std::string key;
  const Refusal& refusal;
  Facts facts = {};
};

Fault bad_value(const char* key, const char* name, const Quantity& value, const char* range) {
  return {key,
          refuse::bad_value,
          {{"name", name}, {"value", value.value, value.unit}, {"range", range}}};
}

std::optional<Fault> wrong_size(const BendRequest& r) {
  if (!(r.trade_off >= 0.0 && std::isfinite(r.trade_off)))
    return bad_value("/trade_off", "trade_off", {r.trade_off}, "0 or more");
  if (r.inside_radius && !(*r.inside_radius >= 0.0))
    return bad_value("/inside_radius", "inside_radius", {*r.inside_radius, unit::mm}, "0 or more");
  if (r.inside_radii && !((*r.inside_radii)[0] >= 0.0 && (*r.inside_radii)[1] >= 0.0))
    return Fault{
        "/inside_radii",
        refuse::bad_radii,
        {{"value", (*r.inside_radii)[0], unit::mm}, {"value", (*r.inside_radii)[1], unit::mm}}};
  if (r.angle && !std::isfinite(r.angle->radians()))
    return bad_value("/angle", "angle", {r.angle->degrees(), unit::degrees}, "a finite number");
  if (r.aperture && !(r.aperture->degrees() > 0.0 && r.aperture->degrees() < 180.0))
    return bad_value("/aperture", "aperture", {r.aperture->degrees(), unit::degrees},
                     "an angle between 0° and 180°");
  return std::nullopt;
}

std::optional<Fault> wrong_surface(const BendRequest& r) {
  const bool conical = r.slope || r.apex || r.aperture || r.inside_radii;
  if (r.surface == SurfaceChoice::cylinder && conical)
    return Fault{"/surface", refuse::cylinder_given_as_cone};
  if (r.surface == SurfaceChoice::general &&
      (r.slope || r.aperture || r.inside_radius || r.inside_radii))
    return Fault{"/surface", refuse::general_given_more};
  if (r.tangent_point && r.surface != SurfaceChoice::general)
    return Fault{"/tangent_point", refuse::tangent_point_of_other};
  return std::nullopt;
}

std::optional<Fault> said_twice(const BendRequest& r) {
  const int ways = (r.inside_radii ? 1 : 0) + (r.aperture ? 1 : 0) + (r.slope || r.apex ? 1 : 0);
  if (ways > 1) return Fault{"", refuse::cone_given_twice};
  if (r.inside_radius && (r.inside_radii || r.aperture || r.apex))
    return Fault{"/inside_radius", refuse::radius_given_twice};
  return std::nullopt;
}

}  // namespace

Result<int> row_of(const PlateStructure& structure, const std::string& id,
                   const std::string& pointer) {
  const auto found = std::ranges::find(structure.plates, id, &Plate::id);
  if (found != structure.plates.end()) return static_cast<int>(found - structure.plates.begin());
  Facts facts{{"id", id}, {"field", place::pointer(pointer)}};
  for (const Plate& plate : structure.plates)
    facts.emplace_back("known", plate.id);
  return fail(refuse::no_such_plate, facts);
}

Result<std::vector<int>> rows_of(const PlateStructure& structure, const BendRequest& request,
                                 const std::string& pointer) {
  if (request.between.size() > 2)
    return fail(refuse::too_many_plates, {{"count", request.between.size()},
                                          {"field", place::pointer(pointer + "/between")}});
  std::vector<int> rows;
  for (std::size_t i = 0; i < request.between.size(); ++i) {
    const auto row = row_of(structure, request.between[i],
                            pointer + "/between/" + std::to_string(i));
    if (!row) return pass_on(row);
    rows.push_back(*row);
  }
  if (rows.size() == 2 && rows[0] == rows[1])
    return fail(refuse::plate_with_itself, {{"plate", place::plate(request.between[0])},
                                            {"field", place::pointer(pointer + "/between")}});
  return rows;
}

Result<void> check_numbers(const BendRequest& request, const std::string& pointer) {
  for (const auto find : {wrong_size, wrong_surface, said_twice})
    if (const auto fault = find(request)) {
      Facts facts = fault->facts;
      facts.emplace_back("field", place::pointer(pointer + fault->key));
      for (const std::string& id : request.between)
        facts.emplace_back("plate", place::plate(id));
      return fail(fault->refusal, facts);
    }
  return {};
}

Result<void> check_edges(const FitTask& task) {
  for (std::size_t side = 0; side < 2; ++side) {
    if (!task.plates[side] || !task.request.edges[side]) continue;
    const int count = task.plates[side]->all_edges();
    const std::string& id = task.request.between[side];
    const std::string list = task.pointer + "/edges/" + escaped_token(id);
    if (task.request.edges[side]->empty())
      return fail(refuse::no_edges_listed,
                  {{"plate", place::plate(id)}, {"field", place::pointer(list)}});
    for (std::size_t i = 0; i < task.request.edges[side]->size(); ++i) {
      const int edge = (*task.request.edges[side])[i];
      if (edge >= 0 && edge < count) continue;
      return fail(refuse::no_such_edge,
                  {{"plate", place::plate(id)},
                   {"edge", edge},
                   {"last", count - 1},
                   {"field", place::pointer(list + "/" + std::to_string(i))}});
    }
  }
  return {};
}

}  // namespace planish::connect_detail
