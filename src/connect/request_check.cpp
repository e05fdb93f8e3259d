#include "request_check.hpp"

#include <planish/connect/codes.hpp>

#include <fmt/format.h>

#include <cmath>

namespace planish::connect_detail {
namespace {

Result<int> row_of(const PlateStructure& structure, const std::string& id,
                   const std::string& pointer) {
  for (std::size_t p = 0; p < structure.plates.size(); ++p)
    if (structure.plates[p].id == id) return static_cast<int>(p);
  std::string known;
  for (const Plate& plate : structure.plates)
    known += (known.empty() ? "" : ", ") + plate.id;
  return fail(code::unknown_plate,
              fmt::format("there is no plate \"{}\"; the plates are {}", id, known), pointer);
}

// In JSON pointers ~ and / in keys are escaped (RFC 6901).
std::string escaped(const std::string& key) {
  std::string text;
  for (const char c : key)
    text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return text;
}

/// What is wrong with a request, and the key at fault.
struct Fault {
  std::string key, what;
};

std::optional<Fault> wrong_size(const BendRequest& r) {
  if (!(r.trade_off >= 0.0 && std::isfinite(r.trade_off)))
    return Fault{"/trade_off", fmt::format("trade_off is {}; it must be 0 or more", r.trade_off)};
  if (r.inside_radius && !(*r.inside_radius >= 0.0))
    return Fault{"/inside_radius",
                 fmt::format("inside_radius is {}; it must be 0 or more", *r.inside_radius)};
  if (r.inside_radii && !((*r.inside_radii)[0] >= 0.0 && (*r.inside_radii)[1] >= 0.0))
    return Fault{"/inside_radii", "inside_radii must be 0 or more"};
  if (r.angle && !std::isfinite(r.angle->radians()))
    return Fault{"/angle", fmt::format("angle is {}°; it must be a number", r.angle->degrees())};
  if (r.aperture && !(r.aperture->degrees() > 0.0 && r.aperture->degrees() < 180.0))
    return Fault{"/aperture", fmt::format("aperture is {}°; it must lie between 0 and 180°",
                                          r.aperture->degrees())};
  return std::nullopt;
}

std::optional<Fault> wrong_surface(const BendRequest& r) {
  const bool conical = r.slope || r.apex || r.aperture || r.inside_radii;
  if (r.surface == SurfaceChoice::cylinder && conical)
    return Fault{"/surface",
                 "a cylinder has no slope, apex, aperture or radii at its ends: give them with a "
                 "cone"};
  if (r.surface == SurfaceChoice::general &&
      (r.slope || r.aperture || r.inside_radius || r.inside_radii))
    return Fault{"/surface",
                 "of a general bend only edges, apex, tangent_point and lateral can be given"};
  if (r.tangent_point && r.surface != SurfaceChoice::general)
    return Fault{"/tangent_point", "a tangent_point goes with the surface general"};
  return std::nullopt;
}

std::optional<Fault> said_twice(const BendRequest& r) {
  const int ways = (r.inside_radii ? 1 : 0) + (r.aperture ? 1 : 0) + (r.slope || r.apex ? 1 : 0);
  if (ways > 1)
    return Fault{"",
                 "slope and apex, aperture, and inside_radii each fix the cone: give one of the "
                 "three"};
  if (r.inside_radius && (r.inside_radii || r.aperture || r.apex))
    return Fault{"/inside_radius",
                 "inside_radius goes with a cylinder, or with a cone of which at most the slope is "
                 "given"};
  return std::nullopt;
}

}  // namespace

Result<std::vector<int>> rows_of(const PlateStructure& structure, const BendRequest& request,
                                 const std::string& pointer) {
  if (request.between.size() > 2)
    return fail(code::invalid_input,
                fmt::format("a bend joins two plates, not {}", request.between.size()),
                pointer + "/between");
  std::vector<int> rows;
  for (std::size_t i = 0; i < request.between.size(); ++i) {
    const auto row = row_of(structure, request.between[i],
                            fmt::format("{}/between/{}", pointer, i));
    if (!row) return pass_on(row);
    rows.push_back(*row);
  }
  if (rows.size() == 2 && rows[0] == rows[1])
    return fail(code::invalid_input,
                fmt::format("a bend cannot join plate \"{}\" to itself", request.between[0]),
                pointer + "/between");
  return rows;
}

Result<void> check_numbers(const BendRequest& request, const std::string& pointer) {
  for (const auto find : {wrong_size, wrong_surface, said_twice})
    if (const auto fault = find(request))
      return fail(code::invalid_input, fault->what, pointer + fault->key);
  return {};
}

Result<void> check_edges(const FitTask& task) {
  for (std::size_t side = 0; side < 2; ++side) {
    if (!task.plates[side] || !task.request.edges[side]) continue;
    const int count = task.plates[side]->all_edges();
    const std::string place = fmt::format("{}/edges/{}", task.pointer,
                                          escaped(task.request.between[side]));
    if (task.request.edges[side]->empty())
      return fail(code::invalid_input,
                  "the list of edges is empty: leave it out to have them chosen", place);
    for (std::size_t i = 0; i < task.request.edges[side]->size(); ++i) {
      const int edge = (*task.request.edges[side])[i];
      if (edge >= 0 && edge < count) continue;
      return fail(code::unknown_edge,
                  fmt::format("plate \"{}\" has no edge {}: its edges are 0 to {}",
                              task.request.between[side], edge, count - 1),
                  fmt::format("{}/{}", place, i));
    }
  }
  return {};
}

}  // namespace planish::connect_detail
