#include "sample_strips.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

// Folding keeps lengths whatever the parameters; derivatives are those of what is computed.

namespace planish::test {
namespace {

RC_GTEST_PROP(StripFold, KeepsSidesAndDiagonalsOfEveryQuad, ()) {
  const int quads = *rc::gen::inRange(3, 60);
  const StripBase base = both_bases(quads)[*rc::gen::inRange(0, 2)];
  const FoldedStrip strip = folded_strip(
      base, random_parameters(base, *rc::gen::arbitrary<unsigned>(), 3.0));
  for (std::size_t i = 0; i + 1 < strip.ridges.size(); ++i) {
    const SlitRidge &near = strip.ridges[i], &far = strip.ridges[i + 1];
    const std::array<Vec2, 4> flat{near.flat[0], far.flat[0], far.flat[1], near.flat[1]};
    const std::array<Vec3, 4> folded{near.folded[0], far.folded[0], far.folded[1], near.folded[1]};
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b)
        RC_ASSERT(std::abs((folded[a] - folded[b]).norm() - (flat[a] - flat[b]).norm()) <=
                  1e-12 * 560.0);
    for (std::size_t a = 0; a < 4; ++a)
      RC_ASSERT((strip.quads[i].point(flat[a]) - folded[a]).norm() <= 1e-11 * 560.0);
  }
}

TEST(StripFold, TurnsEachQuadByItsAngleAboutItsRidge) {
  const StripBase base = some_base(8);
  const StripParameters p = random_parameters(base, 3, 1.2);
  const StripFold fold = folded(base, p);
  for (int i = 0; i < base.quads; ++i) {
    const Vec3 axis = (fold.end(1, i) - fold.end(0, i)).normalized();
    const Frame& before = fold.frames[i];
    EXPECT_NEAR((Eigen::AngleAxisd(p[i], axis) * before.z - fold.quad(i).z).norm(), 0.0, 1e-13);
  }
}

TEST(StripDerivatives, OfRidgeEndsAreDifferences) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const StripBase base = both_bases(7)[seed % 2];
    const StripParameters p = random_parameters(base, seed, 1.0);
    const StripFold fold = folded(base, p);
    const auto all = twists(base, fold);
    for (int ridge = 0; ridge <= base.quads; ++ridge)
      for (int side = 0; side < 2; ++side) {
        const auto expected = differences(
            [&](const StripParameters& x) -> Eigen::VectorXd {
              return folded(base, x).end(side, ridge);
            },
            p);
        EXPECT_LE((end_derivative(base, fold, all, side, ridge) - expected).cwiseAbs().maxCoeff(),
                  1e-6 * base.unit())
            << ridge;
      }
  }
}

}  // namespace
}  // namespace planish::test
