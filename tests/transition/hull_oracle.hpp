#pragma once

#include <planish/transition/profile.hpp>

#include <array>
#include <vector>

// An independent look at transitions: profiles as densely sampled polygons, and the lateral faces
// of the convex hull of two of them by search.

namespace planish::test {

/// The closed C² cubic spline of a profile, its second derivatives by relaxation.
class OracleSpline {
 public:
  explicit OracleSpline(std::vector<Vec2> points);
  /// Point and first derivative on piece i, at a share of its chord.
  std::array<Vec2, 2> at(std::size_t i, double share) const;
  std::size_t count() const { return points_.size(); }

 private:
  const Vec2& point(std::size_t i) const { return points_[i % points_.size()]; }
  std::vector<Vec2> points_, seconds_;
  std::vector<double> chords_;
};

/// Corners of polygons; of curves `fineness` points a quarter (a spline: a piece), straight sides
/// whole.
std::vector<Vec2> sampled_profile(const Profile& profile, int fineness);
std::vector<Vec3> sampled_in_space(const PlacedProfile& profile, int fineness);

/// Unit tangent of the profile at a point on it, in its plane, either way; zero on corners.
Vec2 tangent_at(const Profile& profile, const Vec2& p);

/// Length of a profile: sums of chords at two densities, extrapolated.
double oracle_perimeter(const Profile& profile);

/// Area of the lateral faces of the convex hull of two polygons in two planes, each on one side of
/// the other's: a triangle stands on each edge, its tip the corner of the other polygon that lies
/// farthest out.
double lateral_area(std::vector<Vec3> first, std::vector<Vec3> second);

/// The same of two profiles, extrapolated from two densities.
double oracle_area(const PlacedProfile& first, const PlacedProfile& second, int fineness);

}  // namespace planish::test
