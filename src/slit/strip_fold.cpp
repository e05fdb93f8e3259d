#include "strip_fold.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>

#include <cmath>
#include <cstddef>

// A strip placed quad by quad: each quad is the flat one, moved by the rotations about all ridges
// before it (math.md#strip-folding), so lengths are kept whatever the parameters are. A parameter's
// derivative is a twist of all that lies beyond its ridge; a ridge end that slides turns the ridge
// within its quad, which is the difference of two turns, about the normals before and after the
// fold.

namespace planish::slit_detail {
namespace {

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

double StripBase::width() const {
  if (known_width > 0.0) return known_width;
  if (sides[0].is_line() && sides[1].is_line()) return sides[1].across() - sides[0].across();
  constexpr int kPieces = 64;  // of each edge
  double twice = 0.0;
  std::array<Vec2, 2> before{};
  for (int piece = 0; piece <= kPieces; ++piece) {
    std::array<Vec2, 2> now;
    for (std::size_t side = 0; side < 2; ++side)
      now[side] = sides[side].place(start[side] + (end[side] - start[side]) * piece / kPieces).at;
    if (piece > 0) twice += planish::cross(now[1] - before[0], before[1] - now[0]);
    before = now;
  }
  return 0.5 * twice / unit();
}

Frame StripBase::along_last_ridge(const Frame& frame) const {
  const Vec2 ridge = (sides[1].place(end[1]).at - sides[0].place(end[0]).at).normalized();
  return {frame.origin, ridge.y() * frame.x - ridge.x() * frame.y,
          ridge.x() * frame.x + ridge.y() * frame.y, frame.z};
}

Vec2 StripBase::middle_of_start() const {
  return 0.5 * (sides[0].place(start[0]).at + sides[1].place(start[1]).at);
}

double abscissa(const StripBase& base, const StripParameters& p, int ridge, int side) {
  if (ridge == 0) return base.start[side];
  if (ridge == base.quads) return base.end[side];
  return base.unit() * p[abscissa_index(base.quads, ridge, side)];
}

StripParameters flat_parameters(const StripBase& base) {
  StripParameters p = StripParameters::Zero(parameter_count(base.quads));
  for (int ridge = 1; ridge < base.quads; ++ridge)
    for (int side = 0; side < 2; ++side) {
      const double start = base.start[side], share = static_cast<double>(ridge) / base.quads;
      p[abscissa_index(base.quads, ridge, side)] = (start + share * (base.end[side] - start)) /
                                                   base.unit();
    }
  return p;
}

EdgePlace place_of(const StripBase& base, const StripParameters& p, int ridge, int side) {
  return base.sides[side].place(abscissa(base, p, ridge, side));
}

StripFold folded(const StripBase& base, const StripParameters& p) {
  StripFold fold;
  const auto count = static_cast<std::size_t>(base.quads);
  fold.frames.reserve(count + 1);
  fold.frames.push_back(base.facet);
  for (std::size_t side = 0; side < 2; ++side) {
    fold.ends[side].reserve(count + 1);
    fold.flat[side].reserve(count + 1);
  }
  for (int ridge = 0; ridge <= base.quads; ++ridge) {
    const Frame before = fold.frames.back();
    for (int side = 0; side < 2; ++side) {
      fold.flat[side].push_back(place_of(base, p, ridge, side));
      fold.ends[side].push_back(before.point(fold.flat[side].back().at));
    }
    if (ridge == base.quads) break;
    const Vec2 left = fold.flat[0].back().at, along = fold.flat[1].back().at - left;
    fold.ridge_length.push_back(along.norm());
    const Vec3 axis = fold.before(ridge, along) / along.norm();
    Frame next = turned(before, fold.ends[0].back(), axis, p[ridge]);
    // The left end of the ridge stays in place to the last bit.
    next.origin = fold.ends[0].back() - left.x() * next.x - left.y() * next.y;
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
    const EdgePlace &a = fold.flat[0][ridge], &b = fold.flat[1][ridge];
    const Vec2 along = b.at - a.at;
    const Vec3 turn = base.unit() / (l * l) * (fold.frames[ridge].z - fold.quad(ridge).z);
    result[abscissa_index(base.quads, ridge, 0)] = {ridge, planish::cross(a.first, along) * turn,
                                                    right};
    result[abscissa_index(base.quads, ridge, 1)] = {ridge, -planish::cross(b.first, along) * turn,
                                                    left};
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
    derivative.col(abscissa_index(
        base.quads, ridge, side)) = base.unit() * fold.before(ridge, fold.flat[side][ridge].first);
  return derivative;
}

namespace {

/// Where a ridge ends on the chains that are cut, in place of the curves beside them.
std::array<EdgeCurve::Crossing, 2> ends_on_chains(const StripBase& base, const StripParameters& p,
                                                  const StripFold& fold, int ridge) {
  std::array<EdgeCurve::Crossing, 2> ends;
  for (int side = 0; side < 2; ++side) {
    const Vec2& own = fold.flat[side][ridge].at;
    ends[side] = base.sides[side].is_line()
                     ? EdgeCurve::Crossing{own, 0}
                     : base.sides[side].on_chain(fold.flat[1 - side][ridge].at, own,
                                                 abscissa(base, p, ridge, side));
  }
  return ends;
}

/// Corners of a chain between the ends of two ridges on it.
std::vector<Vec2> corners_between(const EdgeCurve& edge, const EdgeCurve::Crossing& from,
                                  const EdgeCurve::Crossing& to) {
  std::vector<Vec2> corners;
  if (edge.is_line()) return corners;
  const double touching = tolerance::kComputed *
                          (edge.chain().back() - edge.chain().front()).norm();
  for (int corner = from.line + 1; corner <= to.line; ++corner)
    if (const Vec2& at = edge.chain()[corner];
        (at - from.at).norm() > touching && (at - to.at).norm() > touching)
      corners.push_back(at);
  return corners;
}

}  // namespace

FoldedStrip folded_strip(const StripBase& base, const StripParameters& p) {
  const StripFold fold = folded(base, p);
  FoldedStrip strip;
  strip.quads.assign(fold.frames.begin() + 1, fold.frames.end());
  std::array<EdgeCurve::Crossing, 2> before;
  for (int ridge = 0; ridge <= base.quads; ++ridge) {
    const auto ends = ends_on_chains(base, p, fold, ridge);
    const Frame& frame = fold.frames[ridge];
    const auto in_space = [&](int side) -> Vec3 {
      return base.sides[side].is_line() ? fold.end(side, ridge) : frame.point(ends[side].at);
    };
    strip.ridges.push_back({{ends[0].at, ends[1].at},
                            {in_space(0), in_space(1)},
                            Angle::radians(ridge < base.quads ? p[ridge] : 0.0)});
    if (ridge > 0 && !(base.sides[0].is_line() && base.sides[1].is_line()))
      strip.borders.push_back({corners_between(base.sides[0], before[0], ends[0]),
                               corners_between(base.sides[1], before[1], ends[1])});
    before = ends;
  }
  return strip;
}

}  // namespace planish::slit_detail
