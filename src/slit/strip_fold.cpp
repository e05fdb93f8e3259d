#include "strip_fold.hpp"

#include <cmath>
#include <cstddef>

// A strip placed quad by quad: each quad is the flat one, moved by the rotations about all ridges
// before it (math.md#strip-folding), so lengths are kept whatever the parameters are. A parameter's
// derivative is a twist of all that lies beyond its ridge; a ridge end that slides turns the ridge
// within its quad, which is the difference of two turns, about the normals before and after the
// fold.

namespace planish::slit_detail {
namespace {

/// Both ends of a ridge in the flat sheet.
std::array<Vec2, 2> flat_ridge(const StripBase& base, const StripParameters& p, int ridge) {
  return {Vec2(abscissa(base, p, ridge, 0), base.sides[0]),
          Vec2(abscissa(base, p, ridge, 1), base.sides[1])};
}

/// The frame turned about a line through `point`.
Frame turned(const Frame& frame, const Vec3& point, const Vec3& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turn = [&](const Vec3& v) -> Vec3 {
    return c * v + s * axis.cross(v) + (1.0 - c) * axis.dot(v) * axis;
  };
  Frame result;
  result.origin = point + turn(frame.origin - point);
  result.z = turn(frame.z).normalized();
  result.x = turn(frame.x);
  result.x = (result.x - result.x.dot(result.z) * result.z).normalized();
  result.y = result.z.cross(result.x);
  return result;
}

}  // namespace

double abscissa(const StripBase& base, const StripParameters& p, int ridge, int side) {
  if (ridge == 0) return base.start[side];
  if (ridge == base.quads) return base.end;
  return base.unit() * p[abscissa_index(base.quads, ridge, side)];
}

StripParameters flat_parameters(const StripBase& base) {
  StripParameters p = StripParameters::Zero(parameter_count(base.quads));
  for (int ridge = 1; ridge < base.quads; ++ridge)
    for (int side = 0; side < 2; ++side) {
      const double start = base.start[side], share = static_cast<double>(ridge) / base.quads;
      p[abscissa_index(base.quads, ridge, side)] = (start + share * (base.end - start)) /
                                                   base.unit();
    }
  return p;
}

StripFold folded(const StripBase& base, const StripParameters& p) {
  StripFold fold;
  const auto count = static_cast<std::size_t>(base.quads);
  fold.frames.reserve(count + 1);
  fold.frames.push_back(base.facet);
  for (auto& ends : fold.ends)
    ends.reserve(count + 1);
  for (int ridge = 0; ridge <= base.quads; ++ridge) {
    const auto flat = flat_ridge(base, p, ridge);
    const Frame before = fold.frames.back();
    for (std::size_t side = 0; side < 2; ++side)
      fold.ends[side].push_back(before.point(flat[side]));
    if (ridge == base.quads) break;
    const Vec2 along = flat[1] - flat[0];
    fold.ridge_length.push_back(along.norm());
    const Vec3 axis = (along.x() * before.x + along.y() * before.y) / along.norm();
    Frame next = turned(before, fold.ends[0].back(), axis, p[ridge]);
    // The left end of the ridge stays in place to the last bit.
    next.origin = fold.ends[0].back() - flat[0].x() * next.x - flat[0].y() * next.y;
    fold.frames.push_back(next);
  }
  return fold;
}

std::vector<Twist> twists(const StripBase& base, const StripFold& fold) {
  std::vector<Twist> result(static_cast<std::size_t>(parameter_count(base.quads)));
  for (int ridge = 0; ridge < base.quads; ++ridge) {
    const Vec3 &left = fold.end(0, ridge), &right = fold.end(1, ridge);
    const double l = fold.ridge_length[ridge];
    result[ridge] = {ridge, (right - left) / l, left};
    if (ridge == 0) continue;
    const Vec3 turn = base.unit() * base.width() / (l * l) *
                      (fold.frames[ridge].z - fold.quad(ridge).z);
    result[abscissa_index(base.quads, ridge, 0)] = {ridge, turn, right};
    result[abscissa_index(base.quads, ridge, 1)] = {ridge, -turn, left};
  }
  return result;
}

Eigen::Matrix3Xd end_derivative(const StripBase& base, const StripFold& fold,
                                const std::vector<Twist>& twists, int side, int ridge) {
  const Vec3& at = fold.end(side, ridge);
  Eigen::Matrix3Xd derivative(3, static_cast<Eigen::Index>(twists.size()));
  for (std::size_t q = 0; q < twists.size(); ++q) {
    if (twists[q].ridge < ridge)
      derivative.col(static_cast<Eigen::Index>(q)) = twists[q].velocity(at);
    else
      derivative.col(static_cast<Eigen::Index>(q)).setZero();
  }
  if (ridge > 0 && ridge < base.quads)
    derivative.col(abscissa_index(base.quads, ridge, side)) = base.unit() * fold.frames[ridge].x;
  return derivative;
}

FoldedStrip folded_strip(const StripBase& base, const StripParameters& p) {
  const StripFold fold = folded(base, p);
  FoldedStrip strip;
  strip.quads.assign(fold.frames.begin() + 1, fold.frames.end());
  for (int ridge = 0; ridge <= base.quads; ++ridge)
    strip.ridges.push_back({flat_ridge(base, p, ridge),
                            {fold.end(0, ridge), fold.end(1, ridge)},
                            Angle::radians(ridge < base.quads ? p[ridge] : 0.0)});
  return strip;
}

}  // namespace planish::slit_detail
