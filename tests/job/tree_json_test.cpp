#include "tree_json.hpp"

#include "support/sheets.hpp"

#include <planish/sheet/flat_pattern.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace planish::job {
namespace {

using namespace schema;
using namespace test;
using ::testing::UnorderedElementsAre;

Report report_laid(const Sheet& sheet) {
  Report report;
  report.sheet = sheet;
  auto flat = flat_sheet(sheet, {.allowance = ConstantK{0.44, ""}});
  EXPECT_TRUE(flat) << flat.error().message;
  report.flat = flat->pattern;
  report.layout = flat->layout;
  return report;
}

std::vector<std::pair<std::string, std::string>> links_of(const Json& tree) {
  std::vector<std::pair<std::string, std::string>> links;
  for (const Json& row : tree)
    if (!row["parent"].is_null()) links.emplace_back(row["parent"], row["part"]);
  return links;
}

TEST(Tree, LeadsFromTheRootToEveryPartOnce) {
  const Json tree = tree_json(report_laid(u_channel()), Units(LengthUnit::mm));
  ASSERT_EQ(tree.size(), 5u);
  EXPECT_TRUE(tree[0]["parent"].is_null());
  std::map<std::string, int> known;
  for (const Json& row : tree) {
    EXPECT_TRUE(row["parent"].is_null() || known.contains(row["parent"])) << row;
    EXPECT_EQ(known[row["part"]]++, 0) << row;
    EXPECT_EQ(row.contains("transform"), row["part"].get<std::string>().starts_with("F"));
  }
  const std::string root = tree[0]["part"];
  for (const auto& [parent, part] : links_of(tree))
    EXPECT_EQ(parent.front() == 'F', part.front() == 'B') << "flanges and bends in turn";
  EXPECT_EQ(links_of(tree)[0].first, root);
}

TEST(Tree, HasASharpBendBetweenTheFlangesThatMeetThere) {
  const Sheet sheet = strip(
      {Straight{30}, Crease{Angle::degrees(90), BendDirection::up}, Straight{20}}, 20, 2);
  EXPECT_THAT(links_of(tree_json(report_laid(sheet), Units(LengthUnit::mm))),
              UnorderedElementsAre(std::pair<std::string, std::string>{"F1", "B1"},
                                   std::pair<std::string, std::string>{"B1", "F2"}));
}

TEST(Tree, PutsFlangesWhereTheyAreInSpace) {
  // A border of a flange, carried from the pattern, lies half a thickness below the skin.
  for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch}) {
    const Report report = report_laid(u_channel());
    const double mm = millimetres_in(unit);
    for (const Json& row : tree_json(report, Units(unit))) {
      if (!row.contains("transform")) continue;
      Eigen::Matrix4d m;
      for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
          m(r, c) = row["transform"][r][c].get<double>();
      const FlangeId id{std::stoi(row["part"].get<std::string>().substr(1)) - 1};
      const FaceId face = report.sheet[id].faces.front();
      const Frame& plane = std::get<Frame>(report.sheet[face].surface);
      for (const Border& border : report.sheet[face].loops.front()) {
        const Vec2 uv = start_of(border.curve);
        const Vec2 p = report.layout.develop(report.sheet, face, uv);
        const Eigen::Vector4d there = m * Eigen::Vector4d(p.x() / mm, p.y() / mm, 0, 1) * mm;
        const Vec3 skin = plane.origin + uv.x() * plane.x + uv.y() * plane.y;
        EXPECT_NEAR((there.head<3>() - skin).norm(), report.sheet.thickness / 2, 1e-9);
        EXPECT_NEAR((there.head<3>() - skin).cross(plane.z).norm(), 0.0, 1e-9);
      }
    }
  }
}

TEST(Tree, IsEmptyWithoutALayout) {
  EXPECT_TRUE(tree_json(Report{}, Units(LengthUnit::mm)).empty());
}

}  // namespace
}  // namespace planish::job
