#include "random_transitions.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

// What the surface between any two convex profiles must be, against the profiles themselves and
// against the hull of dense polygons on them.

namespace planish::test {
namespace {

constexpr double kExtent = 100.0;  // mm: random profiles are larger

/// Calls f(normal away from the hull, point on the first profile, point on the second) for the
/// rulings at some shares of every face.
template <typename Function>
void at_rulings(const Sheet& sheet, const std::vector<double>& shares, const Function& f) {
  for (const Face& face : sheet.faces) {
    const BorderLoop& loop = face.loops.front();
    if (const auto* frame = std::get_if<Frame>(&face.surface)) {
      f(frame->z, frame->point(start_of(loop.front().curve)),
        frame->point(start_of(loop.back().curve)));
      continue;
    }
    const auto& surface = std::get<Developable>(face.surface);
    // Across a nanometre, rounding turns the normals between the first ruling and the last.
    constexpr double kNarrow = 1e-8 * kExtent;
    const auto width = [&](const Curve2& border) {
      return (point_on(surface, end_of(border)) - point_on(surface, start_of(border))).norm();
    };
    const bool narrow = width(loop[0].curve) < kNarrow && width(loop[2].curve) < kNarrow;
    for (const double share : shares) {
      if (narrow && share > 0.0 && share < 1.0) continue;
      const Vec2 near = point_at(loop[0].curve, share);
      const double u = near.x();
      // The far border runs back; find the same ruling on it.
      const auto hits = crossings(loop[2].curve, Vec2(u, 0), Vec2(0, 1));
      const Vec2 far = share == 0.0   ? end_of(loop[2].curve)
                       : share == 1.0 ? start_of(loop[2].curve)
                       : hits.empty() ? start_of(loop[2].curve)
                                      : point_at(loop[2].curve, hits.front());
      f(Vec3(face.sense * normal_on(surface, u)), point_on(surface, near), point_on(surface, far));
    }
  }
}

/// Largest cosine between the normal and a profile's tangent at the points where rulings end on it.
double largest_lean(const PlacedProfile& profile, const Vec3& normal, const Vec3& p) {
  const Vec2 tangent = tangent_at(profile.profile, profile.frame.local2(p));
  return std::abs(normal.dot(tangent.x() * profile.frame.x + tangent.y() * profile.frame.y));
}

RC_GTEST_PROP(TransitionSurface, TouchesBothProfilesAlongEveryRuling, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const TransitionSpec spec = random_transition(random);
  Eigen::AlignedBox3d box;
  for (const auto* profile : {&spec.from, &spec.to})
    for (const Vec3& p : sampled_in_space(*profile, 10))
      box.extend(p);
  // At the ends of faces, which are knots, normals are exact; between knots within (tolerance /
  // reach)^¾.
  const double tolerance = TransitionOptions{}.tolerance * box.diagonal().norm();
  const auto touches = [&](const Vec3& normal, const Vec3& p, const Vec3& q, double limit) {
    RC_ASSERT(std::abs(normal.dot((q - p).normalized())) < limit);
    RC_ASSERT(largest_lean(spec.from, normal, p) < limit);
    RC_ASSERT(largest_lean(spec.to, normal, q) < limit);
  };
  for (const Sheet& piece : made(spec).pieces) {
    at_rulings(piece, {0.0, 1.0}, [&](const Vec3& normal, const Vec3& p, const Vec3& q) {
      touches(normal, p, q, 1e-10);
    });
    at_rulings(piece, {0.13, 0.5, 0.77}, [&](const Vec3& normal, const Vec3& p, const Vec3& q) {
      touches(normal, p, q, std::pow(tolerance / (q - p).norm(), 0.75));
    });
  }
}

/// Whether a point of a profile is a corner, where it has no tangent.
bool at_corner(const PlacedProfile& profile, const Vec3& p) {
  const auto* polygon = std::get_if<PolygonProfile>(&profile.profile);
  if (!polygon) return false;
  return std::ranges::any_of(polygon->corners, [&](const Vec2& corner) {
    return (profile.frame.point(corner) - p).norm() < 1e-9 * kExtent;
  });
}

/// Rulings as they are found, not as surfaces interpolate them: press lines lie anywhere.
RC_GTEST_PROP(TransitionSurface, HasOneTangentPlaneAlongEveryRuling, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  TransitionSpec spec = random_transition(random);
  spec.pressing = PressCount{9};
  for (const TrueLength& ruling : made(spec).true_lengths) {
    if (ruling.press.empty() || at_corner(spec.from, ruling.points[0]) ||
        at_corner(spec.to, ruling.points[1]))
      continue;
    const Vec3 along = (ruling.points[1] - ruling.points[0]).normalized();
    std::array<Vec3, 2> normals;
    for (std::size_t side = 0; side < 2; ++side) {
      const PlacedProfile& profile = side == 0 ? spec.from : spec.to;
      const Vec2 tangent = tangent_at(profile.profile, profile.frame.local2(ruling.points[side]));
      normals[side] = (tangent.x() * profile.frame.x + tangent.y() * profile.frame.y)
                          .cross(along)
                          .normalized();
    }
    RC_ASSERT(normals[0].cross(normals[1]).norm() < 1e-10);
  }
}

RC_GTEST_PROP(TransitionSurface, HasBothProfilesOnOneSideOfEveryTangentPlane, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const TransitionSpec spec = random_transition(random);
  const auto from = sampled_in_space(spec.from, 60), to = sampled_in_space(spec.to, 60);
  for (const Sheet& piece : made(spec).pieces)
    at_rulings(piece, {0.0, 0.21, 0.5, 0.86, 1.0},
               [&](const Vec3& normal, const Vec3& p, const Vec3&) {
                 for (const auto* ring : {&from, &to})
                   for (const Vec3& corner : *ring)
                     RC_ASSERT(normal.dot(corner - p) < 1e-9 * kExtent);
               });
}

/// Pairs at which a tangent of the wrong side was taken once: it has two through a point, close to
/// each other.
TEST(TransitionSurface, OfPairsWithTwoTangentsCloseToEachOther) {
  for (const unsigned seed : {441u, 1129u, 1245u, 1362u}) {
    std::mt19937 random(seed);
    const TransitionSpec spec = random_transition(random);
    EXPECT_NEAR(made(spec).area / oracle_area(spec.from, spec.to, 100), 1.0, 2e-6)
        << "seed " << seed;
  }
}

RC_GTEST_PROP(TransitionSurface, HasTheAreaOfTheHullOfDensePolygons, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const TransitionSpec spec = random_transition(random);
  const Transition transition = made(spec);
  const double expected = oracle_area(spec.from, spec.to, 100);
  RC_LOG() << transition.area / expected - 1.0 << '\n';
  RC_ASSERT(std::abs(transition.area / expected - 1.0) < 2e-6);
}

RC_GTEST_PROP(TransitionSurface, OfPolygonsIsTheirHull, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  TransitionSpec spec = random_transition(random);
  spec.from.profile = PolygonProfile{sampled_profile(spec.from.profile, 2)};
  spec.to.profile = PolygonProfile{sampled_profile(spec.to.profile, 3)};
  const double expected = lateral_area(sampled_in_space(spec.from, 1),
                                       sampled_in_space(spec.to, 1));
  const Transition transition = made(spec);
  RC_ASSERT(std::abs(transition.area / expected - 1.0) < 1e-11);
  for (const TransitionPatch& patch : transition.patches)
    RC_ASSERT(patch.kind == PatchKind::plane);
}

RC_GTEST_PROP(TransitionSurface, LaysFlatWithItsAreaAndItsBorders, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const TransitionSpec spec = random_transition(random);
  const Transition transition = made(spec);
  RC_ASSERT(transition.pieces.size() == 1u);
  const FlatPattern pattern = laid_flat(transition.pieces[0], spec);
  RC_ASSERT(std::abs(pattern.area / transition.area - 1.0) < 1e-9);
  const std::array profiles{spec.from, spec.to};
  for (std::size_t side = 0; side < 2; ++side) {
    const double length = oracle_perimeter(profiles[side].profile);
    RC_ASSERT(std::abs(transition.perimeters[side] / length - 1.0) < 1e-9);
    RC_ASSERT(std::abs(flat_border_length(transition, spec, profiles[side]) / length - 1.0) < 1e-9);
  }
  const FlattenOptions options = flatten_options(spec);
  const auto certificate = certify(transition.pieces[0], pattern,
                                   border_distance(transition.pieces[0]), options.curve_tolerance);
  RC_ASSERT(certificate.has_value());
  RC_LOG() << *certificate->refold_deviation << ' ' << certificate->length_error << '\n';
  RC_ASSERT(certificate->refold_deviation < 1e-5);
  RC_ASSERT(certificate->length_error < 1e-6);
  RC_ASSERT(std::abs(certificate->flat_area_half / transition.area - 1.0) < 1e-9);
}

}  // namespace
}  // namespace planish::test
