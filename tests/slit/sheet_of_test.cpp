#include "sample_sheets.hpp"

#include <planish/sheet/certificate.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <planish/slit/mould.hpp>

// The developed pattern is the sheet that was cut. Every face is given in the coordinates of the
// flat sheet, so laid flat from one face, every other one must stay exactly where it is.

namespace planish::test {
namespace {

FlatSheet flattened(const Sheet& sheet) {
  FlattenOptions options;
  options.allowance = ConstantK{0.5, "test"};
  options.root = FaceId{0};
  options.up = UpSide::reference;
  auto flat = flat_sheet(sheet, options);
  if (!flat) throw std::runtime_error(flat.error().message);
  return std::move(*flat);
}

void expect_to_be_the_cut_sheet(const SlitSession& session, double area, double size) {
  const Sheet sheet = sheet_of(session.folded());
  const auto& [layout, pattern] = flattened(sheet);
  ASSERT_EQ(layout.placement.size(), sheet.faces.size());
  const Isometry2 back = layout.placement.front().inverse();
  for (const FaceId id : sheet.faces.ids())
    for (const Border& border : sheet[id].loops.front())
      EXPECT_NEAR(
          (back * (layout.placement[id] * start_of(border.curve)) - start_of(border.curve)).norm(),
          0.0, 1e-9 * size)
          << index_of(id);
  EXPECT_LE(pattern.closure, 1e-9 * size);
  EXPECT_NEAR(pattern.area, area, 1e-9 * area);
}

TEST(SheetOf, ChairLiesFlatAsItWasCut) {
  expect_to_be_the_cut_sheet(solved(chair(), 1), 2 * 884.0 * 360.0, 1768);
}

TEST(SheetOf, ChairOnACurvedLegLiesFlatAsItWasCut) {
  SlitDesign design = chair();
  design.leg_curve = {{{330, 0}, {380, 120}, {380, 240}, {330, 353}}};
  expect_to_be_the_cut_sheet(solved(design), 2 * 884.0 * 360.0, 1768);
}

TEST(SheetOf, AsymmetricSheetLiesFlatAsItWasCut) {
  // Panel 157 × 200 and what strips begin later, then the strips.
  const double panel = 157.0 * 200 + 30 * 15.0 + 25 * 22.5;
  const double strips = 40 * 300.0 + 30 * (560 - 215.0) + 25 * (500 - 222.5) + 35 * 280.0;
  expect_to_be_the_cut_sheet(solved(asymmetric()), panel + strips, 560);
}

TEST(SheetOf, StripsAreLabelledAsMessagesCountThem) {
  const Sheet sheet = sheet_of(solved(small_chair()).folded());
  ASSERT_EQ(sheet.labels.size(), 2u);
  EXPECT_EQ(sheet.labels[0].text, "1");
  EXPECT_EQ(sheet.labels[1].text, "2");
  EXPECT_LT(sheet.labels[0].at.y(), sheet.labels[1].at.y());
}

TEST(SheetOf, SlitsAreBordersThatNothingJoins) {
  const Sheet sheet = sheet_of(solved(chair()).folded());
  EXPECT_EQ(sheet.faces.size(), 2u * (6 + 6 * 10));
  // In each half five seams of the panel and ten a strip, and six across the symmetry plane.
  EXPECT_EQ(sheet.joints.size(), 2u * (5 + 60) + 6);
}

TEST(SheetOf, IsCertified) {
  const Sheet sheet = sheet_of(solved(chair(), 1).folded());
  const FlatPattern pattern = flattened(sheet).pattern;
  const auto certificate = certify(sheet, pattern, border_distance(sheet));
  ASSERT_TRUE(certificate) << certificate.error().message;
  EXPECT_LE(certificate->length_error, 1e-9 * 1768);
  EXPECT_LE(*certificate->refold_deviation, 1e-4);
}

TEST(MeshOf, HasTheAreaOfTheSheetAndSharesRidges) {
  const auto folded = solved(chair()).folded();
  const Mesh mesh = mesh_of(folded);
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  EXPECT_NEAR(area, 2 * 884.0 * 360.0, 1e-6);
  EXPECT_EQ(mesh.triangles.size(), 2u * 132);
  // Two points a ridge inside the strips, in both halves and on the symmetry plane; of each panel
  // its corners, the tops of facets being ridges.
  EXPECT_LE(mesh.points.size(), 2u * (6 * 10 * 2 + 14) + 6 * 2);
}

TEST(CheckFoldedSlitSheet, NamesTheRuleAndTheRow) {
  const FoldedSlitSheet sound = solved(chair()).folded();
  EXPECT_TRUE(check(sound));
  const auto refused = [&](const char* where, auto inflict) {
    FoldedSlitSheet broken = sound;
    inflict(broken);
    const auto result = check(broken);
    ASSERT_FALSE(result) << where;
    EXPECT_EQ(result.error().code, code::invalid_sheet);
    EXPECT_EQ(result.error().where, where);
    EXPECT_EQ(mould_of(broken).error().code, code::invalid_sheet) << where;
    EXPECT_DEATH((void)sheet_of(broken), where);
    EXPECT_DEATH((void)mesh_of(broken), where);
  };
  const double nan = std::nan("");
  refused("sheet", [=](FoldedSlitSheet& f) { f.thickness = nan; });
  refused("panel facet 1", [](FoldedSlitSheet& f) { f.panel[1].strip = 99; });
  refused("panel facet 0", [=](FoldedSlitSheet& f) { f.panel[0].corners[2].x() = nan; });
  refused("strip 1", [](FoldedSlitSheet& f) { f.strips[1].quads.clear(); });
  refused("strip 0", [](FoldedSlitSheet& f) { f.strips[0].ridges.pop_back(); });
  refused("strip 2", [=](FoldedSlitSheet& f) { f.strips[2].ridges[3].folded[1].z() = nan; });
}

}  // namespace
}  // namespace planish::test
