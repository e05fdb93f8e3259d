#include <planish/sheet/allowance.hpp>
#include <planish/sheet/material.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace planish::test {
namespace {

using testing::HasSubstr;

constexpr double kExact = 1e-12;
constexpr double kRatios[] = {0.0, 0.01, 0.5, 1.0, 3.0, 10.0, 1000.0};

StressStrain perfectly_plastic(double stress) {
  return MeasuredCurve{{{0.0, stress}, {1.0, stress}}};
}

TEST(PlasticK, IsHalfWhereBothSidesAreTheSame) {
  const MeasuredCurve curve{{{0.002, 210}, {0.1, 300}, {0.3, 360}}};
  for (const double ratio : kRatios) {
    EXPECT_NEAR(plastic_k({"m", curve, curve}, ratio), 0.5, kExact) << ratio;
    EXPECT_NEAR(plastic_k({"m", PowerLaw{500, 0.2}, PowerLaw{500, 0.2}}, ratio), 0.5, kExact);
  }
}

TEST(PlasticK, OfPerfectlyPlasticCurvesIsTheShareOfTension) {
  for (const double ratio : kRatios) {
    const MaterialCurves points{"m", perfectly_plastic(200), perfectly_plastic(300)};
    EXPECT_NEAR(plastic_k(points, ratio), 0.4, kExact) << ratio;
    EXPECT_NEAR(plastic_k({"m", PowerLaw{200, 0}, PowerLaw{300, 0}}, ratio), 0.4, kExact);
  }
}

TEST(PlasticK, OfPowerLawsWithOneExponentHasAClosedForm) {
  for (const double exponent : {0.1, 0.25, 1.0}) {
    const double k = 1 / (1 + std::pow(600.0 / 500.0, 1 / (exponent + 1)));
    for (const double ratio : kRatios)
      EXPECT_NEAR(plastic_k({"m", PowerLaw{500, exponent}, PowerLaw{600, exponent}}, ratio), k,
                  kExact);
  }
}

double stress_at(const StressStrain& curve, double strain) {
  if (const auto* law = std::get_if<PowerLaw>(&curve))
    return law->strength * std::pow(strain, law->exponent);
  MeasuredCurve::Point from;
  for (const auto& to : std::get<MeasuredCurve>(curve).points) {
    if (strain <= to.strain)
      return std::lerp(from.stress, to.stress, (strain - from.strain) / (to.strain - from.strain));
    from = to;
  }
  return from.stress;
}

/// The force across the sheet by the rule of midpoints, fibre by fibre from the inside, over the
/// force of one side.
double net_force(const MaterialCurves& material, double k, double ratio) {
  constexpr int kFibres = 400'000;
  double net = 0.0, all = 0.0;
  for (int i = 0; i < kFibres; ++i) {
    const double y = (i + 0.5) / kFibres - k;
    const double strain = y / (ratio + k);
    const double stress = strain > 0 ? stress_at(material.tension, strain)
                                     : -stress_at(material.compression, -strain);
    net += stress;
    all += std::abs(stress);
  }
  return net / all;
}

TEST(PlasticK, LeavesNoForceAcrossTheSheet) {
  const MaterialCurves material{"m", MeasuredCurve{{{0.002, 210}, {0.05, 280}, {0.25, 350}}},
                                PowerLaw{560, 0.18}};
  double before = 0.0;
  for (const double ratio : {0.5, 1.0, 3.0, 10.0}) {
    const double k = plastic_k(material, ratio);
    EXPECT_NEAR(net_force(material, k, ratio), 0.0, 1e-5) << ratio;
    EXPECT_GT(std::abs(net_force(material, k + 0.001, ratio)), 1e-4);
    EXPECT_NE(k, before) << "it depends on the radius";
    before = k;
  }
}

TEST(WorkOf, IsTheAreaUnderTheCurve) {
  const MeasuredCurve curve{{{0.1, 200}, {0.1, 300}, {0.3, 400}}};  // with a step
  EXPECT_NEAR(work_of(curve, 0.05), 0.05 * 100 / 2, kExact);
  EXPECT_NEAR(work_of(curve, 0.1), 10, kExact);
  EXPECT_NEAR(work_of(curve, 0.2), 10 + 0.1 * 325, kExact);
  EXPECT_NEAR(work_of(curve, 0.5), 10 + 70 + 0.2 * 400, kExact);
  EXPECT_NEAR(work_of(PowerLaw{500, 0.25}, 0.16), 500 * std::pow(0.16, 1.25) / 1.25, kExact);
}

TEST(MaterialAllowance, NamesItsSourceAndStrainsBeyondTheCurve) {
  const MaterialCurves material{"DC04", MeasuredCurve{{{0.002, 210}, {0.3, 350}}},
                                PowerLaw{500, 0.2}};
  const auto wide = bend_allowance(material, 1.0, 5.0, Angle::degrees(90));
  ASSERT_TRUE(wide);
  EXPECT_EQ(wide->source, "material DC04");
  EXPECT_NEAR(wide->k_factor, plastic_k(material, 5.0), kExact);
  const auto tight = bend_allowance(material, 1.0, 0.5, Angle::degrees(90));
  ASSERT_TRUE(tight);
  EXPECT_THAT(tight->source, HasSubstr("material DC04, tension held from strain 0.3 to 0."));
}

TEST(MaterialAllowance, TakesCurvesInAnyUnitOfStress) {
  // In GPa below 1: only the ratios count.
  const auto k = [](const StressStrain& curve) {
    const auto found = bend_allowance(MaterialCurves{"m", curve, curve}, 1.0, 1.0,
                                      Angle::degrees(90));
    return found ? found->k_factor : 0.0;
  };
  EXPECT_NEAR(k(PowerLaw{0.5, 0.2}), 0.5, kExact);
  EXPECT_NEAR(k(MeasuredCurve{{{0.002, 0.21}, {0.9, 0.35}}}), 0.5, kExact);
}

TEST(MaterialAllowance, RefusesCurvesThatAreNone) {
  for (const StressStrain& wrong :
       {StressStrain(MeasuredCurve{}), StressStrain(MeasuredCurve{{{0.1, 0.0}}}),
        StressStrain(MeasuredCurve{{{0.2, 100}, {0.1, 200}}}),
        StressStrain(MeasuredCurve{{{0.1, std::nan("")}}}), StressStrain(PowerLaw{0, 0.2}),
        StressStrain(PowerLaw{500, -0.1}), StressStrain(PowerLaw{500, 1.1})}) {
    const auto refused = bend_allowance(MaterialCurves{"m", PowerLaw{500, 0.2}, wrong}, 1.0, 1.0,
                                        Angle::degrees(90));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, code::bad_option);
    EXPECT_THAT(refused.error().message, HasSubstr("of m for compression"));
  }
}

}  // namespace
}  // namespace planish::test
