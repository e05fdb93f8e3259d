#pragma once

#include "edge_curve.hpp"

#include <planish/slit/folded_slit_sheet.hpp>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace planish::slit_detail {

/// What folding does not change: the strip's place in the flat sheet and its beginning in space.
struct StripBase {
  Frame facet;                     ///< of the panel, flat coordinates to space
  std::array<EdgeCurve, 2> sides;  ///< left and right
  std::array<double, 2> start{};   ///< abscissae of ridge 0
  std::array<double, 2> end{};     ///< of the last one
  int quads = 0;
  double known_width = 0.0;  ///< mean, where it was found before; 0: it was not

  double width() const;  ///< mean; of edges that are curves as long to find as folding the strip
  double area() const { return width() * unit(); }
  Vec2 middle_of_start() const;
  /// Mean length of its long edges, the unit of abscissae.
  double unit() const { return 0.5 * (end[0] + end[1] - start[0] - start[1]); }
  /// A frame of flat coordinates turned in its plane until y runs along the last ridge.
  Frame along_last_ridge(const Frame& frame) const;
};

/// The unknowns: fold angles of ridges 0 … quads−1 (radians), then the abscissae of both ends of
/// ridges 1 … quads−1, left and right in turn, in units of the strip's length.
using StripParameters = Eigen::VectorXd;
inline int parameter_count(int quads) { return 3 * quads - 2; }
inline int abscissa_index(int quads, int ridge, int side) { return quads + 2 * (ridge - 1) + side; }

/// Flat abscissa of a ridge's end, mm.
double abscissa(const StripBase& base, const StripParameters& p, int ridge, int side);
/// Where that is on the edge.
EdgePlace place_of(const StripBase& base, const StripParameters& p, int ridge, int side);

/// Equally spaced ridges, not folded.
StripParameters flat_parameters(const StripBase& base);

/// Velocity of everything beyond a ridge as one parameter grows: x ↦ axis × (x − pole).
struct Twist {
  int ridge = 0;
  Vec3 axis;
  Vec3 pole;
  Vec3 velocity(const Vec3& x) const { return axis.cross(x - pole); }
};

/// A strip placed quad by quad: quad i is the flat one moved by a product of rotations about ridges
/// 0 … i (math.md#strip-folding), so lengths are kept for any parameters.
struct StripFold {
  std::vector<Frame> frames;              ///< frames[0] is the facet's, frames[i+1] that of quad i
  std::array<std::vector<Vec3>, 2> ends;  ///< of ridges 0 … quads
  std::array<std::vector<EdgePlace>, 2> flat;  ///< of the same
  std::vector<double> ridge_length;            ///< of ridges 0 … quads−1
  const Frame& quad(int i) const { return frames[i + 1]; }
  const Vec3& end(int side, int ridge) const { return ends[side][ridge]; }
  /// A direction of the flat sheet in the quad before a ridge.
  Vec3 before(int ridge, const Vec2& v) const {
    return v.x() * frames[ridge].x + v.y() * frames[ridge].y;
  }
};
StripFold folded(const StripBase& base, const StripParameters& p);

/// One twist per parameter. A fold angle turns about its ridge. A ridge end that slides along its
/// side by v dx turns the ridge's line d in the quad before it about its other end by v × d/l² dx;
/// conjugating the fold with that turn moves what lies beyond by the difference of the turns about
/// the normals before and after the fold.
std::vector<Twist> twists(const StripBase& base, const StripFold& fold);

/// Derivative of a ridge's end with respect to all parameters.
Eigen::Matrix3Xd end_derivative(const StripBase& base, const StripFold& fold,
                                const std::vector<Twist>& twists, int side, int ridge);

/// The fold as the public type.
FoldedStrip folded_strip(const StripBase& base, const StripParameters& p);

}  // namespace planish::slit_detail
