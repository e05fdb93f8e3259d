#include "step_text.hpp"

#include <gtest/gtest.h>

namespace planish::brep {
namespace {

std::string read_back(const char* bytes) {
  return step_text(Handle(TCollection_HAsciiString)(new TCollection_HAsciiString(bytes)));
}

TEST(StepText, IsTheTextOfTheFile) {
  EXPECT_EQ(read_back("lid"), "lid");
  EXPECT_EQ(read_back(" two words "), " two words ");
  EXPECT_EQ(read_back("D\xC3\xA4"
                      "ckel \xE2\x8C\x80 5"),
            "D\xC3\xA4"
            "ckel \xE2\x8C\x80 5");
}

TEST(StepText, IsNothingForNothingAndForBlanks) {
  EXPECT_EQ(step_text({}), "");
  EXPECT_EQ(read_back(""), "");
  EXPECT_EQ(read_back("   "), "");
}

}  // namespace
}  // namespace planish::brep
