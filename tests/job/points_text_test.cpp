#include <planish/job/slit_json.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdio>

namespace planish::job {
namespace {

std::vector<Vec3> points_in(const std::string& text, double scale = 1.0) {
  const auto points = parse_points(text, "scan.xyz", scale);
  EXPECT_TRUE(points) << points.error().where;
  return points.value_or(std::vector<Vec3>{});
}

const std::vector<Vec3> kTwo{{1, -2.5, 3}, {4, 5, 600}};

TEST(PointsText, TakesWhateverPartsNumbers) {
  for (const char* text :
       {"1 -2.5 3\n4 5 600\n", "1,-2.5,3\n4,5,6e2", "1;-2.5;3\r\n4;5;600\r\n",
        "\t1\t-2.5\t3\n\t4\t5\t600\n", "1, -2.5 ;3\n4,\t5, 600\n", "+1 -2.5 +3\n4 +5 600\n",
        "\xEF\xBB\xBF"
        "1 -2.5 3\n4 5 600"})
    EXPECT_EQ(points_in(text), kTwo) << text;
}

TEST(PointsText, TakesDecimalCommasWhereSomethingElsePartsNumbers) {
  EXPECT_EQ(points_in("1,0 -2,5 3,0\n4,0\t5,0\t600,0\n"), kTwo);
  EXPECT_EQ(points_in("1,0;-2,5;3,0\n4,0;5,0;600,0"), kTwo);
  // Commas that stand in other ways part numbers.
  EXPECT_EQ(points_in("1,2,3 4,5 6,7"), (std::vector<Vec3>{{1, 2, 3}}));
  EXPECT_EQ(points_in("1, 2, 3"), (std::vector<Vec3>{{1, 2, 3}}));
  EXPECT_EQ(points_in("1,2 3 4"), (std::vector<Vec3>{{1, 2, 3}}));
  EXPECT_EQ(points_in("1,2 3,4"), (std::vector<Vec3>{{1, 2, 3}}));
  EXPECT_EQ(points_in("1,2 3,4 5,"), (std::vector<Vec3>{{1, 2, 3}}));
  EXPECT_EQ(points_in("1,2 3,4 ,5"), (std::vector<Vec3>{{1, 2, 3}}));
  EXPECT_EQ(points_in("1,2 3,4 5,-6"), (std::vector<Vec3>{{1, 2, 3}}));
}

TEST(PointsText, SkipsCommentsEmptyLinesAndFurtherNumbers) {
  EXPECT_EQ(points_in("# x y z\n\n1 -2.5 3 # first\n \t\r\n4 5 600 0.1 0.2 0.3 red\n#\n"), kTwo);
  EXPECT_TRUE(points_in("").empty());
  EXPECT_TRUE(points_in(" ; ,\n").empty());
}

TEST(PointsText, IsScaledToMillimetres) {
  EXPECT_EQ(points_in("1 0 -2\n", 25.4), (std::vector<Vec3>{{25.4, 0, -50.8}}));
}

TEST(PointsText, NamesTheLineThatHoldsNoPoint) {
  for (const char* line : {"1 2", "1 2 x", "x 2 3", "1 y 3", "1 2 nan", "1 inf 3", "1 2 3x",
                           "1 2x 3", "1 2 1e999", "++1 2 3"}) {
    const auto points = parse_points("# head\n1 2 3\n" + std::string(line) + "\n1 2 3\n",
                                     "scan.xyz", 1.0);
    ASSERT_FALSE(points) << line;
    EXPECT_EQ(points.error().code, code::invalid_input);
    EXPECT_EQ(points.error().where, "scan.xyz:3") << line;
  }
}

RC_GTEST_PROP(PointsText, GivesBackWhatWasWritten, (const std::vector<int>& numbers)) {
  std::vector<Vec3> written;
  std::string text;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    written.push_back(Vec3(numbers[i], numbers[i + 1], numbers[i + 2]) / 64.0);
    char line[100];
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", written.back().x(), written.back().y(),
                  written.back().z());
    text += line;
  }
  const auto read = parse_points(text, "scan.xyz", 1.0);
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == written);
}

}  // namespace
}  // namespace planish::job
