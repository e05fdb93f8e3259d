#include "sample_sheets.hpp"

#include <planish/slit/codes.hpp>

#include <algorithm>
#include <cmath>

namespace planish::test {
namespace {

double largest_difference(const FoldedSlitSheet& a, const FoldedSlitSheet& b) {
  double worst = 0.0;
  for (std::size_t s = 0; s < a.strips.size(); ++s)
    for (std::size_t r = 0; r < a.strips[s].ridges.size(); ++r)
      for (std::size_t side = 0; side < 2; ++side)
        worst = std::max(
            worst,
            (a.strips[s].ridges[r].folded[side] - b.strips[s].ridges[r].folded[side]).norm());
  return worst;
}

/// Sides and diagonals of all quads against the flat sheet, measured on corners alone.
double isometry_error(const FoldedSlitSheet& folded) {
  double worst = 0.0;
  for (const FoldedStrip& strip : folded.strips)
    for (std::size_t i = 0; i + 1 < strip.ridges.size(); ++i) {
      const SlitRidge &a = strip.ridges[i], &b = strip.ridges[i + 1];
      const auto off = [&](const Vec2& p, const Vec2& q, const Vec3& x, const Vec3& y) {
        worst = std::max(worst, std::abs((p - q).norm() - (x - y).norm()));
      };
      for (std::size_t s = 0; s < 2; ++s)
        for (std::size_t t = 0; t < 2; ++t)
          off(a.flat[s], b.flat[t], a.folded[s], b.folded[t]);
      off(a.flat[0], a.flat[1], a.folded[0], a.folded[1]);
    }
  return worst;
}

TEST(SlitSession, ChairMeetsItsSymmetryPlaneSmoothly) {
  const SlitSession session = solved(chair(), 2);
  const auto folded = session.folded();
  EXPECT_EQ(session.design().ridges, 40);
  for (int strip = 0; strip < session.strip_count(); ++strip) {
    const StripState& state = session.state(strip);
    EXPECT_EQ(state.status, StripStatus::solved) << strip;
    EXPECT_LE(state.gap, 1e-9 * 884) << strip;
    EXPECT_FALSE(!state.crosses.empty() || state.crosses_plane || state.too_tight) << strip;
    EXPECT_LE(state.seat_distance, 0.005 * 464) << strip;
    const FoldedStrip& shape = folded.strips[strip];
    for (const Vec3& end : shape.ridges.back().folded)
      EXPECT_LE(std::abs(end.x()), 1e-9 * 884);
    // The end term of the paper [slits 3], and the right angle.
    for (std::size_t side = 0; side < 2; ++side)
      EXPECT_NEAR(shape.ridges[39].folded[side].y(), shape.ridges[40].folded[side].y(), 1e-9 * 884);
    EXPECT_NEAR(shape.quads.back().z.x(), 0.0, 1e-11);
  }
  EXPECT_LE(isometry_error(folded), 1e-12 * 884);
}

TEST(SlitSession, EndsOnTheSeatCurveWhereItWeighsMuch) {
  SlitDesign design = chair();
  design.weights.seat = 3.0;
  const SlitSession session = solved(design);
  for (int strip = 0; strip < session.strip_count(); ++strip)
    EXPECT_LE(session.state(strip).seat_distance, 0.1) << strip;
}

TEST(SlitSession, AsymmetricEndsAreWhereTheyMustBe) {
  const SlitDesign design = asymmetric();
  const SlitSession session = solved(design, 1);
  const auto folded = session.folded();
  EXPECT_LE(isometry_error(folded), 1e-12 * 600);
  for (int strip = 0; strip < session.strip_count(); ++strip) {
    EXPECT_EQ(session.state(strip).status, StripStatus::solved) << strip;
    const FoldedStrip& shape = folded.strips[strip];
    const StripEnd& end = session.design().ends[strip];
    const Vec3 middle = 0.5 * (shape.ridges.back().folded[0] + shape.ridges.back().folded[1]);
    if (end.position) {
      EXPECT_NEAR((middle - *end.position).norm(), 0.0, 1e-9 * 560) << strip;
    }
    if (end.direction) {
      EXPECT_NEAR((shape.quads.back().x - end.direction->normalized()).norm(), 0.0, 1e-11) << strip;
    }
  }
}

TEST(SlitSession, MirroredInputGivesTheMirroredForm) {
  SlitDesign mirrored = chair();
  for (Vec2& pole : mirrored.leg_curve.poles)
    pole.x() = -pole.x();
  const auto a = solved(chair(), 1).folded(), b = solved(mirrored, 1).folded();
  for (std::size_t s = 0; s < a.strips.size(); ++s)
    for (std::size_t r = 0; r < a.strips[s].ridges.size(); ++r)
      for (std::size_t side = 0; side < 2; ++side) {
        const Vec3 p = a.strips[s].ridges[r].folded[side], q = b.strips[s].ridges[r].folded[side];
        EXPECT_NEAR((Vec3(-p.x(), p.y(), p.z()) - q).norm(), 0.0, 1e-4);
      }
}

TEST(SlitSession, MirroredCurvesGiveTheMirroredForm) {
  // The seat curve leans to one side, so that strips run into each other on one side only.
  for (const double lean : {300.0, 420.0, 260.0}) {
    SlitDesign design = chair();
    design.seat_curve = BezierCurve{{{lean, -20}, {700 - lean, 120}, {280, 240}, {520, 380}}};
    SlitDesign mirrored = design;
    for (BezierCurve* curve : {&mirrored.leg_curve, &*mirrored.seat_curve}) {
      std::ranges::reverse(curve->poles);
      for (Vec2& pole : curve->poles)
        pole.y() = 360 - pole.y();
    }
    const auto a = solved(design).folded(), b = solved(mirrored).folded();
    for (std::size_t strip = 0; strip < a.strips.size(); ++strip)
      for (std::size_t ridge = 0; ridge < a.strips[strip].ridges.size(); ++ridge)
        for (std::size_t side = 0; side < 2; ++side) {
          const Vec3& p = a.strips[strip].ridges[ridge].folded[side];
          const Vec3& q = b.strips[a.strips.size() - 1 - strip].ridges[ridge].folded[1 - side];
          EXPECT_LT((Vec3(p.x(), p.y(), 360 - p.z()) - q).norm(), 0.5)
              << lean << " strip " << strip << " ridge " << ridge;
        }
  }
}

/// Of arcs on the halves of both quads, at all ridges but that on the panel: smoothness weighs the
/// fold there as any other, though only half a quad is bent with it.
double tightest_beyond_panel(const FoldedStrip& strip) {
  double radius = 1e300;
  for (std::size_t ridge = 1; ridge < strip.quads.size(); ++ridge) {
    const auto& [flat, folded, fold] = strip.ridges[ridge];
    const double sine = (flat[1].y() - flat[0].y()) / (flat[1] - flat[0]).norm();
    for (const std::size_t side : {0u, 1u}) {
      const double halves = 0.5 * (strip.ridges[ridge + 1].flat[side].x() -
                                   strip.ridges[ridge - 1].flat[side].x());
      radius = std::min(radius, 0.5 * halves * sine / std::tan(0.5 * std::abs(fold.radians())));
    }
  }
  return radius;
}

TEST(SlitSession, FineQuadsKeepTheFormOfCoarseOnes) {
  SlitDesign design = chair();
  design.objective = SlitObjective::smooth;
  const SlitSession coarse = solved(design, 1), fine = solved(design, 4);
  ASSERT_EQ(fine.design().ridges, 160);
  const FoldedSlitSheet fine_shape = fine.folded(), coarse_shape = coarse.folded();
  for (int strip = 0; strip < fine.strip_count(); ++strip) {
    EXPECT_EQ(fine.state(strip).status, StripStatus::solved) << strip;
    EXPECT_GT(tightest_beyond_panel(fine_shape.strips[strip]),
              0.7 * tightest_beyond_panel(coarse_shape.strips[strip]))
        << strip;
    EXPECT_LT(fine.state(strip).seat_distance, coarse.state(strip).seat_distance + 1.0) << strip;
  }
}

TEST(SlitSession, FineQuadsHaveTheEnergyOfCoarseOnes) {
  const SlitSession coarse = solved(chair(), 2), fine = solved(chair(), 3);
  for (int strip = 0; strip < fine.strip_count(); ++strip) {
    EXPECT_EQ(fine.state(strip).status, StripStatus::solved) << strip;
    const double objective = coarse.state(strip).objective;
    EXPECT_NEAR(fine.state(strip).objective, objective, 0.05 * objective) << strip;
    EXPECT_LT(fine.state(strip).seat_distance, coarse.state(strip).seat_distance + 1.0) << strip;
  }
}

TEST(SlitSession, IsNotBentTighterForARadiusItCannotKeep) {
  SlitDesign design = chair();
  design.objective = SlitObjective::smooth;
  const SlitSession free = solved(design);
  for (const double radius : {80.0, 300.0, 1000.0}) {
    design.sheet.min_inside_radius = radius;
    const SlitSession held = solved(design);
    for (int strip = 0; strip < held.strip_count(); ++strip) {
      EXPECT_GE(held.state(strip).min_radius,
                0.999 * std::min(free.state(strip).min_radius, radius))
          << radius << " strip " << strip;
      EXPECT_EQ(held.state(strip).too_tight,
                held.state(strip).min_radius < design.sheet.min_radius())
          << radius << " strip " << strip;
    }
  }
}

TEST(SlitSession, TakesADesignByWhatDiffers) {
  SlitDesign design = chair();
  SlitSession session = solved(design, 1);
  design.anchors.push_back({2, 5, StripEdge::left, {180, 330, 150}});
  ASSERT_TRUE(session.set_design(design));
  EXPECT_EQ(session.design().anchors.at(0).ridge, 10);  // as subdivided
  auto report = session.solve();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->strips_solved, 1);
  for (int again = 0; again < 10 && !session.solve()->converged; ++again) {
  }
  ASSERT_TRUE(session.set_design(design));
  report = session.solve();
  EXPECT_EQ(report->strips_solved, 0);
  design.weights.smooth *= 2;
  ASSERT_TRUE(session.set_design(design));
  EXPECT_EQ(session.solve()->strips_solved, 6);
  design.weights = chair().weights;
  ASSERT_TRUE(session.set_design(design));
  EXPECT_EQ(session.design().weights, chair().weights);
  design.anchors[0].strip = 9;
  EXPECT_EQ(session.set_design(design).error().code, code::unknown_strip);
  design.anchors.clear();
  design.sheet.thickness = 2.0;
  ASSERT_TRUE(session.set_design(design));
  EXPECT_EQ(session.design().ridges, 20);
  EXPECT_EQ(session.solve()->strips_solved, 6);
}

TEST(SlitSession, TenTimesTheSizeGivesTenTimesTheForm) {
  SlitDesign large = chair();
  large.sheet.thickness *= 10, large.sheet.panel_height *= 10, large.sheet.half_length *= 10;
  for (SlitStrip& strip : large.sheet.strips)
    strip.width *= 10;
  for (Vec2& pole : large.leg_curve.poles)
    pole *= 10;
  for (Vec2& pole : large.seat_curve->poles)
    pole *= 10;
  const auto a = solved(chair()).folded(), b = solved(large).folded();
  for (std::size_t s = 0; s < 3; ++s)
    for (std::size_t r = 0; r < a.strips[s].ridges.size(); ++r)
      EXPECT_NEAR((10.0 * a.strips[s].ridges[r].folded[0] - b.strips[s].ridges[r].folded[0]).norm(),
                  0.0, 1e-2);
}

TEST(SlitSession, SubdivisionLeavesTheShape) {
  SlitSession session = solved(chair());
  const auto coarse = session.folded();
  session.subdivide();
  session.subdivide();
  const auto fine = session.folded();
  for (std::size_t s = 0; s < coarse.strips.size(); ++s) {
    ASSERT_EQ(fine.strips[s].ridges.size(), 41u);
    for (std::size_t r = 0; r < coarse.strips[s].ridges.size(); ++r) {
      EXPECT_NEAR(fine.strips[s].ridges[4 * r].fold.radians(),
                  coarse.strips[s].ridges[r].fold.radians(), 1e-15);
      for (std::size_t side = 0; side < 2; ++side)
        EXPECT_NEAR(
            (fine.strips[s].ridges[4 * r].folded[side] - coarse.strips[s].ridges[r].folded[side])
                .norm(),
            0.0, 1e-11);
    }
    for (std::size_t r = 0; r < 40; ++r)
      EXPECT_TRUE(r % 4 == 0 || fine.strips[s].ridges[r].fold.radians() == 0.0);
  }
}

TEST(SlitSession, SolvesOnlyTheStripsThatAnEditTouches) {
  SlitSession session = solved(chair());
  const auto before = session.folded();
  const Vec3 at = before.strips[2].ridges[5].folded[0] + Vec3(0, 8, 0);
  SlitDesign design = session.design();
  design.anchors = {{2, 5, StripEdge::left, at}};
  ASSERT_TRUE(session.set_design(design));
  EXPECT_EQ(session.state(2).status, StripStatus::open);
  const auto report = session.solve();
  ASSERT_TRUE(report);
  EXPECT_EQ(report->strips_solved, 1);
  EXPECT_TRUE(report->converged);
  const auto after = session.folded();
  for (std::size_t s : {0u, 1u, 3u, 4u, 5u})
    for (std::size_t r = 0; r < 11; ++r)
      EXPECT_EQ(before.strips[s].ridges[r].folded[0], after.strips[s].ridges[r].folded[0]);
  EXPECT_LT(session.state(2).anchor_distance, 8.0);
  EXPECT_EQ(session.solve()->strips_solved, 0);
}

TEST(SlitSession, ComesNearerToAnAnchorTheHeavierItWeighs) {
  double before = 20.0;
  for (const double weight : {0.001, 0.03, 3.0}) {
    SlitDesign design = chair();
    const Vec3 at = solved(design).folded().strips[0].ridges[5].folded[0] + Vec3(0, 20, 0);
    design.weights.anchors = weight;
    design.anchors = {{0, 5, StripEdge::left, at}};
    const double distance = solved(design).state(0).anchor_distance;
    EXPECT_LT(distance, before);
    before = distance;
  }
  EXPECT_LT(before, 0.5);
}

TEST(SlitSession, LeavesTheShapeUntilItIsSolved) {
  SlitSession session = solved(chair());
  const auto before = session.folded();
  SlitDesign design = session.design();
  design.anchors = {
      {1, 5, StripEdge::right, before.strips[1].ridges[5].folded[1] + Vec3(0, 15, 0)}};
  ASSERT_TRUE(session.set_design(design));
  EXPECT_EQ(largest_difference(before, session.folded()), 0.0);
  ASSERT_TRUE(session.solve());
  EXPECT_GT(largest_difference(before, session.folded()), 1.0);
}

TEST(SlitSession, KeepsEverythingWhereADesignIsRefused) {
  SlitSession session = solved(chair());
  const auto before = session.folded();
  SlitDesign design = session.design();
  design.weights.smooth *= 2;
  design.anchors = {{9, 5, StripEdge::right, Vec3::Zero()}};
  EXPECT_EQ(session.set_design(design).error().code, code::unknown_strip);
  EXPECT_EQ(session.design().weights, chair().weights);
  EXPECT_TRUE(session.design().anchors.empty());
  EXPECT_EQ(largest_difference(before, session.folded()), 0.0);
  EXPECT_EQ(session.solve()->strips_solved, 0);
}

TEST(SlitSession, GoesOnWhereABudgetStoppedIt) {
  SlitSession session = started(chair());
  ASSERT_TRUE(session.solve({.max_iterations = 4}));
  int calls = 1;
  for (; calls < 100; ++calls)
    if (session.solve({.max_iterations = 5})->converged) break;
  EXPECT_GT(calls, 1);
  EXPECT_LT(calls, 100);
  for (int strip = 0; strip < 6; ++strip)
    EXPECT_LE(session.state(strip).gap, 1e-9 * 884);
}

TEST(SlitSession, CanBeCancelledAtEachPoll) {
  for (const SlitObjective objective : {SlitObjective::energy, SlitObjective::smooth}) {
    SlitDesign design = chair();
    design.objective = objective;
    for (int last = 0; last < 40; last += 3) {
      SlitSession session = started(design);
      int polls = 0;
      Progress progress;
      progress.cancelled = [&] { return polls++ >= last; };
      const auto cancelled = session.solve({}, progress);
      ASSERT_FALSE(cancelled) << last;
      EXPECT_EQ(cancelled.error().code, code::cancelled);
      EXPECT_TRUE(session.solve()) << "it goes on from there, " << last;
    }
  }
}

TEST(SlitSession, StopsWithoutTimeAndWhenCancelled) {
  SlitSession session = started(chair());
  const auto report = session.solve({.seconds = 0.0});
  ASSERT_TRUE(report);
  EXPECT_FALSE(report->converged);
  EXPECT_EQ(report->strips_solved, 0);
  for (int strip = 0; strip < session.strip_count(); ++strip) {
    EXPECT_EQ(session.state(strip).status, StripStatus::open);
    EXPECT_LE(session.state(strip).gap, 1e-9 * 884) << "it has a shape to be shown, " << strip;
  }
  Progress progress;
  int polls = 0;
  progress.cancelled = [&] { return ++polls > 10; };
  const auto cancelled = session.solve({}, progress);
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().code, code::cancelled);
  EXPECT_TRUE(session.solve()->converged);
}

TEST(SlitSession, KeepsTheLeastRadiusAsAConstraint) {
  SlitDesign design = chair();
  design.sheet.strips = equal_strips(1, 60.0);
  design.leg_curve = {{{360, 0}, {360, 60}}};
  design.seat_curve = BezierCurve{{{330, 0}, {330, 60}}};
  const double free = solved(design).state(0).min_radius;
  design.sheet.min_inside_radius = 1.25 * free;
  const SlitSession session = solved(design);
  EXPECT_FALSE(session.state(0).too_tight);
  EXPECT_GE(session.state(0).min_radius, (1.25 * free + 2.0) * (1 - 1e-6));
  EXPECT_LE(session.state(0).gap, 1e-9 * 884);
  // No strip of 464 mm gets from upright to level and down again with a radius of half a metre.
  design.sheet.min_inside_radius = 500.0;
  EXPECT_TRUE(solved(design).state(0).too_tight);
}

TEST(SlitSession, LevelEndsAreLevelAndMayFold) {
  SlitDesign design = chair();
  design.end_angle = EndAngle::level;
  const SlitSession session = solved(design);
  const auto folded = session.folded();
  for (const FoldedStrip& strip : folded.strips)
    EXPECT_NEAR(strip.quads.back().x.y(), 0.0, 1e-11);
}

TEST(SlitScan, OfAKnownChairIsFollowed) {
  // A chair bent by an anchor, its ridge ends moved at random by up to half a millimetre: what a
  // scanner would see.
  SlitDesign known = chair();
  known.anchors = {{1, 5, StripEdge::left,
                    solved(chair()).folded().strips[1].ridges[5].folded[0] + Vec3(0, 25, 0)}};
  known.weights.anchors = 1.0;
  const auto shape = solved(known, 1).folded();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  SlitDesign design = chair();
  design.weights.scan = 1.0;
  SlitScan scan{1, {}};
  for (std::size_t r = 0; r + 1 < shape.strips[1].ridges.size(); ++r)
    for (int i = 0; i < 20; ++i)
      for (int j = 0; j <= 20; ++j) {
        const auto on = [&](const SlitRidge& ridge) -> Vec3 {
          return ridge.folded[0] + j / 20.0 * (ridge.folded[1] - ridge.folded[0]);
        };
        const Vec3 noise(unit(random), unit(random), unit(random));
        scan.points.push_back(
            on(shape.strips[1].ridges[r]) +
            i / 20.0 * (on(shape.strips[1].ridges[r + 1]) - on(shape.strips[1].ridges[r])) + noise);
      }
  const SlitSession blind = solved(chair(), 1);
  design.scans = {scan};
  const SlitSession session = solved(design, 1);
  const auto distance = [&](const FoldedSlitSheet& folded) {
    double worst = 0.0;
    for (std::size_t r = 0; r < 21; ++r)
      for (std::size_t side = 0; side < 2; ++side) {
        double least = 1e9;
        for (const Vec3& p : scan.points)
          least = std::min(least, (p - folded.strips[1].ridges[r].folded[side]).norm());
        worst = std::max(worst, least);
      }
    return worst;
  };
  EXPECT_GT(distance(blind.folded()), 10.0);
  EXPECT_LT(distance(session.folded()), 3.0);
  EXPECT_LT(session.state(1).scan_distance, 0.5);
  // What was scanned, without its noise, is met within the noise and what facets of 22 mm leave an
  // arc of 75 mm by.
  const FoldedStrip found = session.folded().strips[1];
  for (std::size_t r = 0; r < 21; ++r)
    for (const Vec3& p : shape.strips[1].ridges[r].folded) {
      double least = 1e9;
      for (std::size_t quad = 0; quad < found.quads.size(); ++quad) {
        const Vec3 local = found.quads[quad].local(p);
        const double from = found.ridges[quad].flat[0].x(), to = found.ridges[quad + 1].flat[0].x();
        if (local.x() > from - 60 && local.x() < to + 60)
          least = std::min(least, std::abs(local.z()));
      }
      EXPECT_LT(least, 0.5 + 22.0 * 22.0 / (8.0 * 75.0)) << r;
    }
}

TEST(SlitScan, IsAlignedByARigidMotion) {
  SlitSession session = solved(chair(), 1);
  const auto shape = session.folded();
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(0.03, Vec3(1, 2, 3).normalized()));
  motion.pretranslate(Vec3(4, -6, 5));
  SlitDesign design = session.design();
  for (int strip = 0; strip < 6; ++strip) {
    SlitScan& scan = design.scans.emplace_back(SlitScan{strip, {}});
    for (const SlitRidge& ridge : shape.strips[strip].ridges)
      for (const Vec3& end : ridge.folded)
        scan.points.push_back(motion * end);
  }
  ASSERT_TRUE(session.set_design(design));
  const auto found = session.align_scans();
  ASSERT_TRUE(found) << found.error().message;
  // Moved by 9 mm and 1.7°; the surface is known at points up to 7.5 mm apart, and 252 pairs level
  // that out.
  EXPECT_NEAR((*found * motion).translation().norm(), 0.0, 1.0);
  EXPECT_NEAR(Eigen::AngleAxisd((*found * motion).linear()).angle(), 0.0, 0.002);
  for (int strip = 0; strip < 6; ++strip)
    for (std::size_t i = 0; i < session.scan(strip).size(); ++i)
      EXPECT_NEAR((session.scan(strip)[i] - shape.strips[strip].ridges[i / 2].folded[i % 2]).norm(),
                  0.0, 1.0);
}

TEST(SolvedSlitSheet, RefusesSubdivisionsOutsideTheirRange) {
  for (const int subdivisions : {-1, kMostSubdivisions + 1, 1000000}) {
    const auto result = solved_slit_sheet(chair(), subdivisions);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, code::bad_option);
  }
}

}  // namespace
}  // namespace planish::test
