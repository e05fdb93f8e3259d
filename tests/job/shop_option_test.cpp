#include <planish/job/options.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace planish::job {
namespace {

using testing::HasSubstr;

constexpr auto kWhole = R"({"name": "S",
  "materials": [{"name": "Steel", "density": 7.8, "tensile_strength": 500,
                 "gauges": [{"thickness": 2, "inside_radius": 2, "k": 0.4}]}],
  "dxf": {"layers": {"outer": "CUT"}, "bend_lines": "continuous", "release": "r12"},
  "rules": {"opening_to_bend_t": 3, "strict": true}})";
constexpr auto kTwoMaterials = R"({"name": "S", "materials": [
  {"name": "Steel", "density": 7.8, "gauges": [{"thickness": 2, "inside_radius": 2, "k": 0.4}]},
  {"name": "brass", "density": 8.5, "gauges": [{"thickness": 2, "inside_radius": 2, "k": 0.3}]}]})";

/// The options as texts; `shop` is the content of the profile.
Result<Request> entered(const std::string& shop,
                        const std::vector<std::pair<const char*, const char*>>& others = {}) {
  OptionValues values;
  for (const auto& [name, text] : others)
    EXPECT_TRUE(values.set_text(option(name), text));
  values.set(option("shop"), OptionFile{"shop.json", shop});
  Request request;
  if (auto done = values.enter(request); !done) return tl::unexpected(done.error());
  return request;
}

TEST(ShopOption, AppliesAllOfIt) {
  const Request request = entered(kWhole).value();
  ASSERT_TRUE(request.shop);
  EXPECT_EQ(request.shop->chosen().name, "Steel");
  EXPECT_EQ(request.dxf.layers->outer, "CUT");
  EXPECT_EQ(request.dxf.bend_linetype, BendLinetype::continuous);
  EXPECT_EQ(request.dxf.version, DxfVersion::r12);
  EXPECT_EQ(request.rules.opening_to_bend_t, 3.0);
  EXPECT_TRUE(request.rules.strict);
  EXPECT_EQ(request.density, 7.8);
  EXPECT_EQ(request.bending.plan.tensile_strength, 500.0);
  EXPECT_FALSE(request.allowance);  // follows from the thickness of the sheet
}

TEST(ShopOption, GivesWayToSingleOptions) {
  const Request request = entered(kWhole,
                                  {{"density", "7.9"}, {"k", "0.33"}, {"profile", "inventor"}})
                              .value();
  EXPECT_EQ(request.density, 7.9);
  EXPECT_EQ(std::get<ConstantK>(*request.allowance).k, 0.33);
  EXPECT_EQ(request.dxf.profile, LayerProfile::inventor);
  EXPECT_FALSE(request.dxf.layers);
  EXPECT_TRUE(request.shop->gauge_limits);
  EXPECT_FALSE(entered(kWhole, {{"process", "punch"}}).value().shop->gauge_limits);
}

TEST(ShopOption, ChoosesTheMaterialByItsName) {
  EXPECT_EQ(entered(kTwoMaterials, {{"material", "BRASS"}}).value().density, 8.5);
  EXPECT_FALSE(entered(kTwoMaterials).value().shop->material);  // the part's file may say it
  const auto wrong = entered(kTwoMaterials, {{"material", "zinc"}});
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().message, HasSubstr("no material \"zinc\""));
}

TEST(ShopOption, NamesThePlaceOfAMistake) {
  const auto wrong = entered(R"({"materials": [{"name": "a", "gauges": []}]})");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().where, "shop/content/materials/0/gauges");
}

TEST(OptionValues, ApplyRulesToTheProcessWhateverComesFirst) {
  OptionValues values;
  values.set(option("rules"), OptionFile{"r.json", R"({"opening_to_edge_t": 3})"});
  ASSERT_TRUE(values.set_text(option("process"), "punch"));
  Request request;
  ASSERT_TRUE(values.enter(request));
  EXPECT_EQ(request.rules.opening_to_edge_t, 3.0);
  EXPECT_EQ(request.rules.smallest_opening_t, 1.2);
}

}  // namespace
}  // namespace planish::job
