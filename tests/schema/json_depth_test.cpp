#include <planish/schema/json_depth.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace planish::schema {
namespace {

std::string brackets(int depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(JsonDepth, IsThatOfTheBracketThatOpensOneLevelMore) {
  EXPECT_FALSE(too_deep_at(brackets(kDeepestJson)));
  EXPECT_EQ(too_deep_at(brackets(kDeepestJson + 1)), kDeepestJson + 1u);
  EXPECT_EQ(too_deep_at("  " + brackets(kDeepestJson + 7)), kDeepestJson + 3u);
  EXPECT_FALSE(too_deep_at(""));
}

TEST(JsonDepth, CountsWhatIsOpenAtATime) {
  std::string row = "{\"a\": [";
  for (int i = 0; i < 2 * kDeepestJson; ++i)
    row += "{},[],";
  EXPECT_FALSE(too_deep_at(row + "0]}"));
  // Of both kinds together.
  std::string both;
  for (int i = 0; i <= kDeepestJson / 2; ++i)
    both += "{\"a\":[";
  EXPECT_EQ(too_deep_at(both), 6u * (kDeepestJson / 2) + 1);
}

TEST(JsonDepth, LeavesOutBracketsInTexts) {
  const std::string many(2 * kDeepestJson, '[');
  EXPECT_FALSE(too_deep_at("[\"" + many + "\"]"));
  EXPECT_FALSE(too_deep_at("[\"\\\"" + many + "\"]")) << "an escaped quotation mark ends no text";
  EXPECT_TRUE(too_deep_at("[\"\\\\\"" + many)) << "an escaped backslash escapes nothing";
}

TEST(LineAndColumn, CountFromOne) {
  const std::string text = "ab\ncd\n\ne";
  EXPECT_EQ(line_and_column(text, 1), "1:1");
  EXPECT_EQ(line_and_column(text, 2), "1:2");
  EXPECT_EQ(line_and_column(text, 4), "2:1");
  EXPECT_EQ(line_and_column(text, 5), "2:2");
  EXPECT_EQ(line_and_column(text, 8), "4:1");
  EXPECT_EQ(line_and_column(text, 99), "4:1") << "beyond the end it is the last";
  EXPECT_EQ(line_and_column("", 0), "1:1");
}

RC_GTEST_PROP(LineAndColumn, FindTheByteAgain, ()) {
  const auto text = *rc::gen::nonEmpty(
      rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab\n"))));
  const auto byte = *rc::gen::inRange<std::size_t>(1, text.size() + 1);
  RC_PRE(text[byte - 1] != '\n');
  const std::string place = line_and_column(text, byte);
  const std::size_t colon = place.find(':');
  std::size_t start = 0;  // of the line
  for (int line = std::stoi(place); line > 1; --line)
    start = text.find('\n', start) + 1;
  RC_ASSERT(start + std::stoul(place.substr(colon + 1)) == byte);
}

}  // namespace
}  // namespace planish::schema
