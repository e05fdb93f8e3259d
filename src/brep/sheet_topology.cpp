#include "sheet_topology.hpp"

#include "border_curve.hpp"
#include "side_wall.hpp"

#include <planish/base/union_find.hpp>

#include <Eigen/QR>
#include <fmt/format.h>

#include <numbers>

namespace planish::brep {
namespace {

/// Row of every border: first_row[face][loop] + border.
std::vector<std::vector<int>> rows_of(const Sheet& sheet, SheetTopology& topology) {
  std::vector<std::vector<int>> first_row(sheet.faces.size());
  for (const FaceId id : sheet.faces.ids())
    for (std::size_t l = 0; l < sheet[id].loops.size(); ++l) {
      const int first = static_cast<int>(topology.borders.size());
      const int count = static_cast<int>(sheet[id].loops[l].size());
      first_row[index_of(id)].push_back(first);
      for (int b = 0; b < count; ++b)
        topology.borders.push_back({{id, static_cast<int>(l), b}, first + (b + 1) % count});
    }
  return first_row;
}

/// The tangent planes that meet in a corner: one of each direction.
void add_direction(std::vector<Vec3>& normals, const Vec3& normal) {
  constexpr double kSame = 1e-4;  // radians
  for (const Vec3& n : normals)
    if ((n - normal).norm() < kSame) return;
  normals.push_back(normal);
}

/// The shortest step from the reference skin that gains the thickness below every plane.
Vec3 mitre(const std::vector<Vec3>& normals, double thickness) {
  Eigen::MatrixXd rows(normals.size(), 3);
  for (std::size_t i = 0; i < normals.size(); ++i)
    rows.row(static_cast<int>(i)) = normals[i];
  const Eigen::VectorXd depths = Eigen::VectorXd::Constant(static_cast<int>(normals.size()),
                                                           -thickness);
  return rows.completeOrthogonalDecomposition().solve(depths);
}

}  // namespace

Result<SheetTopology> sheet_topology(const Sheet& sheet) {
  SheetTopology topology;
  const auto first_row = rows_of(sheet, topology);
  const auto row_of = [&](const BorderRef& ref) {
    return first_row[index_of(ref.face)][ref.loop] + ref.border;
  };
  UnionFind corners(static_cast<int>(topology.borders.size()));  // rows that start there
  std::vector<int> sharp_rows;
  for (std::size_t j = 0; j < sheet.joints.size(); ++j) {
    const Joint& joint = sheet.joints[j];
    if (!sheet.has(joint.a) || !sheet.has(joint.b))
      return fail(ErrorCode::invalid_input, "A joint names a border that does not exist.",
                  fmt::format("joint {}", j));
    const int a = row_of(joint.a), b = row_of(joint.b);
    auto& first = topology.borders[a];
    auto& second = topology.borders[b];
    if (a == b || first.mate >= 0 || second.mate >= 0)
      return fail(ErrorCode::invalid_input, "Two joints name the same border.",
                  fmt::format("joint {}", j));
    first.mate = b;
    second.mate = a;
    second.leads = false;
    corners.unite(a, second.next);
    corners.unite(first.next, b);
    if (joint.sharp) sharp_rows.insert(sharp_rows.end(), {a, b});
  }

  std::vector<int> number(topology.borders.size(), -1);
  for (std::size_t i = 0; i < topology.borders.size(); ++i) {
    int& n = number[corners.root(static_cast<int>(i))];
    if (n < 0) n = topology.corners++;
    topology.borders[i].corner = n;
  }
  topology.sharp.resize(topology.corners);
  for (int row : sharp_rows)
    topology.sharp[topology.borders[row].corner] = true;
  return topology;
}

Result<std::vector<CornerPoints>> corner_points(const Sheet& sheet, const SheetTopology& topology) {
  std::vector<CornerPoints> points(topology.corners);
  std::vector<int> count(topology.corners, 0);
  std::vector<std::vector<Vec3>> normals(topology.corners);
  std::vector<Vec3> middle(topology.corners, Vec3::Zero());
  const Depths depths(sheet);
  for (const auto& node : topology.borders) {
    const Face& face = face_of(sheet, node.ref);
    const Vec2 uv = start_of(border_of(sheet, node.ref).curve);
    points[node.corner].reference += point_below(face, uv, depths.first);
    points[node.corner].other += point_below(face, uv, depths.second);
    middle[node.corner] += skin_point(face, uv);
    add_direction(normals[node.corner], outward_normal(face, uv));
    ++count[node.corner];
  }
  for (int c = 0; c < topology.corners; ++c) {
    points[c].reference /= count[c];
    points[c].other /= count[c];
    if (!topology.sharp[c]) continue;
    const Vec3 step = mitre(normals[c], sheet.thickness);
    const Vec3 on_reference = middle[c] / count[c];
    if (!(step.norm() < 10 * sheet.thickness))
      return fail(ErrorCode::unsupported_shape,
                  "A sharp bend turns by more than 168°, so its mitre would be longer than ten "
                  "times the thickness; give it an inside radius.");
    points[c].reference = on_reference + depths.first / sheet.thickness * step;
    points[c].other = on_reference + depths.second / sheet.thickness * step;
  }
  return points;
}

}  // namespace planish::brep
