#include "folded_strips.hpp"

#include "sample_strips.hpp"

// Strips of a system, folded once for all their pairs.

namespace planish::test {
namespace {

TEST(FoldedStrips, AreThoseOfTheSystemAndCrossWhereTheyDo) {
  StripSystem system;
  Shapes shapes;
  for (const double across : {0.0, 30.0, 500.0}) {
    StripProblem problem = bare_problem(5);
    problem.base.facet.origin += across * problem.base.facet.y;
    shapes.push_back(random_parameters(problem.base, 3, 0.4));
    shapes.back()[0] += across == 30.0 ? 0.5 : 0.0;  // leans through the first
    system.strips.push_back(std::move(problem));
    system.held.push_back(false);
  }
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
