#include "folded_strips.hpp"

#include "sample_strips.hpp"

// Strips of a system, folded once for all their pairs.

namespace planish::test {
namespace {

TEST(FoldedStrips, AreThoseOfTheSystemAndCrossWhereTheyDo) {
  // Flat ones: the second is the first turned about its middle line and moved along it, so that
  // they go through each other; the third is far away.
  StripSystem system;
  for (int strip = 0; strip < 3; ++strip) {
    StripProblem problem = bare_problem(5);
    const Frame first = problem.base.facet;
    if (strip == 1) {
      problem.base.facet = frame_from_axes(first.origin, -first.y, first.x);
      problem.base.facet.origin += 57.5 * first.y - 57.5 * problem.base.facet.y + 13.0 * first.x;
    }
    if (strip == 2) problem.base.facet.origin += 500.0 * first.y;
    system.strips.push_back(std::move(problem));
    system.held.push_back(false);
  }
  const Shapes shapes(3, flat_parameters(system.strips[0].base));
  const FoldedStrips all = folded_strips(system, shapes);
  ASSERT_EQ(all.strips.size(), 3u);
  for (int strip = 0; strip < 3; ++strip) {
    const FoldedStrip alone = folded_strip(system.strips[strip].base, shapes[strip]);
    for (std::size_t ridge = 0; ridge < 6; ++ridge) {
      EXPECT_EQ(all.strips[strip].ridges[ridge].folded, alone.ridges[ridge].folded);
      for (const Vec3& end : alone.ridges[ridge].folded)
        EXPECT_LT(all.boxes[strip].exteriorDistance(end), 1e-9);
    }
  }
  EXPECT_TRUE(all.cross(0, 1));
  EXPECT_FALSE(all.cross(0, 2));
  EXPECT_FALSE(all.cross(1, 2));
}

}  // namespace
}  // namespace planish::test
