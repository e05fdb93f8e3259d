#include <planish/schema/printable.hpp>
#include <planish/schema/utf8.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace planish::schema {
namespace {

/// By the table of RFC 3629, section 3.
std::string encoded(char32_t c) {
  const auto next = [](char32_t bits) { return static_cast<char>(0x80 | (bits & 0x3F)); };
  if (c < 0x80) return {static_cast<char>(c)};
  if (c < 0x800) return {static_cast<char>(0xC0 | c >> 6), next(c)};
  if (c < 0x10000) return {static_cast<char>(0xE0 | c >> 12), next(c >> 6), next(c)};
  return {static_cast<char>(0xF0 | c >> 18), next(c >> 12), next(c >> 6), next(c)};
}

TEST(CodePoints, AreThoseOfTheStandard) {
  // The limits of each length, and those beside the surrogates.
  std::string text;
  const std::vector<char32_t> all{0x00,   0x41,   0x7F,   0x80,    0x7FF,   0x800,
                                  0xD7FF, 0xE000, 0xFFFF, 0x10000, 0x40000, 0x10FFFF};
  for (const char32_t c : all)
    text += encoded(c);
  const auto points = code_points(text);
  ASSERT_EQ(points.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(points[i].valid) << i;
    EXPECT_EQ(points[i].value, all[i]);
    EXPECT_EQ(points[i].bytes, encoded(all[i]));
  }
}

TEST(CodePoints, LeaveBytesAloneThatStartNone) {
  for (const std::string broken :
       {"\x80", "\xBF", "\xFF", "\xF8\x88\x80\x80\x80",              // start nothing
        "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xF0\x8F\xBF\xBF",  // overlong
        "\xED\xA0\x80", "\xED\xBF\xBF",                              // surrogates
        "\xF4\x90\x80\x80", "\xF7\xBF\xBF\xBF",                      // beyond U+10FFFF
        "\xC3", "\xE2\x82", "\xF0\x9D\x84"}) {                       // cut off
    const std::string text = broken + "a";
    const auto points = code_points(text);
    ASSERT_EQ(points.size(), broken.size() + 1);
    for (std::size_t i = 0; i < broken.size(); ++i) {
      EXPECT_FALSE(points[i].valid);
      EXPECT_EQ(points[i].bytes, broken.substr(i, 1));
    }
    EXPECT_TRUE(points.back().valid);
  }
}

RC_GTEST_PROP(CodePoints, LoseNoByte, (const std::string& text)) {
  std::string again;
  for (const CodePoint& c : code_points(text)) {
    again += c.bytes;
    if (c.valid) RC_ASSERT(encoded(c.value) == c.bytes);
  }
  RC_ASSERT(again == text);
}

TEST(Printable, KeepsTextAndReplacesWhatCommandsATerminal) {
  EXPECT_EQ(printable("Träger 12 – “x”"), "Träger 12 – “x”");
  for (const char32_t control : {0x00, 0x1B, 0x1F, 0x0A, 0x7F, 0x80, 0x9B, 0x9F})
    EXPECT_EQ(printable("a" + encoded(control) + "b"), "a\uFFFDb") << static_cast<int>(control);
  EXPECT_EQ(printable(encoded(0x20) + "~" + encoded(0xA0)), " ~\u00A0");
  EXPECT_EQ(printable("tr\xE4ger"), "tr\uFFFDger");
}

}  // namespace
}  // namespace planish::schema
