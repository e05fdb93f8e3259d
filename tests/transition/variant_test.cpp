#include "random_transitions.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

// What must not matter: where the profiles are, how they are numbered, which comes first.

namespace planish::test {
namespace {

struct TransitionTraits {
  double area = 0.0;
  std::array<double, 2> perimeters{};
  std::vector<double> planes, others;  // areas of patches, ascending
};

TransitionTraits traits_of(const TransitionSpec& spec) {
  const auto transition_made = make_transition(
      spec, {.tolerance = 1e-6});  // measures do not depend on it
  RC_ASSERT(transition_made.has_value());
  const Transition& transition = *transition_made;
  TransitionTraits traits{transition.area, transition.perimeters, {}, {}};
  for (const TransitionPatch& patch : transition.patches)
    (patch.kind == PatchKind::plane ? traits.planes : traits.others).push_back(patch.area);
  std::ranges::sort(traits.planes);
  std::ranges::sort(traits.others);
  return traits;
}

void expect_same(const TransitionTraits& a, const TransitionTraits& b, double scale = 1.0) {
  constexpr double kClose = 1e-9;
  const double square = scale * scale;
  RC_ASSERT(std::abs(b.area / (square * a.area) - 1.0) < kClose);
  for (std::size_t side = 0; side < 2; ++side)
    RC_ASSERT(std::abs(b.perimeters[side] / (scale * a.perimeters[side]) - 1.0) < kClose);
  RC_ASSERT(a.planes.size() == b.planes.size());
  RC_ASSERT(a.others.size() == b.others.size());
  for (std::size_t i = 0; i < a.planes.size(); ++i)
    RC_ASSERT(std::abs(b.planes[i] - square * a.planes[i]) < square * kClose * a.area);
  for (std::size_t i = 0; i < a.others.size(); ++i)
    RC_ASSERT(std::abs(b.others[i] - square * a.others[i]) < square * kClose * a.area);
}

RC_GTEST_PROP(TransitionVariants, MovingChangesNothing, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  TransitionSpec spec = random_transition(random);
  const TransitionTraits before = traits_of(spec);
  const auto motion = random_motion(random);
  spec.from = moved(spec.from, motion);
  spec.to = moved(spec.to, motion);
  expect_same(before, traits_of(spec));
}

RC_GTEST_PROP(TransitionVariants, NormalsOfTheFramesDoNotMatter, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  TransitionSpec spec = random_transition(random);
  const TransitionTraits before = traits_of(spec);
  // All profiles but polygons and splines are their own mirror images.
  for (PlacedProfile* profile : {&spec.from, &spec.to}) {
    profile->frame.y = -profile->frame.y;
    profile->frame.z = -profile->frame.z;
    if (auto* polygon = std::get_if<PolygonProfile>(&profile->profile))
      for (Vec2& p : polygon->corners)
        p.y() = -p.y();
    if (auto* spline = std::get_if<SplineProfile>(&profile->profile))
      for (Vec2& p : spline->points)
        p.y() = -p.y();
  }
  expect_same(before, traits_of(spec));
}

RC_GTEST_PROP(TransitionVariants, MirroringChangesNothing, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  TransitionSpec spec = random_transition(random);
  const TransitionTraits before = traits_of(spec);
  // In the plane x = 0: both axes of a profile are mirrored, its normal is what a right-handed
  // frame makes it.
  for (PlacedProfile* profile : {&spec.from, &spec.to}) {
    Frame& frame = profile->frame;
    for (Vec3* v : {&frame.origin, &frame.x, &frame.y})
      v->x() = -v->x();
    frame.z = frame.x.cross(frame.y);
  }
  expect_same(before, traits_of(spec));
}

RC_GTEST_PROP(TransitionVariants, SwappingTheProfilesChangesNothing, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  TransitionSpec spec = random_transition(random);
  const TransitionTraits before = traits_of(spec);
  std::swap(spec.from, spec.to);
  TransitionTraits after = traits_of(spec);
  std::swap(after.perimeters[0], after.perimeters[1]);
  expect_same(before, after);
}

RC_GTEST_PROP(TransitionVariants, ScalingScales, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  TransitionSpec spec = random_transition(random);
  const TransitionTraits before = traits_of(spec);
  struct Scale {
    void operator()(PolygonProfile& p) const { scale(p.corners); }
    void operator()(SplineProfile& p) const { scale(p.points); }
    void operator()(EllipseProfile& p) const { p = {10 * p.rx, 10 * p.ry}; }
    void operator()(RoundedRectangleProfile& p) const {
      p = {10 * p.width, 10 * p.height, 10 * p.radius};
    }
    void operator()(ObroundProfile& p) const { p = {10 * p.length, 10 * p.width}; }
    static void scale(std::vector<Vec2>& points) {
      for (Vec2& p : points)
        p *= 10.0;
    }
  };
  for (PlacedProfile* profile : {&spec.from, &spec.to}) {
    std::visit(Scale{}, profile->profile);
    profile->frame.origin *= 10.0;
  }
  expect_same(before, traits_of(spec), 10.0);
}

RC_GTEST_PROP(TransitionVariants, NumberingOfCornersAndPointsDoesNotMatter, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  TransitionSpec spec = random_transition(random);
  const TransitionTraits before = traits_of(spec);
  const auto renumber = [&](std::vector<Vec2>& points) {
    std::rotate(points.begin(), points.begin() + static_cast<long>(random() % points.size()),
                points.end());
    if (random() % 2 == 0) std::ranges::reverse(points);
  };
  for (PlacedProfile* profile : {&spec.from, &spec.to}) {
    if (auto* polygon = std::get_if<PolygonProfile>(&profile->profile)) renumber(polygon->corners);
    if (auto* spline = std::get_if<SplineProfile>(&profile->profile)) renumber(spline->points);
  }
  expect_same(before, traits_of(spec));
}

RC_GTEST_PROP(TransitionVariants, TurningACircleAboutItsAxisChangesNothing, ()) {
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  TransitionSpec spec = random_transition(random);
  spec.from.profile = EllipseProfile{45, 45};
  spec.from.frame = frame_at(Vec3::Zero());
  const auto below = sampled_in_space(spec.from, 50);
  RC_PRE(
      std::ranges::all_of(below, [&](const Vec3& p) { return spec.to.frame.local(p).z() < -1.0; }));
  const TransitionTraits before = traits_of(spec);
  spec.from.frame = frame_at(Vec3::Zero(), 0.0, 0.3 + 0.001 * static_cast<double>(random() % 1000));
  expect_same(before, traits_of(spec));
}

}  // namespace
}  // namespace planish::test
