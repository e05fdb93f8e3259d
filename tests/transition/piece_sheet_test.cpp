#include "piece_sheet.hpp"

#include "sample_rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace planish::test {
namespace {

using namespace transition_detail;

TransitionSpec two_millimetres() {
  TransitionSpec spec;
  spec.thickness = 2.0;
  spec.k_factor = 0.4;
  return spec;
}

Sheet named(const Ring& ring, RulingNames& names, const TransitionSpec& spec = two_millimetres()) {
  auto sheet = named_sheet(ring, spec, whole(ring), 0, names);
  EXPECT_TRUE(sheet) << (sheet ? "" : sheet.error().message);
  return sheet ? std::move(*sheet) : Sheet{};
}

TEST(NamedSheet, FoldsPlanesSharplyWhereTheyMeet) {
  const Ring ring = pyramid();
  RulingNames names(*ring.hull, 1e-6);
  const Sheet sheet = named(ring, names);
  EXPECT_TRUE(check(sheet));
  EXPECT_EQ(sheet.flanges.size(), 4u);
  ASSERT_EQ(sheet.joints.size(), 3u) << "open at the seam";
  for (const Joint& joint : sheet.joints) {
    ASSERT_TRUE(joint.sharp);
    EXPECT_EQ(sheet[*joint.sharp].kind, BendKind::sharp);
    EXPECT_NEAR(sheet[*joint.sharp].angle.radians(), std::acos(1.0 / 17.0), 1e-12);
  }
  EXPECT_DOUBLE_EQ(sheet.reference_depth, 0.6 * 2.0);
}

TEST(NamedSheet, JoinsPlanesAndConesSmoothly) {
  const Ring ring = square_to_circle();
  RulingNames names(*ring.hull, 1e-6);
  const Sheet sheet = named(ring, names);
  EXPECT_EQ(sheet.flanges.size(), 4u);
  EXPECT_EQ(sheet.bends.size(), 4u);
  ASSERT_EQ(sheet.joints.size(), 7u);
  for (const Joint& joint : sheet.joints) {
    EXPECT_FALSE(joint.sharp);
    EXPECT_EQ(sheet[joint.a].edge, sheet[joint.b].edge) << "one edge";
    const Face &a = sheet[joint.a.face], &b = sheet[joint.b.face];
    for (const double t : {0.0, 0.4, 1.0})
      EXPECT_LT((skin_point(a, point_at(sheet[joint.a].curve, t)) -
                 skin_point(b, point_at(sheet[joint.b].curve, 1.0 - t)))
                    .norm(),
                1e-7);
  }
}

TEST(NamedSheet, HasLabelsWhereItsRulingsEnd) {
  const Ring ring = square_to_circle();
  RulingNames names(*ring.hull, 1e-6);
  const Sheet sheet = named(ring, names);
  for (const char* corner : {"A", "B", "C", "D"}) {
    const auto label = std::ranges::find_if(sheet.labels,
                                            [&](const PointLabel& l) { return l.text == corner; });
    ASSERT_NE(label, sheet.labels.end()) << corner;
    const Vec2 at = rectangle(100, 100).corners[corner[0] - 'A'];
    EXPECT_LT((skin_point(sheet[label->face], label->at) - Vec3(at.x(), at.y(), 0)).norm(), 1e-7);
  }
  EXPECT_EQ(names.true_lengths().size(), 8u) << "a ruling between every two of eight patches";
}

TEST(NamedSheet, NumbersPressLinesByBend) {
  const Ring ring = square_to_circle();
  RulingNames names(*ring.hull, 1e-6);
  TransitionSpec spec = two_millimetres();
  spec.pressing = PressCount{3};
  const Sheet sheet = named(ring, names, spec);
  for (const BendId id : sheet.bends.ids()) {
    const auto& lines = sheet[id].press_lines;
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_LT(lines[0].u, lines[1].u);
    EXPECT_LT(lines[1].u, lines[2].u);
  }
  std::vector<std::string> presses;
  for (const TrueLength& length : names.true_lengths())
    if (!length.press.empty()) presses.push_back(length.press);
  EXPECT_EQ(presses.size(), 12u);
  EXPECT_EQ(std::ranges::count(presses, "B2.3"), 1);
}

TEST(CutSheet, HasNoTipsAndNoLabels) {
  const Ring ring = antiprism();
  const TransitionSpec spec = two_millimetres();
  const TipCuts tips(ring, {whole(ring)}, spec);
  const auto sheet = cut_sheet(ring, spec, whole(ring), tips);
  ASSERT_TRUE(sheet) << sheet.error().message;
  EXPECT_TRUE(sheet->labels.empty());
  EXPECT_TRUE(
      std::ranges::any_of(sheet->faces, [](const Face& face) { return face.loops[0].size() > 3; }));
}

}  // namespace
}  // namespace planish::test
