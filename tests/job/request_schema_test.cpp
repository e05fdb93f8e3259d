#include "request_schema.hpp"

#include "job/job_requests.hpp"

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using schema::Json;

std::string wrong_in(const schema::Schema& schema, const char* text) {
  const auto wrong = schema::first_mistake(schema, Json::parse(text));
  return wrong ? wrong->pointer.empty() ? "/" : wrong->pointer : "";
}

TEST(RequestSchema, TakesRequestsToMakersBendAndInfo) {
  const schema::Schema schema = request_schema(built_in());
  for (const char* fine :
       {R"({"maker": "unfold", "input": "a.step"})", R"({"maker": "bend", "input": "a"})",
        R"({"maker": "info", "input": "a", "sheets": true})",
        R"({"maker": "slit", "input": {"content": {"a": [1]}, "folder": "x"}, "effort": "draft"})",
        R"({"maker": "connect", "input": {"name": "n", "content": "text"}, "artifacts": ["dxf"],
            "options": {"k": null}, "format": "planish/request", "version": 1})"})
    EXPECT_EQ(wrong_in(schema, fine), "") << fine;
  for (const auto& [text, where] :
       {std::pair{R"({"input": "a"})", "/maker"},
        {R"({"maker": "fold", "input": "a"})", "/maker"},
        {R"({"maker": "unfold"})", "/input"},
        {R"({"maker": "unfold", "input": ""})", "/input"},
        {R"({"maker": "unfold", "input": {}})", "/input/content"},
        {R"({"maker": "unfold", "input": "a", "effort": "x"})", "/effort"},
        {R"({"maker": "unfold", "input": "a", "artifacts": ["x"]})", "/artifacts/0"},
        {R"({"maker": "unfold", "input": "a", "version": 2})", "/version"},
        {R"({"maker": "unfold", "input": "a", "sheets": 1})", "/sheets"}})
    EXPECT_EQ(wrong_in(schema, text), where) << text;
}

TEST(RequestSchema, OfOneMakerHasItsOptionsAndArtifactsAlone) {
  for (const Maker& maker : built_in().makers) {
    const Json printed = schema::json_schema(request_schema(std::string(maker.name), built_in()),
                                             "", "");
    const Json& properties = printed["properties"];
    EXPECT_FALSE(properties.contains("maker"));
    EXPECT_EQ(properties["options"]["properties"].size(), maker.options.size()) << maker.name;
    for (const OptionUse& use : maker.options)
      EXPECT_TRUE(properties["options"]["properties"].contains(std::string(use.name))) << use.name;
    std::vector<std::string> written;
    for (const Artifact* one : built_in().written_by(maker))
      written.emplace_back(one->name);
    EXPECT_EQ(properties["artifacts"]["items"]["enum"], Json(written)) << maker.name;
    EXPECT_TRUE(properties.contains("effort"));
    EXPECT_FALSE(properties.contains("sheets"));
  }
}

TEST(RequestSchema, OfBendAndInfoHasTheirs) {
  const Json bend = schema::json_schema(request_schema("bend", built_in()), "", "")["properties"];
  EXPECT_EQ(bend["artifacts"]["items"]["enum"], Json({"pdf", "svg", "dxf", "json"}));
  EXPECT_TRUE(bend["options"]["properties"].contains("weights"));
  EXPECT_TRUE(bend["options"]["properties"].contains("inside_radius"));
  EXPECT_FALSE(bend["options"]["properties"].contains("profile"));
  EXPECT_FALSE(bend.contains("effort"));
  const Json info = schema::json_schema(request_schema("info", built_in()), "", "")["properties"];
  EXPECT_EQ(info["options"]["properties"].size(), 2u);
  EXPECT_TRUE(info["options"]["properties"].contains("body"));
  EXPECT_TRUE(info["options"]["properties"].contains("units"));
  EXPECT_TRUE(info.contains("sheets"));
  EXPECT_FALSE(info.contains("artifacts"));
}

TEST(OptionsSchema, TakesEachKindOfOption) {
  const schema::Schema given = options_schema(OptionFiles::path_or_content,
                                              *built_in().maker("unfold"));
  for (const char* fine :
       {R"({"r12": true})", R"({"k": 0.5})", R"({"piece": 2})", R"({"units": "m"})",
        R"({"root": 12})", R"({"root": "largest"})", R"({"body": 1})", R"({"body": "door"})",
        R"({"k_table": "a.csv"})", R"({"k_table": {"content": "r/t, k"}})",
        R"({"bend_k": {"B1": 0.3}})", R"({"k": null, "r12": null})",
        R"({"rules": {"name": "n", "content": {"k_low": 0.1}}})"})
    EXPECT_EQ(wrong_in(given, fine), "") << fine;
  for (const auto& [text, where] : {std::pair{R"({"r12": 1})", "/r12"},
                                    {R"({"k": 1.5})", "/k"},
                                    {R"({"piece": -1})", "/piece"},
                                    {R"({"piece": 1.5})", "/piece"},
                                    {R"({"units": "cm"})", "/units"},
                                    {R"({"root": 0})", "/root"},
                                    {R"({"root": "smallest"})", "/root"},
                                    {R"({"body": 0})", "/body"},
                                    {R"({"k_table": {"name": "n"}})", "/k_table/content"},
                                    {R"({"bend_k": {"B1": 2}})", "/bend_k/B1"},
                                    {R"({"rules": {"content": {"x": 1}}})", "/rules/content/x"},
                                    {R"({"nothing": 1})", "/nothing"}})
    EXPECT_EQ(wrong_in(given, text), where) << text;
}

TEST(OptionsSchema, TakesNoPathsWhereNoFilesAreRead) {
  const schema::Schema given = options_schema(OptionFiles::content, *built_in().maker("unfold"));
  EXPECT_EQ(wrong_in(given, R"({"k_table": "a.csv"})"), "/k_table");
  EXPECT_EQ(wrong_in(given, R"({"material": "steel"})"), "") << "of a shop";
  EXPECT_EQ(wrong_in(given, R"({"k_table": {"content": "r/t, k"}})"), "");
}

TEST(ValuesOf, AreThoseOfTheObject) {
  const OptionValues values = values_of(
      Json::parse(R"({"r12": true, "k": 0.25, "piece": 2, "root": 12,
      "body": 3, "units": "inch", "bend_k": {"B1": 0.3}, "density": null,
      "k_table": {"name": "steel.csv", "content": "text"}, "rules": {"content": {"k_low": 0.1}},
      "shop": "shop.json"})"),
      *built_in().maker("unfold"));
  EXPECT_TRUE(values.given("r12"));
  EXPECT_EQ(values.number("k"), 0.25);
  EXPECT_EQ(values.number("piece"), 2.0);
  EXPECT_EQ(values.text("root"), "12");
  EXPECT_EQ(values.text("body"), "3");
  EXPECT_EQ(values.text("units"), "inch");
  EXPECT_EQ(values.text("shop"), "shop.json");
  EXPECT_FALSE(values.given("density"));
  const auto file = [&](const char* name) {
    for (const auto& [given, value] : values.all())
      if (given->name == name) return std::get<OptionFile>(value);
    return OptionFile{};
  };
  EXPECT_EQ(file("k_table").name, "steel.csv");
  EXPECT_EQ(file("k_table").text, "text");
  EXPECT_EQ(file("rules").name, "rules") << "the option's";
  EXPECT_EQ(Json::parse(file("rules").text)["k_low"], 0.1);
}

}  // namespace
}  // namespace planish::job
