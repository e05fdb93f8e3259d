#include "support/folded_box.hpp"

#include <planish/sheet/codes.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/rip.hpp>

#include <gmock/gmock.h>

namespace planish::test {
namespace {

Result<void> opens(const Sheet& open) {
  const auto flat = flatten(open);
  return flat ? Result<void>{} : tl::unexpected(flat.error());
}

std::vector<int> sorted_rips(const Sheet& sheet, const SheetCheck& passes = opens,
                             const FlattenOptions& options = {}) {
  auto rips = rips_to_open(sheet, options, passes);
  if (!rips) throw std::runtime_error(rips.error().message);
  std::ranges::sort(*rips);
  return *rips;
}

TEST(RipsToOpen, AShallowBoxRunUpItsCorners) {
  const FoldedBox box = folded_box({.length = 80, .width = 50, .height = 20, .thickness = 2});
  EXPECT_THAT(sorted_rips(box.sheet), testing::UnorderedElementsAreArray(box.upright));
}

TEST(RipsToOpen, ADeepBoxKeepItsLongEdges) {
  const FoldedBox box = folded_box({.length = 40, .width = 30, .height = 200, .thickness = 2});
  const std::vector<int> rips = sorted_rips(box.sheet);
  ASSERT_EQ(rips.size(), 4u) << "eight folds, of which a tree of five walls keeps four";
  const auto upright = std::ranges::count_if(
      rips, [&](int edge) { return std::ranges::count(box.upright, edge) > 0; });
  EXPECT_EQ(upright, 1);
  // The edge of the base that is kept is a long one.
  const auto kept = std::ranges::find_if(
      box.around, [&](int edge) { return std::ranges::count(rips, edge) == 0; });
  ASSERT_NE(kept, box.around.end());
  EXPECT_EQ((kept - box.around.begin()) % 2, 0) << "of 40, not of 30";
}

TEST(RipsToOpen, ADeepBoxAsPetalsWhereTheFirstChoiceDoesNotPass) {
  const FoldedBox box = folded_box({.length = 40, .width = 30, .height = 200, .thickness = 2});
  const SheetCheck petals = [&](const Sheet& open) -> Result<void> {
    for (const Joint& joint : open.joints)
      if (std::ranges::count(box.upright, *open[joint.a].edge) > 0)
        return fail(code::overlap, "Walls cover each other.");
    return opens(open);
  };
  // About the base; by itself the largest face is a wall, and its petals keep two corners. Either
  // way, whichever joint is listed first.
  Sheet sheet = box.sheet;
  for (std::size_t i = 0; i < box.sheet.joints.size(); ++i) {
    std::ranges::rotate(sheet.joints, sheet.joints.begin() + 1);
    EXPECT_THAT(sorted_rips(sheet, petals, {.root = FaceId{0}}),
                testing::UnorderedElementsAreArray(box.upright));
  }
  EXPECT_FALSE(rips_to_open(box.sheet, {}, petals));
}

TEST(RipsToOpen, OneOfATube) {
  const Sheet tube = folded_tube(40, 30, 100, 2);
  EXPECT_EQ(sorted_rips(tube).size(), 1u);
}

TEST(RipsToOpen, SayWhyNoneDo) {
  const Sheet tube = folded_tube(40, 30, 100, 2);
  const SheetCheck never = [](const Sheet&) -> Result<void> {
    return fail(code::overlap, "Walls cover each other.");
  };
  EXPECT_EQ(rips_to_open(tube, {}, never).error().code, code::overlap);
  Sheet outside = tube;
  for (Bend& bend : outside.bends)
    bend.reference_inside = false;
  EXPECT_EQ(rips_to_open(outside, {}, opens).error().code, code::closed_loop);
}

TEST(LoopRefusal, NamesTheFirstEdgeAndHowManyThereAre) {
  const Error closed{code::closed_loop, "It does not close.", "here"};
  const Error one = loop_refusal(folded_tube(40, 30, 100, 2), closed, {}, opens);
  EXPECT_EQ(one.code, code::closed_loop);
  EXPECT_THAT(one.message, testing::HasSubstr("Rip edge "));
  EXPECT_THAT(one.where, testing::StartsWith("edge "));
  EXPECT_TRUE(std::ranges::none_of(one.numbers, [](const NamedQuantity& number) {
    return number.name == "count";
  })) << "one needs no count";
  const FoldedBox box = folded_box({.length = 80, .width = 50, .height = 20, .thickness = 2});
  const Error four = loop_refusal(box.sheet, closed, {}, opens);
  EXPECT_THAT(four.message, testing::HasSubstr("Rip 4 edges"));
  const SheetCheck covered = [](const Sheet&) -> Result<void> {
    return fail(code::overlap, "Walls cover each other.");
  };
  const Error none = loop_refusal(box.sheet, closed, {}, covered);
  EXPECT_EQ(none.code, code::closed_loop);
  EXPECT_THAT(none.message, testing::HasSubstr("covers itself"));
}

}  // namespace
}  // namespace planish::test
