#pragma once

#include <planish/geometry/mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// Closed surfaces as triangles, made by hand: blocks, and strips of sheet given by the path of
// their middle, drawn out along z.

namespace planish::test {

inline int add_face(MeshOfFaces& surface) {
  return surface.face.empty() ? 0 : std::ranges::max(surface.face) + 1;
}

inline void add_triangle(MeshOfFaces& surface, int face, const Vec3& a, const Vec3& b,
                         const Vec3& c) {
  const int first = static_cast<int>(surface.mesh.points.size());
  surface.mesh.points.insert(surface.mesh.points.end(), {a, b, c});
  surface.mesh.triangles.push_back({first, first + 1, first + 2});
  surface.face.push_back(face);
}

/// a, b, c, d counter-clockwise seen from outside.
inline void add_quad(MeshOfFaces& surface, int face, const Vec3& a, const Vec3& b, const Vec3& c,
                     const Vec3& d) {
  add_triangle(surface, face, a, b, c);
  add_triangle(surface, face, a, c, d);
}

inline void append(MeshOfFaces& surface, const MeshOfFaces& more) {
  const int first = static_cast<int>(surface.mesh.points.size()), face = add_face(surface);
  surface.mesh.points.insert(surface.mesh.points.end(), more.mesh.points.begin(),
                             more.mesh.points.end());
  for (const auto& t : more.mesh.triangles)
    surface.mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  for (const int f : more.face)
    surface.face.push_back(face + f);
}

inline MeshOfFaces moved(MeshOfFaces surface, const Eigen::Isometry3d& motion) {
  for (Vec3& p : surface.mesh.points)
    p = motion * p;
  return surface;
}

/// A prism over a convex quadrilateral, counter-clockwise, of which each side is `cells` cells.
inline MeshOfFaces quad_prism(const std::array<Vec2, 4>& ring, double low, double high,
                              int cells = 1) {
  MeshOfFaces surface;
  // Six sides as bilinear patches of corners counter-clockwise seen from outside.
  const auto at = [&](int i, double z) { return Vec3(ring[i].x(), ring[i].y(), z); };
  const auto side = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const int face = add_face(surface);
    const auto point = [&](int i, int j) -> Vec3 {
      const double u = double(i) / cells, v = double(j) / cells;
      return (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d;
    };
    for (int i = 0; i < cells; ++i)
      for (int j = 0; j < cells; ++j)
        add_quad(surface, face, point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
  };
  side(at(0, high), at(1, high), at(2, high), at(3, high));
  side(at(3, low), at(2, low), at(1, low), at(0, low));
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    side(at(i, low), at(j, low), at(j, high), at(i, high));
  }
  return surface;
}

inline MeshOfFaces block(const Vec3& low, const Vec3& high, int cells = 1) {
  return quad_prism({Vec2(low.x(), low.y()), Vec2(high.x(), low.y()), Vec2(high.x(), high.y()),
                     Vec2(low.x(), high.y())},
                    low.z(), high.z(), cells);
}

/// The middle of a strip in section: straight pieces and arcs to the left (negative: right), each
/// of which begins where and as the one before ends.
class Path {
 public:
  Path& straight(double length) {
    add(at_, heading_);
    at_ += length * along();
    add(at_, heading_);
    return *this;
  }
  /// `chord`: largest distance of chords from the arcs of both skins of a sheet this thick.
  Path& arc(double radius, double angle, double thickness, double chord) {
    const double outer = radius + thickness / 2;
    const int count = static_cast<int>(
        std::ceil(std::abs(angle) / (2 * std::acos(1 - chord / outer))));
    const double side = angle > 0 ? 1.0 : -1.0;
    const Vec2 centre = at_ + side * radius * left();
    const Vec2 spoke = at_ - centre;
    const double from = heading_;
    for (int i = 0; i <= count; ++i) {
      const double turn = angle * i / count;
      add(centre + Eigen::Rotation2Dd(turn) * spoke, from + turn);
    }
    at_ = points_.back();
    heading_ = headings_.back();
    return *this;
  }
  const Vec2& at() const { return at_; }

  /// The sheet about the path from z = 0 to the width. Faces: left skin, right skin, both ends,
  /// both sides.
  MeshOfFaces sheet(double thickness, double width) const {
    std::vector<Vec2> lefts, rights;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vec2 left(-std::sin(headings_[i]), std::cos(headings_[i]));
      lefts.push_back(points_[i] + thickness / 2 * left);
      rights.push_back(points_[i] - thickness / 2 * left);
    }
    const auto up = [](const Vec2& p, double z) { return Vec3(p.x(), p.y(), z); };
    MeshOfFaces surface;
    const std::size_t n = points_.size() - 1;
    for (std::size_t i = 0; i < n; ++i) {
      add_quad(surface, 0, up(lefts[i], 0), up(lefts[i], width), up(lefts[i + 1], width),
               up(lefts[i + 1], 0));
      add_quad(surface, 1, up(rights[i], 0), up(rights[i + 1], 0), up(rights[i + 1], width),
               up(rights[i], width));
      add_quad(surface, 4, up(lefts[i], 0), up(lefts[i + 1], 0), up(rights[i + 1], 0),
               up(rights[i], 0));
      add_quad(surface, 5, up(lefts[i], width), up(rights[i], width), up(rights[i + 1], width),
               up(lefts[i + 1], width));
    }
    add_quad(surface, 2, up(lefts[0], 0), up(rights[0], 0), up(rights[0], width),
             up(lefts[0], width));
    add_quad(surface, 3, up(lefts[n], 0), up(lefts[n], width), up(rights[n], width),
             up(rights[n], 0));
    return surface;
  }

 private:
  Vec2 along() const { return {std::cos(heading_), std::sin(heading_)}; }
  Vec2 left() const { return {-std::sin(heading_), std::cos(heading_)}; }
  void add(const Vec2& point, double heading) {
    if (!points_.empty() && (points_.back() - point).norm() == 0.0) return;
    points_.push_back(point);
    headings_.push_back(heading);
  }

  Vec2 at_ = Vec2::Zero();
  double heading_ = 0.0;
  std::vector<Vec2> points_;
  std::vector<double> headings_;
};

}  // namespace planish::test
