#include <planish/io/mesh_writers.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace planish::test {
namespace {

struct Facet {
  Vec3 normal;
  std::array<Vec3, 3> corners;
  unsigned attribute = 0;
};

/// A reader by the layout of the format: 80 bytes, count, 50 bytes for each facet.
class StlReading {
 public:
  explicit StlReading(const std::string& bytes) : bytes_(bytes) {
    EXPECT_GE(bytes.size(), 84u);
    header = bytes.substr(0, 80);
    at_ = 80;
    count = integer(4);
    EXPECT_EQ(bytes.size(), 84 + 50 * std::size_t{count});
    for (unsigned i = 0; i < count; ++i) {
      Facet facet;
      facet.normal = point();
      for (Vec3& corner : facet.corners)
        corner = point();
      facet.attribute = integer(2);
      facets.push_back(facet);
    }
  }

  std::string header;
  unsigned count = 0;
  std::vector<Facet> facets;

 private:
  unsigned integer(int size) {
    unsigned value = 0;
    for (int i = 0; i < size; ++i)
      value |= static_cast<unsigned>(static_cast<unsigned char>(bytes_.at(at_++))) << (8 * i);
    return value;
  }
  /// IEEE 754 binary32, put together by hand.
  double real() {
    const unsigned bits = integer(4);
    const double sign = bits >> 31 != 0 ? -1.0 : 1.0;
    const int exponent = static_cast<int>(bits >> 23 & 0xFFu);
    const unsigned fraction = bits & 0x7FFFFFu;
    if (exponent == 0) return sign * std::ldexp(fraction, -149);
    return sign * std::ldexp(fraction + 0x800000u, exponent - 150);
  }
  Vec3 point() {
    const double x = real(), y = real(), z = real();
    return {x, y, z};
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

Mesh tetrahedron() {
  return {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 0.1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TEST(StlBinary, HoldsEveryTriangleOfTheMesh) {
  const Mesh mesh = tetrahedron();
  const std::string text = stl_binary(mesh, "tetrahedron");
  const StlReading stl(text);
  ASSERT_EQ(stl.count, 4u);
  for (std::size_t t = 0; t < 4; ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 meant = mesh.points[mesh.triangles[t][i]];
      EXPECT_LT((stl.facets[t].corners[i] - meant).norm(), 1e-7 * 4);
      EXPECT_EQ(stl.facets[t].attribute, 0u);
    }
}

TEST(StlBinary, HasUnitNormalsByTheRightHandRule) {
  const std::string text = stl_binary(tetrahedron(), "");
  const StlReading stl(text);
  EXPECT_LT((stl.facets[0].normal - Vec3(0, 0, -1)).norm(), 1e-7);
  EXPECT_LT((stl.facets[1].normal - Vec3(0, -1, 0)).norm(), 1e-7);
  EXPECT_LT((stl.facets[2].normal - Vec3(-1, 0, 0)).norm(), 1e-7);
  // x/3 + y/4 + z/0.1 = 1
  EXPECT_LT((stl.facets[3].normal - Vec3(1 / 3.0, 1 / 4.0, 10).normalized()).norm(), 1e-6);
}

TEST(StlBinary, IsNotTakenForTheTextKind) {
  for (const std::string& name : {std::string("solid"), std::string(), std::string(200, 'x')}) {
    const std::string text = stl_binary(tetrahedron(), name);
    const StlReading stl(text);
    EXPECT_NE(stl.header.substr(0, 5), "solid");
    EXPECT_EQ(stl.header.size(), 80u);
  }
  const std::string named = stl_binary(tetrahedron(), "bracket 12-A");
  EXPECT_NE(named.substr(0, 80).find("bracket 12-A"), std::string::npos);
}

TEST(StlBinary, LeavesOutTrianglesWithoutArea) {
  Mesh mesh = tetrahedron();
  mesh.points.emplace_back(1.5, 0, 0);       // in the middle of a side
  mesh.points.emplace_back(3 + 1e-9, 0, 0);  // as floats the same as a corner
  mesh.triangles.push_back({0, 4, 1});       // three corners on a line
  mesh.triangles.push_back({0, 0, 1});       // a corner twice
  mesh.triangles.push_back({1, 5, 2});
  const std::string text = stl_binary(mesh, "");
  EXPECT_EQ(StlReading(text).count, 4u);
}

TEST(StlBinary, KeepsNormalsOfTinyTriangles) {
  const double size = 1e-30;
  const Mesh mesh{{{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}};
  const std::string text = stl_binary(mesh, "");
  const StlReading stl(text);
  ASSERT_EQ(stl.count, 1u);
  EXPECT_LT((stl.facets[0].normal - Vec3::UnitZ()).norm(), 1e-7);
}

TEST(StlBinary, OfAnEmptyMeshHasNoFacets) {
  const std::string text = stl_binary({}, "nothing");
  EXPECT_EQ(text.size(), 84u);
  EXPECT_EQ(StlReading(text).count, 0u);
}

}  // namespace
}  // namespace planish::test
