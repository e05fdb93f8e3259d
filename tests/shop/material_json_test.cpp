#include <planish/shop/material_json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::test {
namespace {

using shop::parse_material;
using testing::HasSubstr;

constexpr auto kLaw = R"({"power_law": {"strength": 500, "exponent": 0.2}})";

TEST(MaterialJson, ReadsCurvesOfBothKinds) {
  const auto read = parse_material(
      R"({"format": "planish/material", "version": 1, "name": "DC04",
          "tension": {"points": [[0.001, 210], [0.2, 350]]}, "compression": )" +
          std::string(kLaw) + "}",
      "folder/m.json");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->name, "DC04");
  const auto& points = std::get<MeasuredCurve>(read->tension).points;
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[1].strain, 0.2);
  EXPECT_EQ(points[1].stress, 350);
  EXPECT_EQ(std::get<PowerLaw>(read->compression).exponent, 0.2);
}

TEST(MaterialJson, TakesTensionForBothSidesAndTheFileForTheName) {
  const auto read = parse_material(R"({"tension": )" + std::string(kLaw) + "}", "folder/m.json");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->name, "m.json");
  EXPECT_EQ(plastic_k(*read, 1.0), 0.5);
}

TEST(MaterialJson, SaysWhereACurveIsWrong) {
  const auto refused = [](const std::string& tension) {
    const auto read = parse_material(R"({"tension": )" + tension + "}", "m.json");
    EXPECT_FALSE(read) << tension;
    return read ? Error{} : read.error();
  };
  EXPECT_EQ(refused(R"({"points": [[0.1, 200], [0.05, 300]]})").where, "m.json/tension/points/1");
  EXPECT_EQ(refused(R"({"points": [[0.1, 200], [0.05, 300], [0.2, 400]]})").where,
            "m.json/tension/points/1");
  EXPECT_EQ(refused(R"({"points": [[0, 200]]})").where, "m.json/tension/points");
  EXPECT_EQ(refused(R"({"points": [[0.1, -1]]})").where, "m.json/tension/points/0/1");
  EXPECT_EQ(refused(R"({"power_law": {"strength": 500, "exponent": 2}})").where,
            "m.json/tension/power_law/exponent");
  EXPECT_EQ(refused(R"({"power_law": {"strength": 500}})").where,
            "m.json/tension/power_law/exponent");
  EXPECT_EQ(refused("{}").where, "m.json/tension");
  EXPECT_EQ(parse_material("{}", "m.json").error().code, code::invalid_input);
}

}  // namespace
}  // namespace planish::test
