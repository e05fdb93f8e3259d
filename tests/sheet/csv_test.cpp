#include <planish/sheet/codes.hpp>
#include <planish/sheet/csv.hpp>

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

namespace planish::test {
namespace {

using Fields = std::vector<std::string>;

std::vector<CsvRecord> records(const std::string& text) {
  auto split = split_csv(text, "table.csv");
  if (!split) throw std::runtime_error(split.error().message);
  return *split;
}

void expect_records(const std::string& text, const std::vector<std::pair<int, Fields>>& wanted) {
  const auto found = records(text);
  ASSERT_EQ(found.size(), wanted.size()) << text;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(found[i].line, wanted[i].first) << text;
    EXPECT_EQ(found[i].fields, wanted[i].second) << text;
  }
}

TEST(Csv, SplitsAtTheFirstRecordsSeparator) {
  expect_records("a,b\n1,2", {{1, {"a", "b"}}, {2, {"1", "2"}}});
  expect_records("a;b\n1,5;2", {{1, {"a", "b"}}, {2, {"1,5", "2"}}});
  expect_records("a\tb\n1,5\t2", {{1, {"a", "b"}}, {2, {"1,5", "2"}}});
  expect_records("# x;y\n\na,b", {{3, {"a", "b"}}});
  expect_records("a,b\t\n1,2", {{1, {"a", "b"}}, {2, {"1", "2"}}});
  expect_records("sep=;\na,1;b", {{2, {"a,1", "b"}}});
  expect_records("SEP=|\na,1|b", {{2, {"a,1", "b"}}});
  expect_records(
      "\xEF\xBB\xBF"
      "a,b",
      {{1, {"a", "b"}}});
}

TEST(Csv, CountsLinesWhateverTheyEndWith) {
  for (const std::string end : {"\n", "\r\n", "\r"})
    expect_records("a" + end + end + "b" + end + "\"c" + end + "d\"" + end + "e",
                   {{1, {"a"}}, {3, {"b"}}, {4, {"c" + end + "d"}}, {6, {"e"}}});
}

TEST(Csv, LeavesOutCommentsAndEmptyRecords) {
  expect_records("# all of it\na, # rest\n,,\n \t\nb # not,c\nd#e,f",
                 {{2, {"a", ""}}, {5, {"b"}}, {6, {"d#e", "f"}}});
}

TEST(Csv, KeepsWhatIsQuoted) {
  expect_records("\"a,b\",\" c \",\"d\"\"e\",\"#f\" # g", {{1, {"a,b", "c", "d\"e", "#f"}}});
  expect_records("\"\",x", {{1, {"", "x"}}});
}

TEST(Csv, NamesTheLineOfAQuoteThatIsNotClosed) {
  const auto split = split_csv("a\n\n\"b\nc", "table.csv");
  ASSERT_FALSE(split);
  EXPECT_EQ(split.error().code, code::invalid_input);
  EXPECT_EQ(split.error().where, "table.csv:3");
}

TEST(Csv, RefusesWhatIsNoText) { EXPECT_FALSE(split_csv(std::string("a\0b", 3), "table.csv")); }

TEST(CsvRow, QuotesWhatWouldBeMisread) {
  EXPECT_EQ(csv_row({"a", "b c", "1.5"}), "a,b c,1.5\n");
  EXPECT_EQ(csv_row({"a,b", "c;d", "e\"f", "g\nh", "i\rj"}),
            "\"a,b\",\"c;d\",\"e\"\"f\",\"g\nh\",\"i\rj\"\n");
  EXPECT_EQ(csv_row({}), "\n");
}

RC_GTEST_PROP(CsvRow, IsReadBackAsItWas, ()) {
  Fields cells = *rc::gen::nonEmpty(rc::gen::container<Fields>(
      rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab,\"\n#")))));
  cells.front() = "x" + cells.front();  // an empty record is none
  for (std::string& cell : cells)
    cell = "'" + cell + "'";  // blanks at the ends are trimmed, a # at the start begins a comment
  const auto found = records(csv_row(cells));
  RC_ASSERT(found.size() == 1U);
  RC_ASSERT(found.front().fields == cells);
}

}  // namespace
}  // namespace planish::test
