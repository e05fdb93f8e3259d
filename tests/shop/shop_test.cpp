#include <planish/geometry/curve.hpp>
#include <planish/sheet/allowance.hpp>
#include <planish/shop/shop.hpp>
#include <planish/shop/tools_json.hpp>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

namespace planish::shop {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

/// A profile of one material with these gauges.
std::string profile(const std::string& gauges, const std::string& more = "") {
  return fmt::format(R"({{"materials": [{{"name": "steel", "gauges": [{}]}}]{}}})", gauges, more);
}

Shop parsed(const std::string& json) {
  const auto shop = parse_shop(json, "shop.json");
  EXPECT_TRUE(shop) << shop.error().where << ": " << shop.error().message;
  return shop.value_or(Shop());
}

double k_of(const std::string& gauge) {
  return parsed(profile(gauge)).materials.at(0).gauges.at(0).k_factor;
}

Error error_of(const std::string& json) {
  const auto shop = parse_shop(json, "shop.json");
  EXPECT_FALSE(shop) << json;
  return shop ? Error{} : shop.error();
}

constexpr auto kTwo = R"({"thickness": 2, "inside_radius": 2, "k": 0.4})";

TEST(ParseShop, TurnsTheDeductionOfDin6935IntoItsK) {
  // R = T = 2 at 90°: the standard's factor 0.65 refers to T/2. Flat length 96.1626 of two legs
  // of 50.
  constexpr double kFlat = 96.1626;
  EXPECT_NEAR(k_of(fmt::format(R"({{"thickness": 2, "inside_radius": 2, "deduction": {}}})",
                               100.0 - kFlat)),
              0.325, 2e-5);
}

TEST(ParseShop, TurnsTheAllowanceIntoK) {
  // BA = α (R + K T), here 60° · (3 + 0.35 · 1.5).
  EXPECT_NEAR(k_of(fmt::format(
                  R"({{"thickness": 1.5, "inside_radius": 3, "allowance": {:.15g}, "angle": 60}})",
                  pi / 3.0 * (3.0 + 0.35 * 1.5))),
              0.35, 1e-12);
}

TEST(ParseShop, MeasuresDeductionsBeyondARightAngleAsTheProfileSays) {
  // R = T = 2, 120°, K = 0.4: setbacks 4 tan 60° to the mould line, 4 to the tangent plane.
  const double allowance = 2.0 * pi / 3.0 * (2.0 + 0.4 * 2.0);
  const auto gauge = [](double deduction, const char* to) {
    return fmt::format(
        R"({{"thickness": 2, "inside_radius": 2, "deduction": {:.15g}, "angle": 120{}}})",
        deduction, to);
  };
  const double to_line = 8.0 * std::tan(pi / 3.0) - allowance, to_plane = 8.0 - allowance;
  EXPECT_NEAR(k_of(gauge(to_line, "")), 0.4, 1e-12);
  EXPECT_NEAR(k_of(gauge(to_line, R"(, "deduction_to": "mould_line")")), 0.4, 1e-12);
  EXPECT_NEAR(k_of(gauge(to_plane, R"(, "deduction_to": "tangent_plane")")), 0.4, 1e-12);
  // The other reading is 5.9 mm off, and no K gives it.
  EXPECT_THAT(error_of(profile(gauge(to_plane, ""))).message, HasSubstr("K must be from 0 to 1"));
}

TEST(ParseShop, ReadsLengthsInItsUnit) {
  const Shop shop = parsed(profile(
      R"({"thickness": 0.125, "inside_radius": 0.1, "k": 0.4, "smallest_flange": 0.5})",
      R"(, "units": "inch", "thickness_tolerance": 0.002, "limits": {"sheet": [48, 120]})"));
  const Gauge& gauge = shop.materials.at(0).gauges.at(0);
  EXPECT_DOUBLE_EQ(gauge.thickness, 3.175);
  EXPECT_DOUBLE_EQ(gauge.inside_radius, 2.54);
  EXPECT_DOUBLE_EQ(gauge.smallest_flange.value(), 12.7);
  EXPECT_DOUBLE_EQ(shop.thickness_tolerance, 0.0508);
  EXPECT_NEAR((shop.limits.sheet.value() - Vec2(3048.0, 1219.2)).norm(), 0.0, 1e-9);
}

TEST(ParseShop, ReadsTheExample) {
  std::ifstream file(PLANISH_SOURCE_DIR "/examples/shop/example.json");
  std::stringstream text;
  text << file.rdbuf();
  const Shop shop = parsed(text.str());
  EXPECT_EQ(shop.name, "Example laser shop");
  ASSERT_EQ(shop.materials.size(), 2u);
  // 3.84 = 8 − π/2 · (2 + K · 2)
  EXPECT_NEAR(shop.materials[0].gauges[2].k_factor, ((8.0 - 3.84) / (pi / 2.0) - 2.0) / 2.0, 1e-12);
  ASSERT_TRUE(shop.layers);
  EXPECT_EQ(shop.layers->outer, "CUT");
  EXPECT_EQ(shop.layers->slits, shop.layers->openings) << "all that is cut within the part";
  EXPECT_EQ(shop.layers->bend_zone, layer_names(LayerProfile::standard).bend_zone);
}

TEST(ParseShop, TakesToolsOfTheCatalogueByName) {
  const BrakeTools& known = default_tools();
  const std::string die = known.dies.at(1).id;
  const Shop shop = parsed(profile(kTwo, fmt::format(R"(, "tools": {{"dies": ["{}"]}})", die)));
  ASSERT_TRUE(shop.tools);
  ASSERT_EQ(shop.tools->dies.size(), 1u);
  EXPECT_EQ(shop.tools->dies[0].id, die);
  EXPECT_EQ(shop.tools->punches.size(), known.punches.size());
}

TEST(ParseShop, SaysWhatIsWrongAndWhere) {
  const struct {
    std::string json, where, message;
  } rows[] = {
      {"{", "shop.json:1:1", "is not JSON"},
      {R"({"materials": []})", "/materials", "a list of 1 to 1000 materials"},
      {profile(R"({"thickness": 0, "inside_radius": 2, "k": 0.4})"), "/gauges/0/thickness",
       "above 0"},
      {profile(R"({"thickness": 2, "inside_radius": 2})"), "/materials/0/gauges/0",
       "exactly one of k, deduction and allowance"},
      {profile(R"({"thickness": 2, "inside_radius": 2, "k": 0.4, "deduction": 3})"),
       "/materials/0/gauges/0", "exactly one of"},
      {profile(R"({"thickness": 2, "inside_radius": 2, "k": 1.2})"), "/gauges/0/k", "from 0 to 1"},
      {profile(R"({"thickness": 2, "inside_radius": 2, "deduction": 9})"), "/gauges/0/deduction",
       "gives a K-factor of"},
      {profile(R"({"thickness": 2, "inside_radius": 2, "radius": 2, "k": 0.4})"),
       "/gauges/0/radius", ""},
      {profile(std::string(kTwo) + ", " + R"({"thickness": 2.04, "inside_radius": 2, "k": 0.4})"),
       "/gauges/1/thickness", "too close to the gauge of 2 mm"},
      {R"({"materials": [{"name": "A", "gauges": [{"thickness": 2, "inside_radius": 2, "k": 0.4}]},
           {"name": "a", "gauges": [{"thickness": 2, "inside_radius": 2, "k": 0.4}]}]})",
       "/materials/1/name", "the name of another material"},
      {profile(kTwo, R"(, "dxf": {"layers": {"outer": "CUT", "bend_up": "CUT"}})"), "/dxf/layers",
       "\"CUT\""},
      {profile(kTwo, R"(, "dxf": {"layers": {"outer": "CUT/1"}})"), "/dxf/layers/outer",
       "cannot be the name of a layer"},
      {profile(kTwo, R"(, "dxf": {"bend_lines": "dotted"})"), "/dxf/bend_lines", "dashed"},
      {profile(kTwo, R"(, "rules": {"k_low": 0.6})"), "/rules", "above k_high"},
      {profile(kTwo, R"(, "rules": {"flange": 3})"), "/rules/flange", ""},
      {profile(kTwo, R"(, "limits": {"sheet": [3000]})"), "/limits/sheet", "a size"},
      {profile(kTwo, R"(, "tools": {"dies": ["V7"]})"), "/tools/dies/0", "not a built-in tool"},
      {profile(kTwo, R"(, "tools": {"punches": []})"), "/tools/punches", "must name a tool"},
  };
  for (const auto& row : rows) {
    const Error error = error_of(row.json);
    EXPECT_EQ(error.code, code::invalid_input) << row.json;
    EXPECT_THAT(error.where, HasSubstr(row.where)) << error.message;
    EXPECT_THAT(error.message, HasSubstr(row.message)) << error.where;
  }
}

TEST(GaugeOf, IsTheNearestWithinTheTolerance) {
  const std::string three = R"({"thickness": 3, "inside_radius": 3, "k": 0.42})";
  ShopChoice choice{.shop = parsed(profile(std::string(kTwo) + ", " + three)), .material = 0};
  ASSERT_TRUE(gauge_of(choice, 2.04));
  EXPECT_DOUBLE_EQ(gauge_of(choice, 2.04)->thickness, 2.0);
  EXPECT_DOUBLE_EQ(gauge_of(choice, 2.95)->thickness, 3.0);
  EXPECT_FALSE(gauge_of(choice, 2.06));
  EXPECT_FALSE(gauge_of(choice, 1.9));
  EXPECT_DOUBLE_EQ(shop_k(choice, 3.0).k, 0.42);
  EXPECT_THAT(shop_k(choice, 3.0).source, HasSubstr("steel 3 mm"));
  EXPECT_EQ(shop_k(choice, 2.5).source, ConstantK{}.source);
}

}  // namespace
}  // namespace planish::shop
