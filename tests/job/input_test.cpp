#include "input.hpp"

#include "support/sheets.hpp"

#include <planish/brep/codes.hpp>
#include <planish/job/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::job {
namespace {

using ::testing::HasSubstr;

StepFile file_with(const std::vector<std::string>& names) {
  StepFile file;
  for (const std::string& name : names) {
    auto body = folded_body(test::l_bracket(), name);
    EXPECT_TRUE(body);
    file.bodies.push_back(*body);
  }
  return file;
}

std::string refusal_of(const StepFile& file, const std::string& wanted) {
  const auto chosen = choose_body(file, wanted);
  EXPECT_FALSE(chosen) << wanted;
  if (chosen) return "";
  EXPECT_EQ(chosen.error().code, code::no_such_body);
  EXPECT_EQ(chosen.error().where, "body");
  return chosen.error().message;
}

TEST(Input, IsTheOnlyBodyOrTheOneThatIsNamed) {
  EXPECT_EQ(*choose_body(file_with({"door"}), ""), 0);
  const StepFile file = file_with({"door", "lid", "3", "lid"});
  EXPECT_EQ(*choose_body(file, "door"), 0);
  EXPECT_EQ(*choose_body(file, "2"), 1);
  EXPECT_EQ(*choose_body(file, "1"), 0);
  EXPECT_EQ(*choose_body(file, "4"), 3);
  EXPECT_EQ(*choose_body(file, "3"), 2) << "numbers come first";
  EXPECT_EQ(*choose_body(file_with({"7"}), "7"), 0) << "a name where no body has the number";
}

TEST(Input, ListsTheBodiesWhereNoneIsMeant) {
  const StepFile file = file_with({"door", "lid", "lid"});
  for (const char* wrong : {"", "0", "4", "-1", "window", "lid", "2x"})
    EXPECT_THAT(refusal_of(file, wrong), HasSubstr("1 \"door\", 2 \"lid\", 3 \"lid\"")) << wrong;
}

TEST(Input, HasAllBodiesOfANameAsItsPlaces) {
  const auto chosen = choose_body(file_with({"door", "lid", "lid"}), "lid");
  ASSERT_FALSE(chosen);
  EXPECT_EQ(chosen.error().places, (std::vector<Place>{place::body(2), place::body(3)}));
}

TEST(Input, ListsOnlyTheFirstOfManyBodies) {
  const std::string said = refusal_of(file_with(std::vector<std::string>(14, "lid")), "door");
  EXPECT_THAT(said, HasSubstr("12 \"lid\" and 2 more"));
  EXPECT_EQ(said.find("13 \"lid\""), std::string::npos);
  const std::string twelve = refusal_of(file_with(std::vector<std::string>(12, "lid")), "door");
  EXPECT_EQ(twelve.find("more"), std::string::npos);
}

TEST(Input, IsReadFromAFile) {
  const auto file = read_input(PLANISH_SOURCE_DIR "/examples/bracket.step", {});
  ASSERT_TRUE(file);
  EXPECT_EQ(file->bodies.size(), 1u);
  EXPECT_EQ(read_input("/no/such.step", {}).error().code, code::cannot_read);
}

}  // namespace
}  // namespace planish::job
