#include "tools.hpp"

#include <planish/job/schemas.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::serve {
namespace {

const std::vector<Tool>& all_tools() {
  static const std::vector<Tool> tools = tools_of(job::built_in());
  return tools;
}

const Tool& tool_named(const std::string& name) {
  return *std::ranges::find(all_tools(), name, &Tool::name);
}

TEST(Tools, AreTheMakersAndWhatElseCanBeAsked) {
  std::vector<std::string> names;
  for (const Tool& tool : all_tools()) {
    names.push_back(tool.name);
    EXPECT_EQ(tool.schema["type"], "object") << tool.name;
    EXPECT_EQ(tool.schema["additionalProperties"], false) << tool.name;
    EXPECT_TRUE(std::isupper(static_cast<unsigned char>(tool.description[0]))) << tool.name;
    EXPECT_TRUE(tool.description.ends_with('.')) << tool.name;
    EXPECT_EQ(tool.works, tool.name != "schema" && tool.name != "formats") << tool.name;
    EXPECT_FALSE(tool.schema.contains("$id"));
  }
  for (const job::Maker& maker : job::built_in().makers)
    EXPECT_EQ(std::ranges::count(names, maker.name), 1) << maker.name;
  for (const char* other : {"bend", "info", "schema", "formats"})
    EXPECT_EQ(std::ranges::count(names, other), 1) << other;
}

TEST(Tools, WriteWhatTheirMakerWrites) {
  for (const job::Maker& maker : job::built_in().makers) {
    const Json& properties = tool_named(std::string(maker.name)).schema["properties"];
    const Json& paths = properties["write"]["properties"];
    const auto written = job::built_in().written_by(maker);
    EXPECT_EQ(paths.size(), written.size()) << maker.name;
    for (const job::Artifact* one : written)
      EXPECT_EQ(paths[std::string(one->name)]["minLength"], 1) << one->name;
    EXPECT_EQ(properties["write"]["additionalProperties"], false);
  }
  EXPECT_FALSE(tool_named("info").schema["properties"].contains("write"));
  EXPECT_TRUE(tool_named("bend").schema["properties"]["write"]["properties"].contains("pdf"));
}

TEST(Tools, HaveTheOptionsOfTheirMakerWithoutNull) {
  for (const job::Maker& maker : job::built_in().makers) {
    const Json& options = tool_named(std::string(maker.name))
                              .schema["properties"]["options"]["properties"];
    EXPECT_EQ(options.size(), maker.options.size()) << maker.name;
    for (const auto& [name, option] : options.items()) {
      EXPECT_TRUE(option.contains("description")) << name;
      if (!option.contains("anyOf")) continue;
      for (const Json& one : option["anyOf"])
        EXPECT_NE(one, Json::parse(R"({"type": "null"})")) << name;
    }
  }
  const Json& k = tool_named("unfold").schema["properties"]["options"]["properties"]["k"];
  EXPECT_EQ(k["type"], "number");
  EXPECT_EQ(k["maximum"], 1);
}

TEST(Tools, LeaveTheContentOfFilesToTheSchemas) {
  for (const Tool& tool : all_tools())
    EXPECT_EQ(tool.schema.dump().find("opening_to_bend_t"), std::string::npos) << tool.name;
  const Json& rules = tool_named("unfold").schema["properties"]["options"]["properties"]["rules"];
  EXPECT_NE(rules.dump().find("`schema`"), std::string::npos);
}

TEST(Tools, AnswerAtOnceWithSchemasAndFormats) {
  const auto& catalogue = job::built_in();
  EXPECT_EQ(*answer_at_once("formats", Json::object(), catalogue),
            Json::parse(job::catalogue_json()));
  EXPECT_EQ((*answer_at_once("schema", Json::object(), catalogue))["names"],
            Json(job::schema_names()));
  EXPECT_EQ(*answer_at_once("schema", {{"name", "plates"}}, catalogue),
            Json::parse(job::schema_text("plates")));
  for (const Json& name : {Json("no"), Json(7), Json(nullptr)}) {
    const auto none = answer_at_once("schema", {{"name", name}}, catalogue);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, code::bad_option);
    EXPECT_EQ(none.error().where, "/name");
  }
}

}  // namespace
}  // namespace planish::serve
