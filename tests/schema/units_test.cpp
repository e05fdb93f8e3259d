#include <planish/schema/units.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish::schema {
namespace {

const Units kMillimetre(LengthUnit::mm), kInch(LengthUnit::inch), kMetre(LengthUnit::m);

TEST(Units, ConvertLengthsAreasAndVolumes) {
  for (const auto& [units, mm] :
       {std::pair{&kMillimetre, 1.0}, std::pair{&kInch, 25.4}, std::pair{&kMetre, 1000.0}}) {
    EXPECT_DOUBLE_EQ(units->length(3.0 * mm), 3.0);
    EXPECT_DOUBLE_EQ(units->area(3.0 * mm * mm), 3.0);
    EXPECT_DOUBLE_EQ(units->volume(3.0 * mm * mm * mm), 3.0);
  }
}

TEST(Units, AreCalledInReportsAndByPeople) {
  EXPECT_EQ(kMillimetre.name(), "mm");
  EXPECT_EQ(kMillimetre.symbol(), "mm");
  EXPECT_EQ(kInch.name(), "inch");
  EXPECT_EQ(kInch.symbol(), "in");
  EXPECT_EQ(kMetre.name(), "m");
  EXPECT_EQ(kMetre.symbol(), "m");
}

TEST(Units, WriteLengthsToAMicrometreOrFiner) {
  for (const Units* units : {&kMillimetre, &kInch, &kMetre})
    for (const double mm : {0.001, 1.2345, 25.4, 1234.567})
      EXPECT_LE(std::abs(std::stod(units->length_text(mm)) - units->length(mm)),
                0.5 * units->length(0.0026))
          << mm;
  EXPECT_EQ(kMillimetre.length_text(100), "100.000");
  EXPECT_EQ(kMillimetre.length_text(-1e-5), "0.000");
  EXPECT_EQ(kMillimetre.length_text(-0.5), "-0.500");
  EXPECT_EQ(kMillimetre.area_text(-1e-5), "0.0");
  EXPECT_EQ(kInch.length_text(25.4), "1.0000");
  EXPECT_EQ(kMetre.length_text(1.0), "0.001000");
}

TEST(Units, WriteAreas) {
  EXPECT_EQ(kMillimetre.area_text(5921.46), "5921.5");
  EXPECT_EQ(kInch.area_text(25.4 * 25.4), "1.0000");
  EXPECT_EQ(kMetre.area_text(1e6), "1.000000");
}

TEST(Units, WriteNoZerosThatSayNothing) {
  EXPECT_EQ(kMillimetre.short_text(2.0), "2");
  EXPECT_EQ(kMillimetre.short_text(0.9784), "0.978");
  EXPECT_EQ(kInch.short_text(12.7), "0.5");
  EXPECT_EQ(kMillimetre.tiny_text(1.23e-13), "1.2e-13");
  EXPECT_EQ(kInch.tiny_text(2.54e-3), "0.0001");
  EXPECT_EQ(kMillimetre.tiny_text(0.0203), "0.02") << "no exponent where none is needed";
  EXPECT_EQ(kMillimetre.tiny_text(0.0), "0");
}

}  // namespace
}  // namespace planish::schema
