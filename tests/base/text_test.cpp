#include <planish/base/text.hpp>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(Shortened, LeavesWhatIsShortEnough) {
  EXPECT_EQ(shortened("", 3), "");
  EXPECT_EQ(shortened("abc", 3), "abc");
}

TEST(Shortened, CutsBetweenCharacters) {
  EXPECT_EQ(shortened("abcd", 3), "abc…");
  EXPECT_EQ(shortened("aßcd", 2), "a…") << "ß is two bytes";
  EXPECT_EQ(shortened("€€", 5), "€…") << "€ is three bytes";
  EXPECT_EQ(shortened("\x80\x80\x80", 2), "…") << "bytes that are not UTF-8";
}

TEST(ByteOrderMark, IsTakenFromTheBeginningAlone) {
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBF"
                                    "a"),
            "a");
  EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBF"), "");
  for (const char* text : {"", "a", "\xEF\xBB", "a\xEF\xBB\xBF"})
    EXPECT_EQ(without_byte_order_mark(text), text);
}

TEST(Continued, BeginsSmallUnlessWithAName) {
  EXPECT_EQ(continued("The profile has no tip"), "the profile has no tip");
  EXPECT_EQ(continued("A bend is too tight"), "a bend is too tight");
  EXPECT_EQ(continued("STEP is damaged"), "STEP is damaged");
  EXPECT_EQ(continued("K-factor"), "K-factor");
  EXPECT_EQ(continued("Cairo could not draw"), "Cairo could not draw");
  EXPECT_EQ(continued("V"), "V");
  EXPECT_EQ(continued(""), "");
}

}  // namespace
}  // namespace planish
