#include "solid_model.hpp"

namespace planish::brep {

int face_as_read(const SolidEdge& edge, int side) {
  return edge.merged_faces[side] >= 0 ? edge.merged_faces[side] : edge.faces[side];
}

int face_across(const SolidEdge& edge, int face) {
  return edge.faces[0] == face ? edge.faces[1] : edge.faces[0];
}

std::vector<std::vector<int>> edges_by_face(const SolidModel& model) {
  std::vector<std::vector<int>> edges(model.faces.size());
  for (int e = 0; e < std::ssize(model.edges); ++e)
    for (const int f : model.edges[e].faces)
      if (f >= 0) edges[f].push_back(e);
  return edges;
}

}  // namespace planish::brep
