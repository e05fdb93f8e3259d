#pragma once

#include <planish/sheet/facets.hpp>

#include <vector>

namespace planish::sheet_detail {

/// A bend cut along rulings into facets that are nearly flat.
class BendFacets {
 public:
  /// Rulings by equal turns of the normal.
  BendFacets(const Sheet& sheet, const Layout& layout, BendId bend, const FacetOptions& options);

  /// Adds a border loop of one of its faces; `joined` marks the borders that are not edges of the
  /// sheet.
  void add_loop(FaceId face, int loop, const std::vector<bool>& joined);
  /// Makes the polygons once all loops are added.
  void close();

  int count() const { return static_cast<int>(rulings_.size()) - 1; }
  /// Ruling i of count() + 1 in the pattern, towards growing v.
  Segment ruling(int i) const;
  /// Outward normal in the middle of a facet, in space.
  Vec3 normal(int strip) const { return normals_[strip]; }
  /// Turn from a facet to the one beside it, about the ruling between them.
  double turn(int from, int to) const;
  /// The facet at u; at a ruling between two, the one on the side of the face.
  int beside(FaceId face, double u) const;
  /// From the pattern into space, for a facet; `depth` below the reference surface.
  Eigen::Isometry3d in_space(int strip, double depth) const;

  const std::vector<Polygon>& polygons(int strip) const { return polygons_[strip]; }
  /// Its edges of the sheet; borders are numbered from 0.
  struct Edge {
    Segment line;
    int border;
  };
  const std::vector<Edge>& edges(int strip) const { return edges_[strip]; }
  /// An edge of the sheet, and the feature that it outlines, if any.
  struct Outline {
    BorderRef border;
    std::optional<FeatureId> feature;
  };
  const std::vector<Outline>& borders() const { return borders_; }

 private:
  struct UvSegment {
    Vec2 a, b;  ///< a.x() <= b.x()
  };
  Vec2 image(const Vec2& uv) const { return placement_ * development_.develop(uv); }
  double u_of_strip(int strip) const {
    return 0.5 * (rulings_[strip] + rulings_[static_cast<size_t>(strip) + 1]);
  }
  int strip_at(double u) const;
  void add_stops(const Curve2& curve, std::vector<double>& stops) const;
  std::vector<Vec2> sampled_in_strips(const Curve2& curve) const;
  void place_rulings(const FacetOptions& options);

  const Sheet& sheet_;
  const Face& face_;  ///< one of its faces: all are of one surface
  const Development& development_;
  Isometry2 placement_;
  double chord_;
  double lo_, hi_, v_lo_, v_hi_;
  double speed_ = 1.0;  ///< largest length of a unit step of u, mm
  std::vector<double> rulings_;
  std::vector<Vec3> normals_;
  std::vector<std::vector<UvSegment>> sides_;
  std::vector<std::vector<Polygon>> polygons_;
  std::vector<std::vector<Edge>> edges_;
  std::vector<Outline> borders_;
};

}  // namespace planish::sheet_detail
