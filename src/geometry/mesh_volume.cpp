#include <planish/geometry/mesh_volume.hpp>

#include <algorithm>

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
  std::vector<std::pair<int, int>> runs, back, open;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      runs.emplace_back(t[i], t[(i + 1) % 3]);
      back.emplace_back(t[(i + 1) % 3], t[i]);
    }
  std::ranges::sort(runs);
  std::ranges::sort(back);
  // Closed, as nearly all are: no side has to be looked up.
  if (runs == back && std::ranges::adjacent_find(runs) == runs.end()) return open;
  for (const auto& side : runs)
    if (std::ranges::equal_range(runs, side).size() != 1 ||
        std::ranges::equal_range(back, side).size() != 1)
      open.push_back(side);
  open.erase(std::unique(open.begin(), open.end()), open.end());
  return open;
}

}  // namespace planish
