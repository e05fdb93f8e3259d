#include "sides.hpp"

#include <planish/sheet/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::job {
namespace {

using ::testing::HasSubstr;

// Two flanges that came from the faces 12 and 7 of a solid, and a bend from face 3.
Sheet sheet() {
  Sheet made;
  const auto add = [&made](int source, std::variant<FlangeId, BendId> part) {
    Face face;
    face.source_face = source;
    face.part_of = part;
    made.faces.push_back(face);
  };
  add(12, FlangeId{0});
  add(3, BendId{0});
  add(7, FlangeId{1});
  return made;
}

Request sides_of(const std::string& root, const std::string& up) {
  Request made;
  made.root = root;
  made.up = up;
  return made;
}

TEST(Sides, LeaveTheChoiceToFlattenUnlessAsked) {
  const auto options = flatten_options(sheet(), sides_of("largest", "auto"));
  ASSERT_TRUE(options.has_value());
  EXPECT_FALSE(options->root.has_value());
  EXPECT_EQ(options->up, UpSide::automatic);
}

TEST(Sides, FindTheFaceThatANumberOfTheSolidNames) {
  const auto options = flatten_options(sheet(), sides_of("7", "12"));
  ASSERT_TRUE(options.has_value());
  EXPECT_EQ(options->root, FaceId{2});
  EXPECT_EQ(options->up, UpSide::reference);
  EXPECT_EQ(flatten_options(sheet(), sides_of("12", "other"))->up, UpSide::other);
}

TEST(Sides, FindTheBendsThatHaveAKOfTheirOwn) {
  Sheet made = sheet();
  made.bends.resize(12);
  Request asked = sides_of("largest", "auto");
  asked.bend_k = {{"B1", 0.3}, {"B12", 0.5}};
  const auto options = flatten_options(made, asked);
  ASSERT_TRUE(options.has_value());
  EXPECT_EQ(options->bend_k,
            (std::vector<std::pair<BendId, double>>{{BendId{0}, 0.3}, {BendId{11}, 0.5}}));
  for (const char* wrong : {"B0", "B13", "B", "F1", "b1", "B01", ""}) {
    asked.bend_k = {{wrong, 0.3}};
    const auto refused = flatten_options(made, asked);
    ASSERT_FALSE(refused.has_value()) << wrong;
    EXPECT_EQ(refused.error().code, code::bad_option);
    EXPECT_THAT(refused.error().message, HasSubstr("B1 to B12"));
    EXPECT_EQ(refused.error().where, std::string("bend_k/") + wrong);
  }
}

TEST(Sides, ListTheFacesThatCanBeTheRoot) {
  // A bend has no frame to stay in.
  for (const char* wrong : {"3", "99", "0", "-1"}) {
    const auto options = flatten_options(sheet(), sides_of(wrong, "auto"));
    ASSERT_FALSE(options.has_value()) << wrong;
    EXPECT_EQ(options.error().code, code::no_such_face);
    EXPECT_THAT(options.error().message, HasSubstr("7, 12"));
    EXPECT_EQ(options.error().where, "root");
  }
}

TEST(Sides, ListTheFacesOfTheSkinThatCanFaceUp) {
  const auto options = flatten_options(sheet(), sides_of("largest", "99"));
  ASSERT_FALSE(options.has_value());
  EXPECT_EQ(options.error().code, code::no_such_face);
  EXPECT_THAT(options.error().message, HasSubstr("3, 7, 12"));
}

TEST(Sides, RefuseOtherWords) {
  EXPECT_EQ(flatten_options(sheet(), sides_of("biggest", "auto")).error().code, code::bad_option);
  EXPECT_EQ(flatten_options(sheet(), sides_of("7x", "auto")).error().code, code::bad_option);
  EXPECT_EQ(flatten_options(sheet(), sides_of("largest", "down")).error().code, code::bad_option);
}

}  // namespace
}  // namespace planish::job
