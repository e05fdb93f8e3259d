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

}  // namespace
}  // namespace planish
