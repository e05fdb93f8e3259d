#include "sheet_corners.hpp"

#include "border_curve.hpp"
#include "refusals.hpp"
#include "side_wall.hpp"

#include <planish/base/union_find.hpp>

#include <Eigen/QR>

// Corners of a sheet as vertices of its solid: starts of borders, united over joints. On the other
// skin a corner is the shortest step that lies the thickness below every plane that meets there,
// which mitres sharp joints and is one normal elsewhere. A mitre that becomes too long is refused,
// as the walls beside it would turn over.

namespace planish::brep {
namespace {

/// The tangent planes that meet at a corner: one for each direction.
void add_direction(std::vector<Vec3>& normals, const Vec3& normal) {
  constexpr double kSame = 1e-4;  // radians
  for (const Vec3& n : normals)
    if ((n - normal).norm() < kSame) return;
  normals.push_back(normal);
}

/// The shortest step from the reference skin that lies the thickness below every plane.
Vec3 mitre(const std::vector<Vec3>& normals, double thickness) {
  Eigen::MatrixXd rows(normals.size(), 3);
  for (std::size_t i = 0; i < normals.size(); ++i)
    rows.row(static_cast<int>(i)) = normals[i];
  const Eigen::VectorXd depths = Eigen::VectorXd::Constant(static_cast<int>(normals.size()),
                                                           -thickness);
  return rows.completeOrthogonalDecomposition().solve(depths);
}

}  // namespace

SheetCorners::SheetCorners(const Sheet& sheet) : topology_(sheet) {
  UnionFind starts(static_cast<int>(topology_.border_count()));  // that lie in one corner
  const auto unite = [&](BorderId a, BorderId b) { starts.unite(index_of(a), index_of(b)); };
  for (const BorderId border : topology_.borders())
    leader_.push_back(border);
  for (const Joint& joint : sheet.joints) {
    const BorderId a = topology_.id_of(joint.a), b = topology_.id_of(joint.b);
    leader_[b] = a;
    unite(a, topology_.next(b));
    unite(topology_.next(a), b);
  }

  std::vector<int> number(topology_.border_count(), -1);
  for (const BorderId border : topology_.borders()) {
    int& n = number[starts.root(index_of(border))];
    if (n < 0) {
      n = count();
      sharp_.push_back(false);
    }
    corner_.push_back(n);
  }
  for (const Joint& joint : sheet.joints)
    if (joint.sharp)
      for (const BorderRef& ref : {joint.a, joint.b})
        sharp_[at_start(topology_.id_of(ref))] = true;
}

Result<std::vector<CornerPoints>> corner_points(const Sheet& sheet, const SheetCorners& corners) {
  std::vector<CornerPoints> points(corners.count());
  std::vector<int> count(corners.count(), 0);
  std::vector<std::vector<Vec3>> normals(corners.count());
  std::vector<Vec3> middle(corners.count(), Vec3::Zero());
  const Depths depths(sheet);
  for (const BorderId border : corners.topology().borders()) {
    const BorderRef& ref = corners.topology()[border];
    const Face& face = sheet[ref.face];
    const Vec2 uv = start_of(sheet[ref].curve);
    const int c = corners.at_start(border);
    points[c].reference += point_below(face, uv, depths.first);
    points[c].other += point_below(face, uv, depths.second);
    middle[c] += skin_point(face, uv);
    add_direction(normals[c], outward_normal(face, uv));
    ++count[c];
  }
  for (int c = 0; c < corners.count(); ++c) {
    points[c].reference /= count[c];
    points[c].other /= count[c];
    if (!corners.is_sharp(c)) continue;
    const Vec3 step = mitre(normals[c], sheet.thickness);
    const Vec3 on_reference = middle[c] / count[c];
    if (!(step.norm() < 10 * sheet.thickness))
      return fail(refuse::mitre_too_long, {{"at", place::point(on_reference)}});
    points[c].reference = on_reference + depths.first / sheet.thickness * step;
    points[c].other = on_reference + depths.second / sheet.thickness * step;
  }
  return points;
}

}  // namespace planish::brep
