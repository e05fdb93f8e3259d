#include "model_places.hpp"

#include <numeric>

namespace planish::brep {
namespace {

Vec3 middle_of_edge(const SolidModel& model, int edge) {
  const SpaceCurve& curve = model.edges[edge].curve;
  return curve.point(std::midpoint(curve.t0, curve.t1));
}

}  // namespace

Place face_place(const SolidModel& model, int face) {
  const Place place = place::face(face + 1);
  const auto& loops = model.faces[face].loops;
  if (loops.empty() || loops.front().empty()) return place;
  return place::at(place, middle_of_edge(model, loops.front().front().edge));
}

Place edge_place(const SolidModel& model, int edge) {
  return place::at(place::edge(edge + 1), middle_of_edge(model, edge));
}

}  // namespace planish::brep
