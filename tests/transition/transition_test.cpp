#include "sample_transitions.hpp"

#include <planish/transition/codes.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace planish::test {
namespace {

/// A frustum of radius 50 below and 20 above, 80 high, its neutral surface as given.
TransitionSpec cone_request() {
  return between(EllipseProfile{50, 50}, EllipseProfile{20, 20}, {0, 0, 80});
}

/// Squares of 100 and 60, 80 high: four trapezia.
TransitionSpec hopper_request() {
  return between(rectangle(100, 100), rectangle(60, 60), {0, 0, 80});
}

const double kConeSlant = std::hypot(80, 30);
const double kHopperSlant = std::hypot(80, 20);

TEST(Transition, MeasuresEachPatchInTheOrderOfTheProfile) {
  const Transition cone = made(cone_request());
  ASSERT_EQ(cone.patches.size(), 1u);
  EXPECT_EQ(cone.patches[0].kind, PatchKind::cone);
  EXPECT_NEAR(cone.patches[0].area, kPi * 70 * kConeSlant, 1e-7);
  EXPECT_NEAR(cone.patches[0].border[0], 2 * kPi * 50, 1e-9);
  EXPECT_NEAR(cone.patches[0].border[1], 2 * kPi * 20, 1e-9);
  EXPECT_NEAR(cone.patches[0].turn.radians(), 2 * kPi * 80 / kConeSlant, 1e-9);
  const Transition hopper = made(hopper_request());
  ASSERT_EQ(hopper.patches.size(), 4u);
  for (const TransitionPatch& patch : hopper.patches) {
    EXPECT_EQ(patch.kind, PatchKind::plane);
    EXPECT_NEAR(patch.area, 80 * kHopperSlant, 1e-9);
    EXPECT_NEAR(patch.border[0], 100, 1e-9);
    EXPECT_NEAR(patch.border[1], 60, 1e-9);
    EXPECT_EQ(patch.turn.radians(), 0.0);
  }
  EXPECT_NEAR(hopper.area, 4 * 80 * kHopperSlant, 1e-8);
  EXPECT_NEAR(hopper.perimeters[0], 400, 1e-9);
  EXPECT_NEAR(hopper.perimeters[1], 240, 1e-9);
}

TEST(Transition, NamesItsTrueLengthsByPieces) {
  TransitionSpec spec = hopper_request();
  spec.pieces = Division::two;
  const Transition transition = made(spec);
  ASSERT_EQ(transition.pieces.size(), 2u);
  std::array<int, 2> folds{};
  int seams = 0;
  const double corner = std::hypot(80, 20 * std::sqrt(2.0));
  for (const TrueLength& length : transition.true_lengths) {
    ASSERT_TRUE(length.piece == 0 || length.piece == 1);
    EXPECT_NEAR(length.length, (length.points[1] - length.points[0]).norm(), 1e-9);
    if (std::abs(length.length - corner) < 1e-9) {
      ++folds[length.piece];
      continue;
    }
    EXPECT_NEAR(length.length, kHopperSlant, 1e-9) << "in the middle of two sides";
    ++seams;
  }
  EXPECT_EQ(folds, (std::array<int, 2>{2, 2}));
  EXPECT_EQ(seams, 2) << "each once";
}

TEST(FoldedPieces, InOnePieceIsOpenAtItsSeamByAHundredthOfAMillimetre) {
  const auto pieces = folded_pieces(cone_request());
  ASSERT_TRUE(pieces) << pieces.error().message;
  ASSERT_EQ(pieces->size(), 1u);
  const auto& [first, last] = pieces->front().seams;
  EXPECT_NEAR((first[0] - last[0]).norm(), 0.01, 1e-6) << "at the wider profile";
  EXPECT_NEAR((first[1] - last[1]).norm(), 0.01 * 20 / 50, 1e-6);
  EXPECT_NEAR((first[0] - first[1]).norm(), kConeSlant, 1e-9);
  EXPECT_NEAR((last[0] - last[1]).norm(), kConeSlant, 1e-9);
  EXPECT_NEAR(pieces->front().cut_area, 0.5 * (0.01 + 0.01 * 20 / 50) * kConeSlant, 1e-6);
}

TEST(FoldedPieces, InTwoPiecesMeetAtTheirSeams) {
  TransitionSpec spec = cone_request();
  spec.pieces = Division::two;
  const auto pieces = folded_pieces(spec);
  ASSERT_TRUE(pieces) << pieces.error().message;
  ASSERT_EQ(pieces->size(), 2u);
  for (const std::size_t i : {0u, 1u}) {
    const auto& end = (*pieces)[i].seams[1];
    const auto& begin = (*pieces)[1 - i].seams[0];
    for (const std::size_t side : {0u, 1u})
      EXPECT_LT((end[side] - begin[side]).norm(), 1e-7);
    EXPECT_EQ((*pieces)[i].cut_area, 0.0) << "no corners, no open seam";
  }
  const Vec3 across = (*pieces)[0].seams[0][0] - (*pieces)[0].seams[1][0];
  EXPECT_NEAR(across.norm(), 100, 1e-7) << "half of the circle";
}

TEST(FoldedPieces, OfARoofKnowTheirRidgeAndNoOthersHaveOne) {
  const auto ridges = [](Profile top) {
    TransitionSpec spec = between(rectangle(400, 240), std::move(top), {10, 20, 150});
    const auto pieces = folded_pieces(spec);
    EXPECT_TRUE(pieces) << pieces.error().message;
    std::vector<std::optional<std::array<Vec3, 2>>> found;
    for (const FoldedPiece& piece : *pieces)
      found.push_back(piece.ridge);
    return found;
  };
  for (const auto& ridge : ridges(PolygonProfile{{{-80, 0}, {80, 0}}})) {
    ASSERT_TRUE(ridge);
    const bool turned = (*ridge)[0].x() > (*ridge)[1].x();
    EXPECT_LT(((*ridge)[turned ? 1 : 0] - Vec3(-70, 20, 150)).norm(), 1e-9);
    EXPECT_LT(((*ridge)[turned ? 0 : 1] - Vec3(90, 20, 150)).norm(), 1e-9);
  }
  for (const Profile& top : {Profile(PolygonProfile{{{0, 0}}}), Profile(rectangle(160, 80)),
                             Profile(EllipseProfile{60, 60}), Profile(regular_polygon(3, 80)),
                             Profile(ObroundProfile{160, 80})})
    for (const auto& ridge : ridges(top))
      EXPECT_FALSE(ridge);
}

TEST(FoldedPieces, LoseWhatIsCutOffTheirCorners) {
  // The area of each piece is that of its neutral surface less what is said to be cut.
  for (const Division division : {Division::one, Division::two, Division::per_side}) {
    TransitionSpec spec = between(rectangle(100, 100), EllipseProfile{30, 30}, {0, 0, 80});
    spec.thickness = 2.0;
    spec.pieces = division;
    const auto pieces = folded_pieces(spec);
    ASSERT_TRUE(pieces) << pieces.error().message;
    double area = 0.0, cut = 0.0;
    for (const FoldedPiece& piece : *pieces) {
      EXPECT_GT(piece.cut_area, 0.0);
      EXPECT_LT(piece.cut_area, 0.1 * made(spec).area);
      cut += piece.cut_area;
      area += laid_flat(piece.sheet, spec).area;
    }
    EXPECT_NEAR(area + cut, made(spec).area, 1e-4 * cut) << static_cast<int>(division);
  }
}

TEST(FoldedPieces, AreRefusedIfTooMuchWouldBeCut) {
  TransitionSpec spec = between(rectangle(100, 100), EllipseProfile{30, 30}, {0, 0, 80});
  ErrorCode refused = code::internal;
  double thickest = 0.0;
  for (double thickness = 1.0; thickness < 60.0 && refused == code::internal; thickness *= 1.5) {
    spec.thickness = thickness;
    const auto pieces = folded_pieces(spec);
    if (!pieces) {
      refused = pieces.error().code;
      continue;
    }
    thickest = thickness;
    for (const FoldedPiece& piece : *pieces)
      EXPECT_LE(piece.cut_area, 0.1 * made(spec).area);
  }
  EXPECT_GT(thickest, 1.0);
  EXPECT_EQ(refused, code::radius_too_small);
}

TEST(Transition, IsRefusedBeyondAKilometre) {
  const auto code_of = [](double size) {
    TransitionSpec spec = between(EllipseProfile{size, size}, EllipseProfile{size, size},
                                  {0, 0, size});
    const auto transition = make_transition(spec, {.mesh_chord = size / 100});
    return transition ? code::internal : transition.error().code;
  };
  EXPECT_EQ(code_of(2e5), code::internal) << "made";
  EXPECT_EQ(code_of(2e6), code::invalid_input);
}

TEST(Transition, IsRefusedWithOptionsThatAreNotPositive) {
  for (const double wrong : {0.0, -1.0, std::nan("")}) {
    EXPECT_EQ(make_transition(cone_request(), {.mesh_chord = wrong}).error().code,
              code::bad_option);
    EXPECT_EQ(make_transition(cone_request(), {.tolerance = wrong}).error().code, code::bad_option);
  }
}

TEST(Transition, EndsWhenItIsToStop) {
  Progress progress;
  progress.cancelled = [] { return true; };
  const auto transition = make_transition(cone_request(), {}, progress);
  ASSERT_FALSE(transition);
  EXPECT_EQ(transition.error().code, code::cancelled);
}

}  // namespace
}  // namespace planish::test
