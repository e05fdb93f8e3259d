#include <planish/schema/table.hpp>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

namespace planish::schema {
namespace {

using Align = Table::Align;

TEST(Table, AlignsColumnsToTheSideTheyAreFor) {
  Table table({{"part"}, {"length", Align::right}, {"of"}});
  table.add({"a", "7", "steel"});
  table.add({"bracket", "1000.5", ""});
  EXPECT_EQ(table.text(),
            "part     length  of\n"
            "a             7  steel\n"
            "bracket  1000.5\n");
  EXPECT_EQ(table.text("> "),
            "> part     length  of\n"
            "> a             7  steel\n"
            "> bracket  1000.5\n");
}

TEST(Table, LeavesOutTheMiddleOfLongNames) {
  Table table({{"part", Align::left, 9}, {"of"}});
  table.add({std::string(3000, 'a') + "é2", "steel"});
  table.add({"bracket-1", "brass"});
  EXPECT_EQ(table.text(),
            "part       of\n"
            "aaaaaa…é2  steel\n"
            "bracket-1  brass\n");
}

TEST(Table, CountsCodePointsAndNotBytes) {
  EXPECT_EQ(display_width("90.0°"), 5u);
  EXPECT_EQ(display_width("träger – €𝄞"), 11u);
  Table table({{"°"}, {"x"}});
  table.add({"äöü", "1"});
  EXPECT_EQ(table.text(), "°    x\näöü  1\n");
}

TEST(Table, LetsNoCellCommandTheTerminal) {
  Table table({{"name"}});
  table.add({"red\033[31m\nnext"});
  EXPECT_EQ(table.text(), "name\nred\uFFFD[31m\uFFFDnext\n");
}

RC_GTEST_PROP(Table, BeginsEachColumnAtOnePlace, (std::vector<unsigned> lengths)) {
  Table table({{"name"}, {"end"}});
  std::size_t longest = 4;
  for (const unsigned length : lengths) {
    table.add({std::string(length % 40, 'x'), "."});
    longest = std::max<std::size_t>(longest, length % 40);
  }
  std::istringstream lines(table.text());
  std::string line;
  std::getline(lines, line);
  RC_ASSERT(line.find("end") == longest + 2);
  std::size_t rows = 0;
  for (; std::getline(lines, line); ++rows)
    RC_ASSERT(line.find('.') == longest + 2 && line.size() == longest + 3);
  RC_ASSERT(rows == lengths.size());
}

}  // namespace
}  // namespace planish::schema
