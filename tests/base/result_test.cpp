#include <planish/base/result.hpp>

#include <gtest/gtest.h>

#include <set>

namespace planish {
namespace {

/// Every code, by the order of the enumeration; `internal` is documented as the last.
std::vector<ErrorCode> every_code() {
  std::vector<ErrorCode> codes;
  for (int i = 0; i <= static_cast<int>(ErrorCode::internal); ++i)
    codes.push_back(static_cast<ErrorCode>(i));
  return codes;
}

TEST(ErrorCodes, HaveUniqueNamesOfLowerCaseWords) {
  std::set<std::string_view> names;
  for (const ErrorCode code : every_code()) {
    const std::string_view name = code_name(code);
    EXPECT_FALSE(name.empty());
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string_view::npos)
        << name;
    EXPECT_TRUE(names.insert(name).second)
        << name << " names two codes; a row of the table may be missing";
  }
}

TEST(ErrorCodes, AreSpelledAsInTheEnumeration) {
  EXPECT_EQ(code_name(ErrorCode::bad_option), "bad_option");
  EXPECT_EQ(code_name(ErrorCode::not_a_sheet), "not_a_sheet");
  EXPECT_EQ(code_name(ErrorCode::truncated_file), "truncated_file");
  EXPECT_EQ(code_name(ErrorCode::internal), "internal");
}

// formats.md#exit-status: 1 internal, 2 wrong usage, 3 input cannot be read or is invalid, 4
// refused.
TEST(ErrorCodes, HaveTheExitStatusOfTheirGroup) {
  for (const ErrorCode code : every_code()) {
    int expected = 4;
    if (code <= ErrorCode::no_such_face) {
      expected = 2;
    } else if (code <= ErrorCode::crashed) {
      expected = 3;
    } else if (code >= ErrorCode::invalid_sheet) {
      expected = 1;
    }
    EXPECT_EQ(exit_status(code), expected) << code_name(code);
  }
}

TEST(Fail, CarriesCodeMessageAndPlace) {
  const Result<int> result = fail(ErrorCode::empty_file, "The file has no content.", "a.step");
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, ErrorCode::empty_file);
  EXPECT_EQ(result.error().message, "The file has no content.");
  EXPECT_EQ(result.error().where, "a.step");
}

TEST(Fail, NeedsNoPlace) {
  const Result<int> result = fail(ErrorCode::internal, "?");
  ASSERT_FALSE(result.has_value());
  EXPECT_TRUE(result.error().where.empty());
}

}  // namespace
}  // namespace planish
