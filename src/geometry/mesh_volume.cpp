#include <planish/geometry/mesh_volume.hpp>

#include <map>

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

std::vector<std::pair<int, int>> open_sides(const Mesh& mesh) {
  std::map<std::pair<int, int>, int> runs;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++runs[{t[i], t[(i + 1) % 3]}];
  std::vector<std::pair<int, int>> open;
  for (const auto& [side, times] : runs) {
    const auto back = runs.find({side.second, side.first});
    if (times != 1 || back == runs.end() || back->second != 1) open.push_back(side);
  }
  return open;
}

}  // namespace planish
