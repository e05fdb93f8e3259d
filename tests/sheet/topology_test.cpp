#include "support/sheets.hpp"

#include <planish/sheet/topology.hpp>

#include <gtest/gtest.h>

#include <set>

namespace planish::test {
namespace {

TEST(Topology, TurnsEveryBorderIntoANumberAndBack) {
  const Sheet sheet = plate_with_holes();
  const Topology topology(sheet);
  std::size_t count = 0;
  for (const BorderId id : topology.borders()) {
    EXPECT_EQ(topology.id_of(topology[id]), id);
    EXPECT_TRUE(sheet.has(topology[id]));
    ++count;
  }
  std::size_t wanted = 0;
  for (const Face& face : sheet.faces)
    for (const BorderLoop& loop : face.loops)
      wanted += loop.size();
  EXPECT_EQ(count, wanted);
}

TEST(Topology, GoesRoundEachLoop) {
  const Sheet sheet = plate_with_holes();
  const Topology topology(sheet);
  for (const BorderId start : topology.borders()) {
    const auto& [face, loop, border] = topology[start];
    BorderId at = start;
    for (std::size_t i = 0; i < sheet[face].loops[loop].size(); ++i)
      at = topology.next(at);
    EXPECT_EQ(at, start);
  }
}

TEST(Topology, TwinsAreEachOthers) {
  const Sheet sheet = u_channel();
  const Topology topology(sheet);
  int joined = 0;
  for (const BorderId id : topology.borders()) {
    const auto twin = topology.twin(id);
    EXPECT_EQ(topology.is_free(id), !twin.has_value());
    if (!twin) continue;
    ++joined;
    EXPECT_EQ(topology.twin(*twin), id);
    EXPECT_EQ(topology.joint(id), topology.joint(*twin));
  }
  EXPECT_EQ(joined, 2 * static_cast<int>(sheet.joints.size()));
}

/// The contours of a whole sheet, by number of free borders.
std::multiset<int> contour_sizes(const Sheet& sheet, int& sharp_steps) {
  const Topology topology(sheet);
  std::set<BorderId> seen;
  std::multiset<int> sizes;
  sharp_steps = 0;
  for (const BorderId start : topology.borders()) {
    if (!topology.is_free(start) || seen.count(start)) continue;
    int size = 0;
    for (BorderId at = start; seen.insert(at).second; ++size) {
      const Topology::Step step = topology.along_contour(at);
      EXPECT_TRUE(topology.is_free(step.border));
      sharp_steps += step.beyond_sharp.empty() ? 0 : 1;
      at = step.border;
    }
    sizes.insert(size);
  }
  return sizes;
}

TEST(Topology, WalksAlongContoursAcrossJoints) {
  int sharp = 0;
  // An L: three borders of each flange and the two ends of the bend.
  EXPECT_EQ(contour_sizes(l_bracket(), sharp), (std::multiset<int>{8}));
  EXPECT_EQ(sharp, 0);
  EXPECT_EQ(
      contour_sizes(strip({Straight{30}, Crease{Angle::degrees(90)}, Straight{20}}, 10, 2), sharp),
      (std::multiset<int>{6}));
  EXPECT_EQ(sharp, 2) << "the crease is crossed at both of its ends";
}

TEST(Topology, CountsFlangesBeforeBends) {
  const Sheet sheet = u_channel();
  const Topology topology(sheet);
  EXPECT_EQ(topology.node_count(), 5);
  for (int node = 0; node < 5; ++node)
    EXPECT_EQ(topology.node_of(node < 3 ? PartId(FlangeId{node}) : PartId(BendId{node - 3})), node);
  for (const FaceId id : sheet.faces.ids())
    EXPECT_EQ(topology.node_of(id), topology.node_of(sheet[id].part_of));
}

TEST(Topology, SeesWhatNoJointLeadsTo) {
  Sheet sheet = u_channel();
  EXPECT_TRUE(Topology(sheet).is_connected());
  sheet.joints.pop_back();
  EXPECT_FALSE(Topology(sheet).is_connected());
}

TEST(TopologyDeathTest, StopsAtABorderThatIsNotThere) {
  const Topology topology(l_bracket());
  EXPECT_DEATH((void)topology.id_of({FaceId{9}, 0, 0}), "has\\(id\\)");
  EXPECT_DEATH((void)topology.id_of({FaceId{0}, 2, 0}), "loop");
  EXPECT_DEATH((void)topology.id_of({FaceId{0}, 0, 7}), "ref");
}

}  // namespace
}  // namespace planish::test
