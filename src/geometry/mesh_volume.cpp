#include <planish/geometry/mesh_volume.hpp>

namespace planish {

double volume_of(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](int corner) -> Vec3 {
      return mesh.points[t[corner]] - mesh.points.front();
    };
    sum += at(0).dot(at(1).cross(at(2))) / 6.0;
  }
  return sum;
}

}  // namespace planish
