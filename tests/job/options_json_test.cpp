#include <planish/job/artifact.hpp>
#include <planish/job/run.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace planish::job {
namespace {

using nlohmann::json;

TEST(OptionsJson, IsReadBackAsTheSameValues) {
  OptionValues values;
  values.set(option("din6935"), true);
  values.set(option("k"), 0.1 + 0.2);
  values.set(option("root"), std::string("7"));
  values.set(option("k_table"), OptionFile{"steel.csv", "r/t, k\n1, 0.3\n"});
  values.set(option("bend_k"),
             std::vector<std::pair<std::string, double>>{{"B1", 0.3}, {"B2", 0.4}});
  const std::string text = options_json(values);
  EXPECT_EQ(json::parse(text), json::parse(R"({"din6935": true, "k": 0.30000000000000004,
      "root": "7", "k_table": {"name": "steel.csv", "content": "r/t, k\n1, 0.3\n"},
      "bend_k": {"B1": 0.3, "B2": 0.4}})"));
  const Maker& unfolding = *built_in().maker("unfold");
  OptionValues fewer = values;  // a face number is no text in JSON
  fewer.set(option("root"), std::string("largest"));
  const auto read = read_options(options_json(fewer), unfolding, OptionFiles::content, "/options");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(json::parse(options_json(*read)), json::parse(options_json(fewer)));
}

TEST(OptionsJson, IsAnEmptyObjectWithoutValues) { EXPECT_EQ(options_json({}), "{}"); }

}  // namespace
}  // namespace planish::job
