#include <planish/sheet/allowance.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish {
namespace {

using testing::HasSubstr;

using std::numbers::pi;
const Angle kRight = Angle::degrees(90);

BendAllowance allowance_of(const AllowanceRule& rule, double thickness, double radius,
                           Angle angle) {
  const auto result = bend_allowance(rule, thickness, radius, angle);
  EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().message);
  return result.value_or(BendAllowance{});
}

// ---- constant K

TEST(ConstantAllowance, IsTheArcOfTheNeutralSurface) {
  const BendAllowance bend = allowance_of(ConstantK{0.44, "default"}, 2.0, 2.0, kRight);
  EXPECT_DOUBLE_EQ(bend.k_factor, 0.44);
  EXPECT_DOUBLE_EQ(bend.allowance, pi / 2 * 2.88);
  EXPECT_DOUBLE_EQ(bend.deduction, 2 * 4.0 - pi / 2 * 2.88);
  EXPECT_EQ(bend.source, "default");
}

TEST(ConstantAllowance, GrowsLinearlyWithAngle) {
  const double quarter = allowance_of(ConstantK{0.4}, 1.5, 3.0, kRight).allowance;
  EXPECT_NEAR(allowance_of(ConstantK{0.4}, 1.5, 3.0, Angle::degrees(270)).allowance, 3 * quarter,
              1e-12);
  EXPECT_EQ(allowance_of(ConstantK{0.4}, 1.5, 3.0, Angle()).allowance, 0.0);
}

TEST(ConstantAllowance, OfASharpBendIsThatOfTheNeutralSurfaceAlone) {
  EXPECT_DOUBLE_EQ(allowance_of(ConstantK{0.5}, 2.0, 0.0, kRight).allowance, pi / 2);
}

TEST(ConstantAllowance, AcceptsTheEndsOfTheRange) {
  EXPECT_EQ(allowance_of(ConstantK{0.0}, 1.0, 1.0, kRight).k_factor, 0.0);
  EXPECT_EQ(allowance_of(ConstantK{1.0}, 1.0, 1.0, kRight).k_factor, 1.0);
}

TEST(ConstantAllowance, RefusesKOutsideTheSheet) {
  for (const double k : {-0.01, 1.01, std::nan(""), HUGE_VAL}) {
    const auto result = bend_allowance(ConstantK{k, "--k"}, 2.0, 2.0, kRight);
    ASSERT_FALSE(result.has_value()) << k;
    EXPECT_EQ(result.error().code, code::bad_option);
    EXPECT_THAT(result.error().message, HasSubstr("--k"));
  }
}

TEST(BendAllowance, RefusesSizesThatNoBendHas) {
  const double nan = std::nan("");
  EXPECT_FALSE(bend_allowance(ConstantK{}, 0.0, 1.0, kRight).has_value());
  EXPECT_FALSE(bend_allowance(ConstantK{}, -1.0, 1.0, kRight).has_value());
  EXPECT_FALSE(bend_allowance(ConstantK{}, nan, 1.0, kRight).has_value());
  EXPECT_FALSE(bend_allowance(ConstantK{}, 1.0, -1e-3, kRight).has_value());
  EXPECT_FALSE(bend_allowance(ConstantK{}, 1.0, nan, kRight).has_value());
  EXPECT_FALSE(bend_allowance(ConstantK{}, 1.0, 1.0, Angle::degrees(-1)).has_value());
  EXPECT_FALSE(bend_allowance(ConstantK{}, 1.0, 1.0, Angle::radians(nan)).has_value());
  EXPECT_EQ(bend_allowance(ConstantK{}, 0.0, 1.0, kRight).error().code, code::bad_option);
}

// ---- setback and deduction

TEST(OutsideSetback, ReachesTheOuterMouldLineBelow180) {
  EXPECT_NEAR(outside_setback(3.0, 2.0, kRight), 5.0, 1e-12);
  EXPECT_NEAR(outside_setback(3.0, 2.0, Angle::degrees(60)), 5.0 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(outside_setback(3.0, 2.0, Angle::degrees(120)), 5.0 * std::sqrt(3.0), 1e-12);
}

TEST(OutsideSetback, ReachesTheTangentPlaneFrom180On) {
  EXPECT_EQ(outside_setback(3.0, 2.0, Angle::degrees(180)), 5.0);
  EXPECT_EQ(outside_setback(3.0, 2.0, Angle::degrees(270)), 5.0);
  EXPECT_EQ(outside_setback(3.0, 2.0, Angle::radians(pi - 1e-9)), 5.0)
      << "a hem with the noise of a CAD file";
}

TEST(BendAllowance, DeductionTakenFromOutsideLegsGivesTheFlatLength) {
  // Two legs of flat length 20 and 30; their outside lengths end at the outer mould line.
  for (const double degrees : {10.0, 45.0, 90.0, 135.0, 170.0}) {
    const BendAllowance bend = allowance_of(ConstantK{0.4}, 2.0, 3.0, Angle::degrees(degrees));
    const double setback = 5.0 * std::tan(degrees * pi / 360.0);
    EXPECT_NEAR((20 + setback) + (30 + setback) - bend.deduction, 50 + bend.allowance, 1e-10)
        << degrees;
  }
}

// ---- DIN 6935, test vectors of shop-floor.md#din-6935-vectors

struct DinRow {
  double ratio, k, allowance, compensation;
};

/// DIN 6935 compensation v, by opening angle β = 180° − α: flat length = sum of both legs,
/// measured outside, + v. v = BA − 2 (r + t) for β ≤ 90° (legs to the tangent plane), BA −
/// 2 (r + t) tan(α/2) above (legs to the outer mould line).
double compensation(double r, double t, Angle opening) {
  const BendAllowance bend = allowance_of(Din6935{}, t, r, Angle::degrees(180) - opening);
  return opening <= kRight ? bend.allowance - 2.0 * (r + t) : -bend.deduction;
}

class Din6935Vectors : public testing::TestWithParam<DinRow> {};

TEST_P(Din6935Vectors, HoldAt90DegreesForAnyThickness) {
  constexpr double kPrinted = 0.5e-4 * 1.001;  // the vectors have four decimals
  const DinRow row = GetParam();
  for (const double t : {1.0, 0.8, 12.0}) {
    const double r = row.ratio * t;
    EXPECT_NEAR(din6935_k(r, t), row.k, kPrinted);
    EXPECT_NEAR(compensation(r, t, kRight) / t, row.compensation, kPrinted);
    const BendAllowance bend = allowance_of(Din6935{}, t, r, kRight);
    EXPECT_NEAR(bend.allowance / t, row.allowance, kPrinted);
    EXPECT_NEAR(bend.k_factor, row.k / 2, kPrinted);
    EXPECT_NEAR(-bend.deduction / t, row.compensation, kPrinted);
    EXPECT_EQ(bend.source, "DIN 6935");
  }
}

INSTANTIATE_TEST_SUITE_P(Shopfloor, Din6935Vectors,
                         testing::Values(DinRow{0.5, 0.4995, 1.1777, -1.8223},
                                         DinRow{1, 0.65, 2.0813, -1.9187},
                                         DinRow{2, 0.8005, 3.7703, -2.2297},
                                         DinRow{3, 0.8886, 5.4103, -2.5897},
                                         DinRow{5, 1.0, 8.6394, -3.3606}));

TEST(Din6935, FlatLengthOfTwoLegsOf50) {
  EXPECT_NEAR(50 + 50 + compensation(2.0, 2.0, kRight), 96.1626, 0.5e-4);
}

TEST(Din6935, CompensationByOpeningAngle) {
  // The vectors have three or four decimals.
  EXPECT_NEAR(compensation(3.0, 2.0, Angle::degrees(45)), -1.1924, 0.5e-4);
  EXPECT_NEAR(compensation(3.0, 2.0, Angle::degrees(90)), -4.1283, 0.5e-4);
  EXPECT_NEAR(compensation(3.0, 2.0, Angle::degrees(120)), -1.859, 0.5e-3);
  EXPECT_NEAR(compensation(3.0, 2.0, Angle::degrees(150)), -0.7223, 0.5e-4);
}

TEST(Din6935, CompensationIsContinuousAt90DegreesAndVanishesWhenFlat) {
  const double below = compensation(3.0, 2.0, Angle::degrees(90 - 1e-9));
  const double above = compensation(3.0, 2.0, Angle::degrees(90 + 1e-9));
  EXPECT_NEAR(below, above, 1e-8);
  EXPECT_NEAR(compensation(3.0, 2.0, Angle::degrees(180)), 0.0, 1e-12);
}

TEST(Din6935, UpTo90DegreesCompensationIsTheNegativeDeduction) {
  for (const double bend_angle : {15.0, 30.0, 60.0, 90.0}) {
    const double deduction = allowance_of(Din6935{}, 2.0, 3.0, Angle::degrees(bend_angle))
                                 .deduction;
    EXPECT_NEAR(compensation(3.0, 2.0, Angle::degrees(180 - bend_angle)), -deduction, 1e-12);
  }
}

TEST(Din6935, KStaysBetween0And1) {
  EXPECT_EQ(din6935_k(0.0, 2.0), 0.0);
  EXPECT_EQ(din6935_k(0.05 * 2.0, 2.0), 0.0);
  EXPECT_GT(din6935_k(0.051 * 2.0, 2.0), 0.0);
  EXPECT_LT(din6935_k(4.999, 1.0), 1.0);
  EXPECT_EQ(din6935_k(100.0, 1.0), 1.0);
}

TEST(Din6935, SourceSaysWhenKIsHeldAt0) {
  EXPECT_THAT(allowance_of(Din6935{}, 2.0, 0.0, kRight).source, HasSubstr("held at 0"));
}

// ---- tables of K by R/T

BendTable by_ratio() {
  BendTable table;
  table.rows = {{1.0, 0, 0, 0.30}, {2.0, 0, 0, 0.40}, {5.0, 0, 0, 0.46}};
  table.name = "steel.csv";
  return table;
}

TEST(RatioTable, IsInterpolatedBetweenRows) {
  const BendAllowance bend = allowance_of(by_ratio(), 2.0, 3.0, kRight);
  EXPECT_NEAR(bend.k_factor, 0.35, 1e-15);
  EXPECT_NEAR(bend.allowance, pi / 2 * (3.0 + 0.35 * 2.0), 1e-14);
  EXPECT_EQ(bend.source, "table steel.csv, rows 1 and 2 (R/T 1.5)");
}

TEST(RatioTable, GivesItsRowsExactly) {
  const BendAllowance bend = allowance_of(by_ratio(), 2.0, 4.0, kRight);
  EXPECT_EQ(bend.k_factor, 0.40);
  EXPECT_EQ(bend.source, "table steel.csv, row 2 (R/T 2)");
}

TEST(RatioTable, IsConstantOutsideItsRows) {
  const BendAllowance low = allowance_of(by_ratio(), 2.0, 0.0, kRight);
  EXPECT_EQ(low.k_factor, 0.30);
  EXPECT_EQ(low.source, "table steel.csv, row 1 (R/T 0, held constant beyond the table)");
  EXPECT_EQ(allowance_of(by_ratio(), 2.0, 100.0, kRight).k_factor, 0.46);
}

TEST(RatioTable, NeedsNoOrderOfRows) {
  BendTable shuffled = by_ratio();
  std::swap(shuffled.rows[0], shuffled.rows[2]);
  for (double radius = 0.0; radius < 12.0; radius += 0.37)
    EXPECT_EQ(allowance_of(shuffled, 2.0, radius, kRight).k_factor,
              allowance_of(by_ratio(), 2.0, radius, kRight).k_factor);
}

TEST(RatioTable, DependsOnTheRatioOnly) {
  EXPECT_NEAR(allowance_of(by_ratio(), 1.0, 1.7, kRight).k_factor,
              allowance_of(by_ratio(), 3.0, 5.1, kRight).k_factor, 1e-15);
}

TEST(RatioTable, OfOneRowIsAConstant) {
  BendTable table;
  table.rows = {{1.0, 0, 0, 0.42}};
  EXPECT_EQ(allowance_of(table, 2.0, 9.0, kRight).k_factor, 0.42);
}

TEST(RatioTable, CannotHoldLengths) {
  BendTable table = by_ratio();
  table.value = BendTable::Value::deduction;
  const auto result = bend_allowance(table, 2.0, 3.0, kRight);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, code::bad_option);
}

TEST(AnyTable, WithoutRowsIsRefused) {
  const auto result = bend_allowance(BendTable{}, 2.0, 3.0, kRight);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, code::bad_option);
}

// ---- tables by radius, thickness, angle

BendTable by_size(BendTable::Value value, bool by_angle, std::vector<BendTable::Row> rows) {
  return {value, false, by_angle, std::move(rows), "t.csv"};
}

TEST(SizeTable, PrefersItsOwnThickness) {
  const BendTable table = by_size(BendTable::Value::k_factor, false,
                                  {{1, 1, 0, 0.30}, {1, 2, 0, 0.40}, {1, 3, 0, 0.20}});
  EXPECT_EQ(allowance_of(table, 2.0, 1.0, kRight).k_factor, 0.40);
  EXPECT_EQ(allowance_of(table, 2.0 * (1 + 4e-7), 1.0, kRight).k_factor, 0.40)
      << "agrees within 1e-6";
}

TEST(SizeTable, IsInterpolatedBetweenThicknessesEachAtItsOwnRadii) {
  const BendTable table = by_size(BendTable::Value::k_factor, false,
                                  {{1, 1, 0, 0.30}, {3, 1, 0, 0.40}, {2, 2, 0, 0.20}});
  // T 1: K(R 2) = 0.35 between its rows; T 2: 0.20; half-way: 0.275.
  const BendAllowance bend = allowance_of(table, 1.5, 2.0, kRight);
  EXPECT_NEAR(bend.k_factor, 0.275, 1e-15);
  EXPECT_EQ(bend.source, "table t.csv, rows 1, 2 and 3 (R 2 mm, T 1.5 mm)");
}

TEST(SizeTable, IsTrilinearOnAGrid) {
  // K = 0.1 + 0.02 T + 0.001 angle + 0.03 R is linear in each, so a trilinear reading is exact.
  const auto k = [](double t, double a, double r) { return 0.1 + 0.02 * t + 0.001 * a + 0.03 * r; };
  std::vector<BendTable::Row> rows;
  for (const double t : {1.0, 2.0, 4.0})
    for (const double a : {30.0, 90.0, 135.0})
      for (const double r : {0.5, 2.0})
        rows.push_back({r, t, a, k(t, a, r)});
  const BendTable table = by_size(BendTable::Value::k_factor, true, rows);
  EXPECT_NEAR(allowance_of(table, 1.3, 1.1, Angle::degrees(47)).k_factor, k(1.3, 47, 1.1), 1e-14);
  EXPECT_NEAR(allowance_of(table, 3.9, 1.9, Angle::degrees(134)).k_factor, k(3.9, 134, 1.9), 1e-14);
  EXPECT_NEAR(allowance_of(table, 9.0, 0.1, Angle::degrees(5)).k_factor, k(4, 30, 0.5), 1e-14)
      << "constant outside";
}

TEST(AllowanceTable, GivesBackItsRows) {
  const BendTable table = by_size(BendTable::Value::allowance, true,
                                  {{2, 2, 90, 4.6}, {2, 2, 45, 2.2}});
  EXPECT_NEAR(allowance_of(table, 2.0, 2.0, kRight).allowance, 4.6, 1e-12);
  EXPECT_NEAR(allowance_of(table, 2.0, 2.0, Angle::degrees(45)).allowance, 2.2, 1e-12);
}

TEST(AllowanceTable, IsLinearInTheRadius) {
  const BendTable table = by_size(BendTable::Value::allowance, false,
                                  {{1, 2, 0, 3.0}, {3, 2, 0, 6.4}});
  EXPECT_NEAR(allowance_of(table, 2.0, 2.0, kRight).allowance, 4.7, 1e-12);
}

TEST(AllowanceTable, WithoutAnglesIsOf90DegreeBends) {
  const double k = 0.42;
  const BendTable table = by_size(BendTable::Value::allowance, false,
                                  {{2, 2, 0, pi / 2 * (2 + k * 2)}});
  EXPECT_NEAR(allowance_of(table, 2.0, 2.0, Angle::degrees(30)).k_factor, k, 1e-12);
  EXPECT_NEAR(allowance_of(table, 2.0, 2.0, Angle::degrees(30)).allowance, pi / 6 * (2 + k * 2),
              1e-12);
}

TEST(DeductionTable, GivesBackItsRows) {
  const BendTable table = by_size(BendTable::Value::deduction, true,
                                  {{2, 2, 90, 3.5}, {2, 2, 135, 12.5}, {2, 2, 180, -1.0}});
  EXPECT_NEAR(allowance_of(table, 2.0, 2.0, kRight).deduction, 3.5, 1e-12);
  EXPECT_NEAR(allowance_of(table, 2.0, 2.0, Angle::degrees(135)).deduction, 12.5, 1e-12);
  EXPECT_NEAR(allowance_of(table, 2.0, 2.0, Angle::degrees(180)).deduction, -1.0, 1e-12);
}

TEST(DeductionTable, OfOneKGivesThatKBetweenItsRows) {
  // BD is far from linear in the angle: read as lengths, 112.5° would be wrong by a millimetre.
  std::vector<BendTable::Row> rows;
  for (const double degrees : {45.0, 90.0, 135.0, 180.0}) {
    const Angle angle = Angle::degrees(degrees);
    rows.push_back(
        {2, 2, degrees, 2 * outside_setback(2, 2, angle) - angle.radians() * (2 + 0.44 * 2)});
  }
  const BendTable table = by_size(BendTable::Value::deduction, true, rows);
  for (const double degrees : {30.0, 60.0, 112.5, 170.0, 180.0, 200.0})
    EXPECT_NEAR(allowance_of(table, 2.0, 2.0, Angle::degrees(degrees)).k_factor, 0.44, 1e-12)
        << degrees;
}

TEST(DeductionTable, SaysWhichReadingIsUsedBeyond90) {
  const BendTable table = by_size(BendTable::Value::deduction, true,
                                  {{2, 2, 90, 3.5}, {2, 2, 135, 12.5}, {2, 2, 180, -1.0}});
  EXPECT_EQ(allowance_of(table, 2.0, 2.0, kRight).source,
            "table t.csv, row 1 (R 2 mm, T 2 mm, 90°)");
  EXPECT_THAT(allowance_of(table, 2.0, 2.0, Angle::degrees(100)).source,
              HasSubstr("BD to the outer mould line"));
  EXPECT_THAT(allowance_of(table, 2.0, 2.0, Angle::degrees(180)).source,
              HasSubstr("tangent plane"));
}

TEST(DeductionTable, OfAnImpossibleLengthIsRefusedWithItsRow) {
  const BendTable table = by_size(BendTable::Value::deduction, false, {{2, 2, 0, 30.0}});
  const auto result = bend_allowance(table, 2.0, 2.0, kRight);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, code::bad_option);
  EXPECT_THAT(result.error().message, HasSubstr("row 1"));
}

TEST(AllowanceTable, MayHaveKAtTheSkinDespiteRounding) {
  const BendTable outer = by_size(BendTable::Value::allowance, true,
                                  {{0.3, 0.7, 33, 33 * pi / 180 * (0.3 + 0.7)}});
  EXPECT_NEAR(allowance_of(outer, 0.7, 0.3, Angle::degrees(33)).k_factor, 1.0, 1e-12);
  const BendTable inner = by_size(BendTable::Value::allowance, true,
                                  {{0.3, 0.7, 33, 33 * pi / 180 * 0.3}});
  EXPECT_NEAR(allowance_of(inner, 0.7, 0.3, Angle::degrees(33)).k_factor, 0.0, 1e-12);
}

}  // namespace
}  // namespace planish
