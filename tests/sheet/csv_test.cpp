#include <planish/sheet/codes.hpp>
#include <planish/sheet/csv.hpp>

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>

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

TEST(CsvNumber, HasUpToSixDigitsAndNoExponent) {
  EXPECT_EQ(csv_number(2.0000000000000004), "2");
  EXPECT_EQ(csv_number(0.5), "0.5");
  EXPECT_EQ(csv_number(1000.0), "1000");
  EXPECT_EQ(csv_number(151.59582910), "151.596");
  EXPECT_EQ(csv_number(0.00430288302), "0.00430288");
  EXPECT_EQ(csv_number(234667.83), "234668");
  EXPECT_EQ(csv_number(12345678.9), "12345679") << "whole numbers keep their digits";
  EXPECT_EQ(csv_number(999999.7), "1000000");
  EXPECT_EQ(csv_number(-1.25), "-1.25");
  EXPECT_EQ(csv_number(0.0), "0");
  EXPECT_EQ(csv_number(-1.4e-14), "0") << "no minus before it";
  EXPECT_EQ(csv_number(std::nan("")), "");
  EXPECT_EQ(csv_number(std::optional<double>()), "");
  EXPECT_EQ(csv_number(std::optional(0.1)), "0.1");
}

RC_GTEST_PROP(CsvNumber, IsReadBackToSixDigits, (int thousandths)) {
  const double value = thousandths / 1000.0;
  const std::string text = csv_number(value);
  RC_ASSERT(std::abs(std::stod(text) - value) <= 0.51e-5 * std::abs(value));
  RC_ASSERT(text.find('e') == std::string::npos);
  RC_ASSERT(text.find('.') == std::string::npos || text.back() != '0');
}

}  // namespace
}  // namespace planish::test
