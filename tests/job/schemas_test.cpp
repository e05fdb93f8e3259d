#include <planish/job/schemas.hpp>
#include <planish/schema/json_parts.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::job {
using namespace schema;
namespace {

using ::testing::ElementsAre;

// What the parsers refuse, JSON Schema has to say too.
TEST(Schemas, HaveTheLimitsOfTheParsers) {
  const auto properties = [](const char* name) {
    return Json::parse(schema_text(name))["properties"];
  };
  const Json slits = properties("slits");
  EXPECT_EQ(slits["ridges"]["minimum"], 3);
  EXPECT_EQ(slits["ridges"]["maximum"], 1000);
  EXPECT_EQ(slits["thickness"]["maximum"], 10000000);
  const Json poles = slits["leg_curve"]["properties"]["bezier"];
  EXPECT_EQ(poles["minItems"], 2);
  EXPECT_EQ(poles["items"]["items"]["minimum"], -10000000);
  EXPECT_EQ(poles["items"]["items"]["maximum"], 10000000);
  EXPECT_EQ(properties("transition")["press_lines"]["properties"]["count"]["maximum"], 2000);
  const Json bend = properties("plates")["bends"]["items"]["properties"];
  EXPECT_EQ(bend["edges"]["additionalProperties"]["minItems"], 1);
}

TEST(Schemas, AreNamedForWhatTheyDescribe) {
  EXPECT_THAT(schema_names(), ElementsAre("plates", "transition", "slits", "rules", "material",
                                          "tools", "shop", "request", "report", "summary", "info"));
  for (const std::string& name : schema_names())
    EXPECT_EQ(Json::parse(schema_text(name))["$id"], name + ".json");
  EXPECT_EQ(schema_text("plate"), "");
}

}  // namespace
}  // namespace planish::job
