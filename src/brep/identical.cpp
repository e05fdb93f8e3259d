#include "identical.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/frame.hpp>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Eigenvalues>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <vector>

// A fingerprint of a solid that agrees for congruent copies: counts, and moments of points on its
// edges about their centroid, which no motion changes. One moment is a determinant of three of
// them, which a mirror changes in sign, so parts of the other hand differ. What agrees within the
// rounding of placed copies is the same body.

namespace planish::brep {
namespace {

std::vector<Vec3> edge_points(const TopTools_IndexedMapOfShape& edges) {
  std::vector<Vec3> points;
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    if (BRep_Tool::Degenerated(edge)) continue;
    const BRepAdaptor_Curve curve(edge);
    const double t0 = curve.FirstParameter();
    const double t1 = curve.LastParameter();
    for (const double share : {0.0, 0.5, 1.0}) {
      const gp_Pnt p = curve.Value(t0 + share * (t1 - t0));
      points.emplace_back(p.X(), p.Y(), p.Z());
    }
  }
  return points;
}

}  // namespace

Fingerprint fingerprint_of(const TopoDS_Solid& solid) {
  Fingerprint result;
  TopTools_IndexedMapOfShape faces, edges, vertices;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  TopExp::MapShapes(solid, TopAbs_EDGE, edges);
  TopExp::MapShapes(solid, TopAbs_VERTEX, vertices);
  result.counts = {faces.Extent(), edges.Extent(), vertices.Extent()};
  const std::vector<Vec3> points = edge_points(edges);
  if (points.empty()) return result;
  const double count = static_cast<double>(points.size());
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : points)
    centre += p / count;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  Vec3 third = Vec3::Zero();
  Vec3 fifth = Vec3::Zero();
  double second = 0.0;
  double fourth = 0.0;
  for (const Vec3& p : points) {
    const Vec3 d = p - centre;
    const double square = d.squaredNorm();
    inertia += d * d.transpose() / count;
    second += square / count;
    fourth += square * square / count;
    third += square * d / count;
    fifth += square * square * d / count;
  }
  const double size = std::sqrt(second);
  const Vec3 principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues();
  const Vec3 a = third / std::pow(size, 3);
  const Vec3 b = fifth / std::pow(size, 5);
  const Vec3 c = inertia * a / second;
  // A mirror changes the sign of the determinant.
  result.moments = {size,
                    principal.x() / second,
                    principal.y() / second,
                    principal.z() / second,
                    fourth / (second * second),
                    a.norm(),
                    b.norm(),
                    a.dot(b.cross(c))};
  return result;
}

bool identical(const Fingerprint& a, const Fingerprint& b) {
  if (a.counts != b.counts) return false;
  constexpr double kPlaced = tolerance::kWrittenDigits;  // placed copies are rounded again
  if (std::abs(a.moments[0] - b.moments[0]) > kPlaced * a.moments[0]) return false;
  for (size_t i = 1; i < a.moments.size(); ++i)
    if (std::abs(a.moments[i] - b.moments[i]) > kPlaced) return false;
  return true;
}

}  // namespace planish::brep
