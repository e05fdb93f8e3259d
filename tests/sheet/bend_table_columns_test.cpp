#include "bend_table_columns.hpp"

#include <planish/sheet/codes.hpp>

#include <gmock/gmock.h>

#include <numbers>

namespace planish::test {
namespace {

using sheet_detail::Column;
using sheet_detail::TableShape;

Result<TableShape> shape_of(const std::vector<std::string>& fields) {
  return TableShape::from({7, fields}, "table.csv");
}

/// What 10 under this heading is, mm or degrees, in a table with R, T and K.
double ten_under(const std::string& heading, Column column) {
  std::vector<std::string> fields{"R", "T", "angle", "K"};
  fields[column == Column::radius      ? 0
         : column == Column::thickness ? 1
         : column == Column::angle     ? 2
                                       : 3] = heading;
  const auto shape = shape_of(fields);
  if (!shape) throw std::runtime_error(shape.error().message);
  if (!shape->has(column)) throw std::runtime_error(heading + " is not known");
  return shape->at(column).shift + shape->at(column).scale * 10;
}

TEST(BendTableColumns, TurnUnitsIntoMillimetresAndDegrees) {
  EXPECT_NEAR(ten_under("R (mm)", Column::radius), 10, 1e-12);
  EXPECT_NEAR(ten_under("Inside radius [in]", Column::radius), 254, 1e-12);
  EXPECT_NEAR(ten_under("thickness (\")", Column::thickness), 254, 1e-12);
  EXPECT_NEAR(ten_under("T inch", Column::thickness), 254, 1e-12);
  EXPECT_NEAR(ten_under("R_mm", Column::radius), 10, 1e-12);
  EXPECT_NEAR(ten_under("angle (rad)", Column::angle), 1800 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(ten_under("angle deg", Column::angle), 10, 1e-12);
  EXPECT_NEAR(ten_under("Opening angle", Column::angle), 170, 1e-12);
  EXPECT_NEAR(ten_under("Included angle (rad)", Column::angle), 180 - 1800 / std::numbers::pi,
              1e-9);
}

TEST(BendTableColumns, TurnOtherFactorsIntoK) {
  EXPECT_NEAR(ten_under("K-factor", Column::k), 10, 1e-12);
  EXPECT_NEAR(ten_under("K (ANSI)", Column::k), 10, 1e-12);
  EXPECT_NEAR(ten_under("DIN k", Column::k), 5, 1e-12);
  EXPECT_NEAR(ten_under("Y-factor", Column::k), 20 / std::numbers::pi, 1e-12);
}

TEST(BendTableColumns, KnowWhichTableTheyMake) {
  const auto by_ratio = shape_of({"note", "R/T", "K"});
  ASSERT_TRUE(by_ratio);
  EXPECT_TRUE(by_ratio->by_ratio());
  EXPECT_EQ(by_ratio->value(), Column::k);
  EXPECT_EQ(by_ratio->at(Column::ratio).field, 1u);
  EXPECT_EQ(by_ratio->at(Column::k).field, 2u);
  EXPECT_FALSE(by_ratio->has(Column::angle));
  const auto allowances = shape_of({"R", "T", "BA"}),
             deductions = shape_of({"BD", "angle", "T", "R"});
  ASSERT_TRUE(allowances);
  ASSERT_TRUE(deductions);
  EXPECT_FALSE(allowances->by_ratio());
  EXPECT_EQ(allowances->value(), Column::allowance);
  EXPECT_EQ(deductions->value(), Column::deduction);
  EXPECT_EQ(deductions->at(Column::radius).field, 3u);
  const auto both = shape_of({"R/T", "R", "T", "K"});
  ASSERT_TRUE(both);
  EXPECT_FALSE(both->by_ratio()) << "R and T say more";
}

TEST(BendTableColumns, RefuseWhatIsNoTable) {
  const auto refusal = [](const std::vector<std::string>& fields) {
    const auto shape = shape_of(fields);
    EXPECT_FALSE(shape);
    if (shape) return std::string();
    EXPECT_EQ(shape.error().code, code::invalid_input);
    EXPECT_EQ(shape.error().where, "table.csv:7");
    return shape.error().message;
  };
  using testing::HasSubstr;
  EXPECT_THAT(refusal({"R/T"}), HasSubstr("header must name"));
  EXPECT_THAT(refusal({"R", "K"}), HasSubstr("header must name"));
  EXPECT_THAT(refusal({"R/T", "K", "BA"}), HasSubstr("more than one"));
  EXPECT_THAT(refusal({"R/T", "T", "K"}), HasSubstr("together"));
  EXPECT_THAT(refusal({"R/T", "BD"}), HasSubstr("need the columns R and T"));
  EXPECT_THAT(refusal({"R", "T", "radius", "K"}), HasSubstr("both give R"));
  EXPECT_THAT(refusal({"R (m)", "T", "K"}), HasSubstr("unit"));
  EXPECT_THAT(refusal({"R/T", "K (%)"}), HasSubstr("unit"));
  EXPECT_THAT(refusal({"R (deg)", "T", "K"}), HasSubstr("unit")) << "not of a length";
  EXPECT_THAT(refusal({"R", "T", "angle (mm)", "K"}), HasSubstr("unit")) << "not of an angle";
}

}  // namespace
}  // namespace planish::test
