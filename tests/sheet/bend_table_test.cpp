#include <planish/sheet/allowance.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace planish {
namespace {

using testing::HasSubstr;
using Value = BendTable::Value;

BendTable parsed(const std::string& csv) {
  const auto table = parse_bend_table(csv, "table.csv");
  EXPECT_TRUE(table.has_value()) << (table ? "" : table.error().message);
  return table.value_or(BendTable{});
}

/// The error of a table that must be refused, after checking its code and place.
std::string refusal(const std::string& csv, const std::string& where) {
  const auto table = parse_bend_table(csv, "table.csv");
  EXPECT_FALSE(table.has_value()) << csv;
  if (table) return {};
  EXPECT_EQ(table.error().code, code::invalid_input);
  EXPECT_EQ(table.error().where, where);
  const std::size_t colon = where.find(':');
  if (colon != std::string::npos) {
    EXPECT_FALSE(table.error().places.empty()) << table.error().message;
    if (table.error().places.empty()) return {};
    EXPECT_EQ(table.error().places.front(), place::line(std::stoi(where.substr(colon + 1))));
  }
  return table.error().message;
}

void expect_row(const BendTable::Row& row, double radius, double thickness, double angle,
                double value) {
  EXPECT_NEAR(row.radius, radius, 1e-12);
  EXPECT_NEAR(row.thickness, thickness, 1e-12);
  EXPECT_NEAR(row.angle, angle, 1e-12);
  EXPECT_NEAR(row.value, value, 1e-12);
}

TEST(ParseBendTable, ReadsKByRatio) {
  const BendTable table = parsed("R/T,K\n0.5,0.33\n1,0.38\n");
  EXPECT_EQ(table.value, Value::k_factor);
  EXPECT_TRUE(table.by_ratio);
  EXPECT_FALSE(table.by_angle);
  EXPECT_EQ(table.name, "table.csv");
  ASSERT_EQ(table.rows.size(), 2u);
  expect_row(table.rows[0], 0.5, 0, 0, 0.33);
  expect_row(table.rows[1], 1, 0, 0, 0.38);
}

TEST(ParseBendTable, ReadsDeductionsBySizeInAnyOrderOfColumns) {
  const BendTable table = parsed("BD,Angle,T,R\n3.5,90,2,2.5\n");
  EXPECT_EQ(table.value, Value::deduction);
  EXPECT_FALSE(table.by_ratio);
  EXPECT_TRUE(table.by_angle);
  ASSERT_EQ(table.rows.size(), 1u);
  expect_row(table.rows[0], 2.5, 2, 90, 3.5);
}

TEST(ParseBendTable, ReadsWhatASpreadsheetWritesInGermany) {
  const BendTable table = parsed(
      "\xEF\xBB\xBFRadius (mm);Thickness (mm);Angle [deg];Bend allowance\r\n"
      "2,5;2,0;90;5,28\r\n\r\n3;2;90;6,1\r\n");
  EXPECT_EQ(table.value, Value::allowance);
  ASSERT_EQ(table.rows.size(), 2u);
  expect_row(table.rows[0], 2.5, 2, 90, 5.28);
  expect_row(table.rows[1], 3, 2, 90, 6.1);
}

TEST(ParseBendTable, ReadsTabsQuotesCommentsAndOldLineEnds) {
  expect_row(parsed("r\tt\tk\n1\t2\t0,4\n").rows.at(0), 1, 2, 0, 0.4);
  expect_row(parsed("\"R\",\"T\",\"K-factor\"\n\"1,5\",\"2\",\" 0.4 \"\n").rows.at(0), 1.5, 2, 0,
             0.4);
  expect_row(parsed("# steel, V 16\nr/t,k # by hand\n  # more\n1 , 0.4 # measured\n").rows.at(0), 1,
             0, 0, 0.4);
  expect_row(parsed("r/t,k\r1,0.4\r").rows.at(0), 1, 0, 0, 0.4);
  expect_row(parsed("sep=;\nr/t;k\n1;0,4\n").rows.at(0), 1, 0, 0, 0.4);
  expect_row(parsed("\"Bend\nradius\",T,K\n1,2,0.4").rows.at(0), 1, 2, 0, 0.4);
}

TEST(ParseBendTable, ReadsEmptyRowsAndTrailingSeparatorsAsNothing) {
  EXPECT_EQ(parsed("r/t,k,,\n,,,\n1,0.4,,,,\n").rows.size(), 1u);
}

TEST(ParseBendTable, KnowsTheNamesPeopleUse) {
  for (const char* header :
       {"Inside radius;Sheet thickness;K Factor", "inner_radius;THICKNESS;kfactor", "Ri;s;K",
        "R_mm;T_mm;K-Factor", "R mm;T mm;K (ANSI)",
        "Bend radius [mm];Material thickness [mm];k value"}) {
    const BendTable table = parsed(std::string(header) + "\n1;2;0.4\n");
    ASSERT_EQ(table.rows.size(), 1u) << header;
    EXPECT_FALSE(table.by_ratio) << header;
    expect_row(table.rows[0], 1, 2, 0, 0.4);
  }
}

TEST(ParseBendTable, SkipsColumnsOfOtherNames) {
  expect_row(parsed("Material,R,T,V-die,K,Note\nS235,1,2,16,0.4,\"soft, old\"\n").rows.at(0), 1, 2,
             0, 0.4);
}

TEST(ParseBendTable, ConvertsInchesRadiansAndOpeningAngles) {
  const BendTable table = parsed("R (in),T (inch),Angle (rad),BA (in)\n0.125,0.1,1.5,0.3\n");
  expect_row(table.rows.at(0), 3.175, 2.54, 1.5 * 180 / std::numbers::pi, 7.62);
  expect_row(parsed("R,T,Opening angle,K\n1,2,30,0.4\n").rows.at(0), 1, 2, 150, 0.4);
  expect_row(parsed("R,T,Included angle (rad),K\n1,2,0.5,0.4\n").rows.at(0), 1, 2,
             180 - 90 / std::numbers::pi, 0.4);
  expect_row(parsed("R,T,Angle (\xB0),K\n1,2,30,0.4\n").rows.at(0), 1, 2, 30, 0.4);
}

TEST(ParseBendTable, TurnsOtherFactorsIntoK) {
  expect_row(parsed("r/t,DIN k\n1,0.65\n").rows.at(0), 1, 0, 0, 0.325);
  expect_row(parsed("r/t,Y-factor\n1,0.5\n").rows.at(0), 1, 0, 0, 1 / std::numbers::pi);
}

TEST(ParseBendTable, UsesRadiusAndThicknessWhereTheRatioIsGivenToo) {
  EXPECT_FALSE(parsed("R,T,R/T,K\n1,2,0.5,0.4\n").by_ratio);
}

TEST(ParseBendTable, AllowsRepeatedEqualRows) {
  EXPECT_EQ(parsed("r/t,k\n1,0.4\n1,0.4\n").rows.size(), 2u);
}

TEST(ParseBendTable, RefusesTablesWithoutContent) {
  EXPECT_THAT(refusal("", "table.csv"), HasSubstr("empty"));
  EXPECT_THAT(refusal("\n# nothing\n\n", "table.csv"), HasSubstr("header"));
  EXPECT_THAT(refusal("\nr/t,k\n", "table.csv:2"), HasSubstr("no rows"));
}

TEST(ParseBendTable, RefusesHeadersThatDoNotNameABend) {
  EXPECT_THAT(refusal("1,0.4\n2,0.5\n", "table.csv:1"), HasSubstr("must name"));
  EXPECT_THAT(refusal("R,K\n1,0.4\n", "table.csv:1"), HasSubstr("R and T"));
  EXPECT_THAT(refusal("R,T\n1,2\n", "table.csv:1"), HasSubstr("K, BA, BD"));
  EXPECT_THAT(refusal("R,T,K,BD\n1,2,0.4,3\n", "table.csv:1"), HasSubstr("Keep one"));
  EXPECT_THAT(refusal("R,Radius,T,K\n1,1,2,0.4\n", "table.csv:1"),
              HasSubstr("\"R\" and \"Radius\""));
  EXPECT_THAT(refusal("R/T,BA\n1,3\n", "table.csv:1"), HasSubstr("lengths"));
  EXPECT_THAT(refusal("R/T,T,K\n1,2,0.4\n", "table.csv:1"), HasSubstr("R/T alone"));
}

TEST(ParseBendTable, RefusesUnitsItDoesNotKnow) {
  EXPECT_THAT(refusal("R (cm),T,K\n1,2,0.4\n", "table.csv:1"), HasSubstr("R (cm)"));
  EXPECT_THAT(refusal("R,T,Angle (mm),K\n1,2,90,0.4\n", "table.csv:1"), HasSubstr("Angle (mm)"));
  EXPECT_THAT(refusal("R/T,K (%)\n1,40\n", "table.csv:1"), HasSubstr("K (%)"));
}

TEST(ParseBendTable, RefusesRowsThatCannotBeRead) {
  EXPECT_THAT(refusal("r/t,k\n1,0.4\n2,abc\n", "table.csv:3"), HasSubstr("\"abc\" in column K"));
  EXPECT_THAT(refusal("r/t,k\n1 mm,0.4\n", "table.csv:2"), HasSubstr("units belong in the header"));
  EXPECT_THAT(refusal("r/t,k\n1,nan\n", "table.csv:2"), HasSubstr("not a number"));
  EXPECT_THAT(refusal("r/t,k\n\"1,000.5\",0.4\n", "table.csv:2"), HasSubstr("not a number"));
  EXPECT_THAT(refusal("r/t,k\n1\n", "table.csv:2"), HasSubstr("K is missing"));
  EXPECT_THAT(refusal("r/t,k\n,0.4\n", "table.csv:2"), HasSubstr("R/T is missing"));
}

TEST(ParseBendTable, CountsLinesThroughCommentsAndQuotedLineEnds) {
  EXPECT_THAT(refusal("# a\n\n\"r/\nt\",k\r\n1,0.4\r\n2,x\r\n", "table.csv:6"),
              HasSubstr("Line 6"));
}

TEST(ParseBendTable, TakesDecimalCommasBetweenCommasForTooManyFields) {
  EXPECT_THAT(refusal("R,T,K\n1,5,2,0,0,44\n", "table.csv:2"), HasSubstr("semicolons"));
}

TEST(ParseBendTable, RefusesValuesThatNoBendHas) {
  EXPECT_THAT(refusal("r/t,k\n1,1.01\n", "table.csv:2"), HasSubstr("between 0 and 1"));
  EXPECT_THAT(refusal("r/t,k\n1,-0.1\n", "table.csv:2"), HasSubstr("between 0 and 1"));
  EXPECT_THAT(refusal("r/t,k\n-1,0.4\n", "table.csv:2"), HasSubstr("R/T must not be negative"));
  EXPECT_THAT(refusal("r,t,k\n-1,2,0.4\n", "table.csv:2"), HasSubstr("R must not be negative"));
  EXPECT_THAT(refusal("r,t,k\n1,0,0.4\n", "table.csv:2"), HasSubstr("T must be positive"));
  EXPECT_THAT(refusal("r,t,angle,k\n1,1,0,0.4\n", "table.csv:2"), HasSubstr("angle"));
  EXPECT_THAT(refusal("r,t,angle,k\n1,1,360,0.4\n", "table.csv:2"), HasSubstr("angle"));
  EXPECT_THAT(refusal("r,t,ba\n1,1,-2\n", "table.csv:2"), HasSubstr("BA must not be negative"));
}

TEST(ParseBendTable, RefusesTwoValuesForOneBend) {
  const std::string message = refusal("material,r,t,k\nsteel,1,2,0.4\nsteel,2,2,0.4\nalu,1,2,0.3\n",
                                      "table.csv:4");
  EXPECT_THAT(message, HasSubstr("line 2 gives 0.4"));
  EXPECT_THAT(message, HasSubstr("one material"));
}

TEST(ParseBendTable, RefusesWhatIsNoText) {
  EXPECT_THAT(refusal(std::string("\xFF\xFEr\0/\0t\0", 8), "table.csv"), HasSubstr("UTF-8"));
  EXPECT_THAT(refusal("r/t,k\n1,\"0.4\n", "table.csv:2"), HasSubstr("quote"));
}

TEST(ParseBendTable, FeedsBendAllowance) {
  const auto bend = bend_allowance(parsed("r,t,angle,bd\n2,2,90,3.5\n"), 2.0, 2.0,
                                   Angle::degrees(90));
  ASSERT_TRUE(bend.has_value());
  EXPECT_NEAR(bend->deduction, 3.5, 1e-12);
  EXPECT_EQ(bend->source, "table table.csv, row 1 (R 2 mm, T 2 mm, 90°)");
}

}  // namespace
}  // namespace planish
