#include <planish/io/mesh_writers.hpp>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(ObjText, CountsCornersFromOne) {
  const Mesh mesh{{{0, 0, 0}, {1.5, 0, 0}, {0, -2.25, 1e-3}}, {{0, 1, 2}, {2, 1, 0}}};
  EXPECT_EQ(obj_text(mesh, "part"),
            "o part\nv 0 0 0\nv 1.5 0 0\nv 0 -2.25 0.001\nf 1 2 3\nf 3 2 1\n");
}

TEST(ObjText, KeepsItsNameOnOneLine) {
  EXPECT_EQ(obj_text({}, " \tdoor\nf 1 2 3"), "o door f 1 2 3\n");
  EXPECT_EQ(obj_text({}, ""), "o \n");
}

TEST(ObjText, HasTenDigits) {
  const Mesh mesh{{{1.0 / 3.0, 2e6 / 3.0, 0}}, {}};
  EXPECT_EQ(obj_text(mesh, "p"), "o p\nv 0.3333333333 666666.6667 0\n");
}

TEST(ObjText, StopsAtCornersThatTheMeshDoesNotHave) {
  for (const int corner : {-1, 3, 99}) {
    const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, corner}}};
    EXPECT_DEATH((void)obj_text(mesh, "p"), "is_corner");
  }
}

}  // namespace
}  // namespace planish
