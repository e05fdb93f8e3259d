#include "strip_work.hpp"

#include "checks.hpp"
#include "crossing.hpp"
#include "sample_sheets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planish::test {
namespace {

using namespace slit_detail;

/// A design as a session begins with it, its strips flat.
Snapshot snapshot_of(SlitDesign design) {
  design = with_fitted_curves(std::move(design)).value();
  Panels panels = checked_panels(design).value();
  Snapshot now;
  now.panel = std::make_shared<const std::vector<PanelFacet>>(std::move(panels.first));
  now.second_panel = std::make_shared<const std::vector<PanelFacet>>(std::move(panels.second));
  auto clouds = points_by_strip(design).value();
  for (auto& cloud : clouds)
    now.slots.push_back(
        std::make_shared<const Slot>(Slot{{}, {}, scan_of(std::move(cloud)), {}, {}}));
  design.ends.resize(design.sheet.strips.size());
  take_seat_curve(now, design);
  now.design = std::make_shared<const SlitDesign>(std::move(design));
  return now;
}

/// The ends of a strip's ridges from the second on, on both sides.
std::vector<Vec3> moving_ends(const FoldedStrip& strip) {
  std::vector<Vec3> ends;
  for (std::size_t ridge = 1; ridge < strip.ridges.size(); ++ridge)
    for (const Vec3& end : strip.ridges[ridge].folded)
      ends.push_back(end);
  return ends;
}

/// The radius of the tightest arc that turns by a fold on the halves of both its quads. The panel
/// is not bent, and the quad at the symmetry plane belongs to the last ridge whole.
double tightest_of(const FoldedStrip& strip) {
  double radius = std::numeric_limits<double>::infinity();
  const std::size_t quads = strip.quads.size();
  for (std::size_t ridge = 0; ridge < quads; ++ridge) {
    const SlitRidge& here = strip.ridges[ridge];
    const double width = here.flat[1].y() - here.flat[0].y();
    const double length = (here.flat[1] - here.flat[0]).norm();
    const double tangent = std::tan(0.5 * std::abs(here.fold.radians()));
    for (const std::size_t side : {0u, 1u}) {
      const auto from = [&](std::size_t other) {
        return std::abs(strip.ridges[other].flat[side].x() - here.flat[side].x());
      };
      const double before = ridge > 0 ? 0.5 * from(ridge - 1) : 0.0,
                   behind = (ridge + 1 == quads ? 1.0 : 0.5) * from(ridge + 1);
      radius = std::min(radius, 0.5 * (before + behind) * width / length / tangent);
    }
  }
  return radius;
}

TEST(WorkOn, MeasuresTheStripThatItSolves) {
  SlitDesign design = chair();
  design.anchors = {{2, 5, StripEdge::left, {180, 330, 150}},
                    {2, 8, StripEdge::right, {60, 300, 170}},
                    {3, 5, StripEdge::left, {180, 330, 210}}};
  design.scans = {{1, {Vec3(150, 350, 90)}}};
  Snapshot now = snapshot_of(design);
  for (const int strip : {1, 2, 4}) {
    const StripSolution solution = work_on(now, strip, Clear::of_mirror, {});
    const StripState& state = now.slot(strip).state;
    const FoldedStrip shape = folded_of(now, strip);
    EXPECT_EQ(state.status, StripStatus::solved) << strip;
    EXPECT_EQ(now.slot(strip).p, solution.p);
    EXPECT_EQ(state.iterations, solution.iterations);
    EXPECT_GT(state.iterations, 0);
    EXPECT_EQ(state.objective, solution.objective);
    EXPECT_EQ(state.shortfall, 0.0);
    EXPECT_FALSE(state.crosses_plane);
    const auto& last = shape.ridges.back().folded;
    EXPECT_NEAR(state.gap, std::max(std::abs(last[0].x()), std::abs(last[1].x())), 1e-12);
    EXPECT_NEAR(state.min_radius, tightest_of(shape), 1e-9 * state.min_radius);
    EXPECT_EQ(state.too_tight, state.min_radius < design.sheet.min_radius());

    double seat = 0.0, anchored = 0.0, scanned = 0.0;
    for (const Vec3& end : last) {
      double nearest = 1e300;
      for (int i = 0; i <= 20000; ++i)
        nearest = std::min(
            nearest, (bezier_at(*design.seat_curve, i / 20000.0).point - end.tail<2>()).norm());
      seat = std::max(seat, nearest);
    }
    for (const SlitAnchor& anchor : design.anchors)
      if (anchor.strip == strip)
        anchored = std::max(
            anchored,
            (shape.ridges[anchor.ridge].folded[anchor.side == StripEdge::left ? 0 : 1] - anchor.at)
                .norm());
    EXPECT_NEAR(state.seat_distance, seat, 1e-2) << strip;
    EXPECT_NEAR(state.anchor_distance, anchored, 1e-9) << strip;
    const auto ends = moving_ends(shape);
    if (strip == 1)
      for (const Vec3& end : ends)
        scanned += (end - Vec3(150, 350, 90)).squaredNorm() / static_cast<double>(ends.size());
    EXPECT_NEAR(state.scan_distance, std::sqrt(scanned), 1e-9) << strip;

    Eigen::AlignedBox3d box;
    for (const SlitRidge& ridge : shape.ridges)
      for (const Vec3& end : ridge.folded)
        box.extend(end);
    EXPECT_NEAR((box.min() - now.slot(strip).box.min()).norm(), 0.0, 1e-9);
    EXPECT_NEAR((box.max() - now.slot(strip).box.max()).norm(), 0.0, 1e-9);
  }
  EXPECT_EQ(now.slot(0).p.size(), 0) << "others are left alone";
}

TEST(WorkOn, StaysOpenWhenItsStepsAreUsedUpAndGoesOnFromThere) {
  Snapshot now = snapshot_of(chair());
  work_on(now, 2, Clear::of_mirror, {.max_iterations = 2});
  EXPECT_EQ(now.slot(2).state.status, StripStatus::open);
  EXPECT_LE(now.slot(2).state.gap, 1e-9 * 464) << "its end is in place after each step";
  work_on(now, 2, Clear::of_mirror, {});
  EXPECT_EQ(now.slot(2).state.status, StripStatus::solved);
}

TEST(WorkOn, SaysByHowMuchAStripIsTooShort) {
  SlitDesign design = chair();
  design.sheet.half_length = 300.0;  // of 360 to the plane
  Snapshot now = snapshot_of(design);
  work_on(now, 3, Clear::of_mirror, {});
  const StripState& state = now.slot(3).state;
  EXPECT_EQ(state.status, StripStatus::out_of_reach);
  EXPECT_EQ(state.shortfall, state.gap);
  EXPECT_NEAR(state.gap, 60.0, 1.0);
}

/// Four strips that leave a panel bent to half of a tube.
SlitDesign half_tube() {
  SlitDesign design;
  design.sheet.thickness = 1.0;
  design.sheet.panel_height = 60.0;
  design.sheet.half_length = 150.0;
  design.sheet.symmetric = false;
  design.sheet.strips = equal_strips(4, 30.0);
  design.leg_curve = {{{100, 0}, {160, 0}, {160, 80}, {100, 80}}};
  design.fit = true;
  design.ridges = 3;
  return design;
}

/// Folds a strip where it leaves the panel, and nowhere else.
void lean_over(Snapshot& now, int strip, double fold) {
  Slot slot = now.slot(strip);
  const StripBase base = base_of(now, strip);
  slot.p = flat_parameters(base);
  slot.p[0] = fold;
  slot.box.setEmpty();
  for (const SlitRidge& ridge : folded_strip(base, slot.p).ridges)
    for (const Vec3& end : ridge.folded)
      slot.box.extend(end);
  now.slots[strip] = std::make_shared<const Slot>(std::move(slot));
}

/// Which strips of higher number each strip crosses, each pair looked at.
std::vector<std::vector<int>> all_crossings(const Snapshot& now) {
  std::vector<std::vector<int>> crosses(now.count());
  for (int a = 0; a < now.count(); ++a)
    for (int b = a + 1; b < now.count(); ++b)
      if (now.slot(a).p.size() && now.slot(b).p.size() &&
          cross(folded_of(now, a), folded_of(now, b)))
        crosses[a].push_back(b);
  return crosses;
}

std::vector<std::vector<int>> noted(const Snapshot& now) {
  std::vector<std::vector<int>> crosses;
  for (int strip = 0; strip < now.count(); ++strip)
    crosses.push_back(now.slot(strip).state.crosses);
  return crosses;
}

TEST(NoteCrossings, KnowsThoseOfAllPairsWhicheverStripsMoved) {
  Snapshot now = snapshot_of(half_tube());
  std::size_t most = 0;
  const auto expect_noted = [&](const std::vector<int>& moved) {
    note_crossings(now, moved);
    EXPECT_EQ(noted(now), all_crossings(now));
    for (const auto& crosses : noted(now))
      most = std::max(most, crosses.size());
  };
  for (const double inwards : {1.2, -1.2}) {
    for (int strip = 0; strip < 4; ++strip)
      lean_over(now, strip, inwards);
    expect_noted({0, 1, 2, 3});
    expect_noted({2});
    for (const int strip : {1, 3, 0, 2}) {
      lean_over(now, strip, -0.2 * inwards);
      expect_noted({strip});
    }
    for (const int strip : {3, 0, 2}) {
      lean_over(now, strip, inwards);
      expect_noted({strip});
    }
    lean_over(now, 1, inwards);
    lean_over(now, 2, -inwards);
    expect_noted({2, 1});
  }
  EXPECT_GE(most, 2u) << "some strips cross several others";
}

TEST(NoteCrossings, LeavesOutStripsThatAreNotFoldedYet) {
  Snapshot now = snapshot_of(half_tube());
  lean_over(now, 1, 1.2);
  lean_over(now, 0, 1.2);
  note_crossings(now, {0, 1});
  EXPECT_EQ(noted(now), all_crossings(now));
}

/// The chair's seat leans so much that strips run into each other.
Snapshot crowded() {
  SlitDesign design = chair();
  design.seat_curve = BezierCurve{{{260, -20}, {440, 120}, {280, 240}, {520, 380}}};
  Snapshot now = snapshot_of(design);
  std::vector<int> all;
  for (int strip = 0; strip < now.count(); ++strip) {
    work_on(now, strip, Clear::of_mirror, {});
    all.push_back(strip);
  }
  note_crossings(now, all);
  return now;
}

int neighbours_crossing(const Snapshot& now) {
  int count = 0;
  for (int strip = 0; strip + 1 < now.count(); ++strip)
    count += cross(folded_of(now, strip), folded_of(now, strip + 1));
  return count;
}

TEST(PartNeighbours, LetsOneOfTwoThatCrossGiveWay) {
  Snapshot now = crowded();
  const Snapshot before = now;
  const int crossing = neighbours_crossing(now);
  ASSERT_GT(crossing, 0);
  EXPECT_GT(part_neighbours(now, {0, 1, 2, 3, 4, 5}, {}), 0);
  EXPECT_LT(neighbours_crossing(now), crossing);
  std::vector<bool> concerned(now.count());
  for (int strip = 0; strip + 1 < now.count(); ++strip)
    if (cross(folded_of(before, strip), folded_of(before, strip + 1)))
      concerned[strip] = concerned[strip + 1] = true;
  for (int strip = 0; strip < now.count(); ++strip)
    if (!concerned[strip]) {
      EXPECT_EQ(now.slots[strip], before.slots[strip]) << strip << " crosses none beside it";
    }
}

TEST(PartNeighbours, MovesNoStripThatHasNotMovedAndNoneWhenToldToStop) {
  Snapshot now = crowded();
  const Snapshot before = now;
  EXPECT_EQ(part_neighbours(now, {}, {}), 0);
  EXPECT_EQ(now.slots, before.slots);
  EXPECT_EQ(part_neighbours(now, {0, 1, 2, 3, 4, 5}, {.stop = [] { return true; }}), 0);
  EXPECT_EQ(now.slots, before.slots);
}

}  // namespace
}  // namespace planish::test
