#include <planish/job/options.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace planish::job {
namespace {

using ByBend = std::vector<std::pair<std::string, double>>;

std::string file_beside(const std::string& name, const std::string& text) {
  const std::string path = ::testing::TempDir() + "planish_option_values_" + name;
  std::ofstream(path) << text;
  return path;
}

bool takes_text(const char* name, const char* text) {
  OptionValues values;
  const auto set = values.set_text(option(name), text);
  if (set) return true;
  EXPECT_EQ(set.error().code, code::bad_option);
  EXPECT_EQ(set.error().where, name);
  return false;
}

TEST(OptionValues, TakeTextsOfTheirKind) {
  for (const auto& [name, good] : std::vector<std::pair<const char*, std::vector<const char*>>>{
           {"r12", {"true", "false"}},
           {"k", {"0", "1", "0.44", "4e-1"}},
           {"piece", {"0", "7", "2.0"}},
           {"units", {"mm", "inch", "m"}},
           {"root", {"largest", "1", "12"}},
           {"up", {"auto", "reference", "other", "3"}},
           {"body", {"door", "1", " "}},
           {"rules", {"rules.json"}},
           {"bend_k", {"B1=0.3", "B1=0", "x=1"}}})
    for (const char* text : good)
      EXPECT_TRUE(takes_text(name, text)) << name << " " << text;
  for (const auto& [name, wrong] : std::vector<std::pair<const char*, std::vector<const char*>>>{
           {"r12", {"yes", "", "1"}},
           {"k", {"", "x", "1.1", "-0.1", "0.4x", "nan", "inf", " 0.4", "0,4"}},
           {"piece", {"-1", "1.5", "x"}},
           {"units", {"cm", "", "MM"}},
           {"root", {"0", "-1", "7x", "smallest", "1.5", ""}},
           {"body", {""}},
           {"rules", {""}},
           {"bend_k", {"B1", "=0.3", "B1=", "B1=2", "B1=x", "B1=0.3="}}})
    for (const char* text : wrong)
      EXPECT_FALSE(takes_text(name, text)) << name << " " << text;
}

TEST(OptionValues, SaySelfWhatWasGiven) {
  OptionValues values;
  EXPECT_FALSE(values.given("k"));
  EXPECT_FALSE(values.number("k"));
  EXPECT_EQ(values.text("units"), "");
  ASSERT_TRUE(values.set_text(option("k"), "0.3"));
  ASSERT_TRUE(values.set_text(option("units"), "inch"));
  ASSERT_TRUE(values.set_text(option("r12"), "false"));
  ASSERT_TRUE(values.set_text(option("bend_text"), "true"));
  EXPECT_TRUE(values.given("k"));
  EXPECT_EQ(values.number("k"), 0.3);
  EXPECT_FALSE(values.number("units"));
  EXPECT_EQ(values.text("units"), "inch");
  EXPECT_EQ(values.text("k"), "");
  EXPECT_FALSE(values.given("r12")) << "a flag that is not set is as if it were left out";
  EXPECT_TRUE(values.given("bend_text"));
  EXPECT_EQ(values.all().size(), 4u);
}

TEST(OptionValues, TakeTheLastOfEachButAllBends) {
  OptionValues values;
  for (const char* text : {"0.3", "0.4"})
    ASSERT_TRUE(values.set_text(option("k"), text));
  for (const char* text : {"B1=0.3", "B2=0.4", "B1=0.5"})
    ASSERT_TRUE(values.set_text(option("bend_k"), text));
  EXPECT_EQ(values.number("k"), 0.4);
  Request request;
  ASSERT_TRUE(values.enter(request));
  EXPECT_EQ(request.bend_k, (ByBend{{"B1", 0.3}, {"B2", 0.4}, {"B1", 0.5}}));
}

/// The place of the contradiction between these; empty if there is none.
std::string clash(const std::vector<std::pair<const char*, const char*>>& given) {
  OptionValues values;
  for (const auto& [name, text] : given)
    EXPECT_TRUE(values.set_text(option(name), text));
  const auto together = values.check_together();
  if (together) return "";
  EXPECT_EQ(together.error().code, code::bad_option);
  Request request;
  EXPECT_EQ(values.enter(request).error().where, together.error().where);
  return together.error().where;
}

TEST(OptionValues, ContradictOneAnotherInOnePlace) {
  EXPECT_EQ(clash({{"k", "0.4"}}), "");
  EXPECT_EQ(clash({{"k", "0.4"}, {"k_table", "t.csv"}}), "k_table");
  EXPECT_EQ(clash({{"k", "0.4"}, {"din6935", "true"}}), "din6935");
  EXPECT_EQ(clash({{"k", "0.4"}, {"din6935", "false"}}), "");
  EXPECT_EQ(clash({{"din6935", "true"}, {"k_table", "t.csv"}}), "din6935");
  EXPECT_EQ(clash({{"k", "0.4"}, {"material", "m.json"}}), "material");
  EXPECT_EQ(clash({{"k", "0.4"}, {"material", "steel"}, {"shop", "s.json"}}).empty(), true);
  EXPECT_EQ(clash({{"rules", "r.json"}, {"no_rules", "true"}}), "no_rules");
  EXPECT_EQ(clash({{"r12", "true"}, {"splines", "keep"}}), "splines");
  EXPECT_EQ(clash({{"r12", "true"}, {"splines", "arcs"}}), "");
  EXPECT_EQ(clash({{"tangent_lines", "true"}, {"profile", "solidedge"}}), "tangent_lines");
  EXPECT_EQ(clash({{"tangent_lines", "true"}, {"profile", "onshape"}}), "");
  EXPECT_EQ(clash({{"splines", "keep"}}), "");
  EXPECT_EQ(clash({{"tick_length", "3"}}), "tick_length");
  EXPECT_EQ(clash({{"tick_length", "3"}, {"bend_marks", "lines"}}), "tick_length");
  EXPECT_EQ(clash({{"tick_length", "3"}, {"bend_marks", "ticks"}}), "");
}

TEST(OptionValues, ReadFilesOnceTheyAreEntered) {
  OptionValues values;
  ASSERT_TRUE(values.set_text(option("k_table"), "/no/such/table.csv"));
  Request request;
  const auto absent = values.enter(request);
  EXPECT_EQ(absent.error().code, code::cannot_read);
  const std::string table = file_beside("table.csv", "r/t, k\n0.1, 0.3\n9, 0.3\n");
  ASSERT_TRUE(values.set_text(option("k_table"), table));
  EXPECT_TRUE(values.enter(request));
  EXPECT_TRUE(std::holds_alternative<BendTable>(*request.allowance));
  values.read_no_files();
  const auto unread = values.enter(request);
  EXPECT_EQ(unread.error().code, code::bad_option);
  EXPECT_EQ(unread.error().where, "k_table");
}

TEST(OptionValues, NameThePlaceWithinAContent) {
  const auto place_in = [](const char* name, const char* content) {
    OptionValues values;
    values.set(option(name), OptionFile{"given.json", content});
    Request request;
    const auto entered = values.enter(request);
    EXPECT_FALSE(entered) << content;
    return entered ? "" : entered.error().where;
  };
  EXPECT_EQ(place_in("rules", R"({"k_low": 0.9})"), "rules/content/k_low");
  EXPECT_EQ(place_in("rules", "{"), "rules/content");
  EXPECT_EQ(place_in("k_table", "r/t, k\n1, 5\n"), "k_table/content");
}

TEST(OptionValues, TakeMaterialsByNameBesideAShop) {
  constexpr auto kShop = R"({"name": "S", "materials": [
    {"name": "Steel", "density": 7.8, "gauges": [{"thickness": 2, "inside_radius": 2, "k": 0.4}]},
    {"name": "brass", "density": 8.5, "gauges": [{"thickness": 2, "inside_radius": 2, "k": 0.3}]}
    ]})";
  const auto entered = [&](const std::string& material, bool files,
                           std::optional<double> k = {}) -> Result<Request> {
    OptionValues values;
    values.set(option("material"), material);
    values.set(option("shop"), OptionFile{"shop.json", kShop});
    if (k) values.set(option("k"), *k);
    if (!files) values.read_no_files();
    Request request;
    if (auto done = values.enter(request); !done) return tl::unexpected(done.error());
    return request;
  };
  EXPECT_EQ(entered("BRASS", true)->shop->material, 1);
  EXPECT_FALSE(entered("BRASS", true)->allowance);
  EXPECT_EQ(entered("wood", true).error().where, "material");
  EXPECT_EQ(entered("wood", false).error().where, "material");
  constexpr auto kCurves = R"("tension": {"power_law": {"strength": 500, "exponent": 0.2}}})";
  const std::string other = file_beside("other.json", std::string(R"({"name": "M", )") + kCurves);
  EXPECT_EQ(entered(other, true).error().where, "material") << "the shop has no M";
  const std::string file = file_beside("material.json",
                                       std::string(R"({"name": "brass", )") + kCurves);
  const auto of_file = entered(file, true);
  ASSERT_TRUE(of_file) << of_file.error().message;
  EXPECT_EQ(of_file->shop->material, 1);
  EXPECT_TRUE(of_file->allowance) << "K from the file";
  EXPECT_EQ(entered(file, false).error().where, "material") << "no file is read";
  const auto two = entered(file, true, 0.4);
  ASSERT_FALSE(two);
  EXPECT_EQ(two.error().code, code::bad_option);
  EXPECT_EQ(two.error().where, "material");
}

TEST(OptionValues, TellTheShopWhichOptionsWin) {
  constexpr auto kShop = R"({"name": "S", "materials": [
    {"name": "Steel", "density": 7.8, "tensile_strength": 500,
     "gauges": [{"thickness": 2, "inside_radius": 2, "k": 0.4}]},
    {"name": "stainless", "gauges": [{"thickness": 2, "inside_radius": 2, "k": 0.4}]}]})";
  const auto entered = [&](const std::vector<std::pair<const char*, const char*>>& others) {
    OptionValues values;
    values.set(option("shop"), OptionFile{"shop.json", kShop});
    for (const auto& [name, text] : others)
      EXPECT_TRUE(values.set_text(option(name), text));
    Request request;
    EXPECT_TRUE(values.enter(request));
    return request;
  };
  EXPECT_FALSE(entered({}).shop->density_given);
  EXPECT_TRUE(entered({{"density", "1"}}).shop->density_given);
  EXPECT_TRUE(entered({}).shop->gauge_limits);
  EXPECT_FALSE(entered({{"process", "punch"}}).shop->gauge_limits);
  EXPECT_FALSE(entered({}).shop->material);
  const Request metal = entered({{"metal", "stainless"}});
  EXPECT_EQ(metal.shop->material, 1) << "the word is a material of the shop";
  EXPECT_TRUE(metal.shop->strength_given);
}

TEST(OptionAt, FindsTheOptionThatAPlaceBelongsTo) {
  EXPECT_EQ(option_at("k"), &option("k"));
  EXPECT_EQ(option_at("bend_k/B99"), &option("bend_k"));
  EXPECT_EQ(option_at("rules/content/k_low"), &option("rules"));
  EXPECT_EQ(option_at("units/x"), nullptr) << "a file that is called so";
  for (const char* none : {"", "/k", "kk", "bracket.step", "k_/x"})
    EXPECT_EQ(option_at(none), nullptr) << none;
}

TEST(OptionAt, PutsErrorsAtTheirPointer) {
  const Error bend{code::bad_option, "m", "bend_k/B99"};
  const Error placed = at_pointer(bend, "/options");
  EXPECT_EQ(placed.where, "/options/bend_k/B99");
  EXPECT_EQ(placed.places, std::vector<Place>{place::pointer("/options/bend_k/B99")});
  const Error content = at_pointer({code::invalid_input, "m", "rules/content/k_low"}, "/options");
  EXPECT_EQ(content.where, "/options/rules/content/k_low");
  EXPECT_TRUE(content.places.empty());
  EXPECT_EQ(at_pointer({code::bad_option, "m", "part.step"}, "/options").where, "part.step");
}

TEST(ParseNumber, TakesTheWholeTextOrNothing) {
  EXPECT_EQ(parse_number("0.25"), 0.25);
  EXPECT_EQ(parse_number("-3e2"), -300.0);
  for (const char* text : {"", " 1", "1 ", "1x", "0x1", "nan", "inf", "1e999", "1,5", "+1"})
    EXPECT_FALSE(parse_number(text)) << text;
}

}  // namespace
}  // namespace planish::job
