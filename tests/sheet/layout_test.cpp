#include "support/sheets.hpp"

#include <planish/base/union_find.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/topology.hpp>

#include <gtest/gtest.h>

namespace planish::test {
namespace {

const std::vector<Sheet>& sample_sheets() {
  static const std::vector<Sheet> sheets{
      l_bracket(), l_bracket_down(),   u_channel(),      hem(), box(), cone_joined(), staircase(6),
      rolled(),    plate_with_holes(), lofted_corner({})};
  return sheets;
}

FlatSheet flat_of(const Sheet& sheet, const FlattenOptions& options = {}) {
  auto flat = flat_sheet(sheet, options);
  EXPECT_TRUE(flat) << (flat ? "" : flat.error().message);
  return std::move(*flat);
}

TEST(Layout, HoldsTogetherByASpanningTree) {
  for (const Sheet& sheet : sample_sheets()) {
    const Layout layout = flat_of(sheet).layout;
    const Topology topology(sheet);
    UnionFind nodes(topology.node_count());
    for (const int joint : layout.tree)
      EXPECT_TRUE(nodes.unite(topology.node_of(sheet.joints[joint].a.face),
                              topology.node_of(sheet.joints[joint].b.face)))
          << "a joint closes a cycle";
    EXPECT_EQ(nodes.count(), 1);
  }
}

TEST(Layout, FoldsBackWhatItDevelops) {
  for (const Sheet& sheet : sample_sheets())
    for (const UpSide up : {UpSide::reference, UpSide::other}) {
      const Layout layout = flat_of(sheet, {.up = up}).layout;
      for (const FaceId id : sheet.faces.ids())
        for (const Border& border : sheet[id].loops.front())
          for (const double t : {0.0, 0.4, 0.9}) {
            const Vec2 uv = point_at(border.curve, t);
            const Vec2 p = layout.develop(sheet, id, uv);
            EXPECT_LT((layout.fold(sheet, id, p) - uv).norm(), 1e-8);
          }
    }
}

TEST(Layout, ImagesOfJoinedBordersAreOne) {
  for (const Sheet& sheet : sample_sheets()) {
    const Layout layout = flat_of(sheet).layout;
    for (const Joint& joint : sheet.joints) {
      EXPECT_LT((start_of(layout.image(joint.a)) - end_of(layout.image(joint.b))).norm(), 1e-6);
      EXPECT_LT((end_of(layout.image(joint.a)) - start_of(layout.image(joint.b))).norm(), 1e-6);
    }
  }
}

TEST(Layout, LiesWhereThePatternSays) {
  for (const Sheet& sheet : sample_sheets()) {
    const auto [layout, pattern] = flat_of(sheet);
    EXPECT_EQ(pattern.root, layout.root);
    EXPECT_EQ(pattern.root_placement.matrix(), layout.placement[layout.root].matrix());
    Box2 box;
    double area = 0.0;
    for (const FaceId id : sheet.faces.ids()) {
      box.add(bounds(layout.outline(id)));
      for (const Loop& loop : layout.images[id])
        area += signed_area(loop);
    }
    EXPECT_NEAR(std::abs(area), pattern.area, 1e-6 * pattern.area);
    EXPECT_LT((box.lo - bounds(pattern.outer.loop).lo).norm(), 1e-6);
    EXPECT_LT((box.hi - bounds(pattern.outer.loop).hi).norm(), 1e-6);
  }
}

TEST(Layout, TakesTheRootsCoordinates) {
  const Sheet sheet = u_channel();
  for (const FaceId root : sheet.faces.ids()) {
    const auto layout = lay_out(sheet, {.root = root});
    ASSERT_TRUE(layout);
    EXPECT_EQ(layout->root, root);
    if (sheet[root].sense > 0) {
      EXPECT_TRUE(layout->placement[root].matrix().isIdentity());
    }
  }
}

}  // namespace
}  // namespace planish::test
