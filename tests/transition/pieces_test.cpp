#include "random_transitions.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Sizes given for either face, pieces and their seams, press lines.

namespace planish::test {
namespace {

TEST(TransitionSizes, AreThoseOfTheFaceTheyAreGivenFor) {
  const double r = 50, t = 4;
  for (const double k : {0.5, 0.4}) {
    TransitionSpec spec = between(EllipseProfile{r, r}, EllipseProfile{r, r}, {0, 0, 80});
    spec.thickness = t;
    spec.k_factor = k;
    for (const auto& [face, share] : {std::pair{SizesAre::inside, 0.0}, std::pair{SizesAre::mid, 0.5}, std::pair{SizesAre::outside, 1.0}}) {
      spec.sizes_are = face;
      const double neutral = r + (k - share) * t;
      expect_sizes(spec, 2 * kPi * neutral * 80, 2 * kPi * neutral, 2 * kPi * neutral);
      EXPECT_NEAR(made(spec).pieces[0].bends[0].inside_radius, neutral - k * t, 1e-9);
    }
  }
}

TEST(TransitionSizes, OfParallelCurvesDifferByTheTurnTimesTheirDistance) {
  TransitionSpec spec = between(EllipseProfile{70, 40}, rectangle(100, 60), {0, 0, 80});
  spec.thickness = 2;
  spec.sizes_are = SizesAre::inside;
  const Transition transition = made(spec);
  EXPECT_NEAR(transition.perimeters[0], ellipse_perimeter(70, 40) + 2 * kPi, 1e-9 * 400);
  EXPECT_NEAR(transition.perimeters[1], 320 + 8, 1e-9 * 400);
}

TEST(TransitionPieces, AddUpAndFitAtTheirSeams) {
  for (unsigned seed = 0; seed < 25; ++seed) {
    std::mt19937 random(seed);
    TransitionSpec spec = random_transition(random);
    spec.from.profile = rectangle(90, 60);
    spec.from.frame = frame_at(Vec3::Zero());
    const auto from = sampled_in_space(spec.from, 1);
    if (std::any_of(from.begin(), from.end(), [&](const Vec3& p) { return spec.to.frame.local(p).z() > -1.0; })) continue;
    const double whole = made(spec).area;
    for (const auto& [pieces, count] : {std::pair{Pieces::one, 1u}, std::pair{Pieces::two, 2u}, std::pair{Pieces::per_side, 4u}}) {
      spec.pieces = pieces;
      const Transition transition = made(spec);
      ASSERT_EQ(transition.pieces.size(), count) << "seed " << seed;
      EXPECT_NEAR(transition.area / whole, 1.0, 1e-9) << "seed " << seed;
      EXPECT_NEAR(flat_area(transition, spec) / whole, 1.0, 1e-9) << "seed " << seed;
      std::vector<std::array<double, 2>> seams;  // lengths at the beginning and the end of pieces
      for (const Sheet& piece : transition.pieces) {
        const BorderLoop &first = piece.faces.front().loops.front(), &last = piece.faces.back().loops.front();
        const bool whole_side = last.size() == 4 || last[0].edge_length > 0.0;
        const auto index = whole_side && lies_on(piece.faces.back(), last[0], spec.from) ? 1u : last.size() == 4 ? 1u : 0u;
        seams.push_back({first.back().edge_length, last[index].edge_length});
      }
      for (std::size_t i = 0; i < seams.size(); ++i)
        EXPECT_NEAR(seams[i][1], seams[(i + 1) % seams.size()][0], 1e-9 * seams[i][1]) << "seed " << seed;
    }
  }
}

TEST(TransitionPressing, TurnsEachPatchAsManyTimesAsTheAngleAsks) {
  TransitionSpec spec = between(rectangle(100, 100), EllipseProfile{30, 30}, {15, -10, 80});
  spec.seam = SeamEdge{0};
  spec.pressing = PressAngle{Angle::degrees(7.0)};
  const Transition transition = made(spec);
  std::size_t bend = 0;
  std::vector<double> turns;
  for (const TransitionPatch& patch : transition.patches)
    if (patch.kind != PatchKind::plane) turns.push_back(patch.turn.radians());
  double turned = 0.0, all = 0.0;
  for (const double turn : turns)
    all += turn;
  for (const Bend& b : transition.pieces[0].bends) {
    double sum = 0.0;
    for (const PressLine& line : b.press_lines)
      sum += line.angle.radians();
    // Of which patch: the one of the same turn.
    const bool known = std::any_of(turns.begin(), turns.end(), [&](double turn) { return std::abs(turn - sum) < 1e-11; });
    EXPECT_TRUE(known) << sum;
    EXPECT_EQ(b.press_lines.size(), static_cast<std::size_t>(std::ceil(sum / Angle::degrees(7.0).radians() - 1e-9)));
    turned += sum;
    ++bend;
  }
  EXPECT_EQ(bend, 4u);
  EXPECT_NEAR(turned, all, 1e-11);
}

}  // namespace
}  // namespace planish::test
