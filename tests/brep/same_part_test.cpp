#include "body.hpp"
#include "guarded.hpp"
#include "step_out.hpp"
#include "support/real_parts.hpp"
#include "support/sheets.hpp"

#include <planish/brep/step.hpp>
#include <planish/sheet/same_part.hpp>

#include <BRepBuilderAPI_Transform.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

// The same solid, wherever it lies in its file, is the same part; its mirror image is the same
// only if the two patterns are.

namespace planish::test {
namespace {

namespace fs = std::filesystem;

Result<FlatPattern> flat_of(const Body& body) {
  const auto found = recognize(body);
  if (!found) return tl::unexpected(found.error());
  return flatten(found->sheet);
}

/// What is read of the body after the motion.
Result<FlatPattern> flat_of_moved(const Body& body, const gp_Trsf& motion) {
  const auto text = brep::guarded([&] {
    return brep::step_text(BRepBuilderAPI_Transform(body.shape().solid, motion, true).Shape(),
                           "moved");
  });
  if (!text) return tl::unexpected(text.error());
  const auto file = read_step_text(*text, "moved.step");
  if (!file) return tl::unexpected(file.error());
  return flat_of(file->bodies.front());
}

gp_Trsf turned_in_space() {
  gp_Trsf turn, shift;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, -2, 0.7)), 1.234);
  shift.SetTranslation(gp_Vec(-310, 47, 1020));
  return shift * turn;
}

gp_Trsf mirrored_in_space() {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(5, 0, 0), gp_Dir(0.6, 0.8, 0)));
  return mirror;
}

/// A channel with a hole near one corner: a left and a right one differ.
Body handed_part() {
  Sheet sheet = u_channel();
  BorderLoop hole;
  for (const Curve2& curve : circular_opening({8.0, 5.0}, 2.0))
    hole.push_back({curve});
  sheet.faces[sheet.flanges[FlangeId{0}].faces.front()].loops.push_back(hole);
  sheet.volume.reset();
  sheet.genus.reset();
  auto body = folded_body(sheet, "channel");
  EXPECT_TRUE(body) << body.error().message;
  return *body;
}

TEST(SamePartInSpace, IsFoundInAnyPlaceButNotInAMirror) {
  const Body body = handed_part();
  const auto here = flat_of(body), there = flat_of_moved(body, turned_in_space()),
             mirrored = flat_of_moved(body, mirrored_in_space());
  ASSERT_TRUE(here && there && mirrored);
  EXPECT_TRUE(is_same_part(*here, *there));
  EXPECT_FALSE(is_same_part(*here, *mirrored));
  EXPECT_FALSE(is_same_part(*there, *mirrored));
}

TEST(SamePartInSpace, IsFoundForRealParts) {
  if (!fs::exists(real_parts_folder())) GTEST_SKIP() << kNoRealParts;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(real_parts_folder()))
    if (entry.path().filename().string().starts_with("sm")) files.push_back(entry.path());
  std::ranges::sort(files);
  int compared = 0;
  for (const fs::path& file : files) {
    constexpr int kEnough = 12;
    if (compared == kEnough) break;
    const auto step = read_step(file);
    if (!step || step->bodies.size() != 1) continue;
    const auto here = flat_of(step->bodies.front());
    if (!here) continue;
    SCOPED_TRACE(file.filename().string());
    const auto there = flat_of_moved(step->bodies.front(), turned_in_space());
    ASSERT_TRUE(there) << there.error().message;
    EXPECT_TRUE(is_same_part(*here, *there));
    ++compared;
  }
  EXPECT_GT(compared, 5);
}

}  // namespace
}  // namespace planish::test
