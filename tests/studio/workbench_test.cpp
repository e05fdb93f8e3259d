#include "work/workbench.hpp"

#include "work/attachments.hpp"
#include "work/request.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace planish::studio {
namespace {

std::string example(const std::string& name) {
  std::ifstream file(PLANISH_SOURCE_DIR "/examples/" + name, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string request(const std::string& spec) { return "{\"spec\": " + spec + "}"; }

TEST(Workbench, OpensEachKindAndDraftsIt) {
  for (const auto& [name, kind] : {std::pair{"bracket.step", "unfold"},
                                   {"connect/a_folded.json", "connect"},
                                   {"transition/a_square_to_round.json", "transition"},
                                   {"slit/chair.json", "slit"}}) {
    Workbench bench("/nowhere");
    const std::string bytes = example(name);
    const Answer opened = bench.perform({"open", "a.file", bytes});
    ASSERT_EQ(opened.status, 200) << opened.body;
    EXPECT_EQ(Json::parse(opened.body)["kind"], kind);
    const std::string asked = kind == std::string("unfold") ? "{}" : request(bytes);
    for (const char* verb : {"draft", "result", "draft"}) {
      const Answer shape = bench.perform({verb, "", asked});
      EXPECT_EQ(shape.status, 200) << shape.body;
      EXPECT_EQ(shape.body.substr(0, 4), "PLN1");
    }
  }
}

TEST(Workbench, DoesNothingBeforeItIsOpen) {
  Workbench bench("/nowhere");
  for (const char* verb : {"draft", "result", "files", ""})
    EXPECT_EQ(bench.perform({verb, "dxf", "{}"}).status, 500);
  EXPECT_EQ(bench.perform({"open", "a", "rubbish"}).status, 422);
  EXPECT_EQ(bench.perform({"draft", "", "{}"}).status, 500);
}

TEST(Workbench, FreesWhatWasReadOnceAResultIsThere) {
  Workbench bench("/nowhere");
  EXPECT_FALSE(bench.rest());
  bench.perform({"open", "a.step", example("bracket.step")});
  bench.perform({"draft", "", "{}"});
  EXPECT_FALSE(bench.rest());  // the page asks for the result next
  const Answer before = bench.perform({"result", "", "{}"});
  EXPECT_TRUE(bench.rest());
  EXPECT_FALSE(bench.rest());
  const Answer after = bench.perform({"result", "", R"({"options": {"k": 0.3}})"});
  EXPECT_EQ(after.status, 200);
  EXPECT_NE(after.body, before.body);
  Workbench plates("/nowhere");
  const std::string spec = example("connect/a_folded.json");
  plates.perform({"open", "a.json", spec});
  plates.perform({"result", "", request(spec)});
  EXPECT_FALSE(plates.rest());
}

const job::Maker& unfold() { return *job::built_in().maker("unfold"); }

TEST(Requests, OfTheSameGeometryHaveTheSameKey) {
  const auto key = [](const std::string& options) {
    const auto asked = parse_asked(R"({"options": )" + options + "}", unfold());
    EXPECT_TRUE(asked) << asked.error().message;
    return asked ? asked->key : "";
  };
  EXPECT_EQ(key(R"({"k": 0.4, "r12": true, "turn_to_blank": true})"), key(R"({"k": 0.4})"));
  EXPECT_NE(key(R"({"k": 0.4})"), key(R"({"k": 0.3})"));
  EXPECT_NE(key(R"({"units": "inch"})"), key("{}"));  // the report's too
}

TEST(Requests, NameMaterialsOfTheShopAndReadNoFile) {
  const std::string shop = R"("shop": {"content": )" + example("shop/example.json") + "}";
  const auto asked = [](const std::string& options) {
    return parse_asked(R"({"options": {)" + options + "}}", unfold());
  };
  const auto steel = asked(shop + R"(, "material": "Mild Steel")");
  ASSERT_TRUE(steel) << steel.error().message;
  EXPECT_EQ(steel->request.shop->chosen().name, "mild steel");
  EXPECT_EQ(steel->request.density, 7.85);
  // Both are there to be read, as the command line would.
  const std::string file = PLANISH_SOURCE_DIR "/examples/shop/example.json";
  const auto path = asked(shop + R"(, "material": ")" + file + "\"");
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().where, "/options/material");
  EXPECT_EQ(path.error().message, "The shop profile has no material \"" + file +
                                      "\": it has mild steel, aluminium 5754.");
  const auto alone = asked(R"("material": "mild steel")");
  ASSERT_FALSE(alone);
  EXPECT_EQ(
      alone.error().message,
      "`material` can be the name of a material only together with `shop`. Give the content of "
      "the material file.");
  EXPECT_FALSE(asked(R"("k_table": ")" + file + "\""));
}

TEST(Requests, OrderStrokesWithTheToolsOfTheShop) {
  Workbench bench("/nowhere");
  bench.perform({"open", "a.step", example("bracket.step")});
  Json shop = Json::parse(example("shop/example.json"));
  shop["materials"].erase(1);
  shop["tools"] = {{"punches", {"P88-R1"}}, {"dies", {"V16-88"}}};
  const auto die = [&](const Json& options, const char* brake) {
    const Json asked{{"options", options}, {"brake", Json::parse(brake)}};
    const Answer answer = bench.perform({"plan", "", asked.dump()});
    EXPECT_EQ(answer.status, 200) << answer.body;
    return Json::parse(answer.body)["strokes"][0]["die"];
  };
  const Json of_shop{{"shop", {{"content", shop}}}};
  EXPECT_EQ(die(Json::object(), "{}"), "V12-88");
  EXPECT_EQ(die(of_shop, "{}"), "V16-88");
  EXPECT_EQ(die(of_shop, R"({"springback": 1})"), "V16-88");
}

TEST(Workbench, TellsHowFarItIs) {
  Workbench bench("/nowhere");
  const std::string spec = example("slit/chair.json");
  bench.perform({"open", "a.json", spec});
  double last = 0.0;
  int stages = 0;
  Progress progress;
  progress.report = [&](std::string_view, double share) { last = share, ++stages; };
  EXPECT_EQ(bench.perform({"result", "", request(spec)}, progress).status, 200);
  EXPECT_GT(stages, 2);
  EXPECT_GT(last, 0.5);
}

TEST(Workbench, GivesUpWhenAsked) {
  Workbench bench("/nowhere");
  const std::string spec = example("slit/chair.json");
  bench.perform({"open", "a.json", spec});
  Progress progress;
  progress.cancelled = [] { return true; };
  const Answer answer = bench.perform({"result", "", request(spec)}, progress);
  EXPECT_EQ(answer.status, 409);
  EXPECT_EQ(Json::parse(answer.body)["code"], "cancelled");
}

TEST(Attachments, HavePlainNames) {
  for (const char* name : {"a", "scan 0.xyz", "räumlich.txt", "a..b"})
    EXPECT_TRUE(is_plain_name(name)) << name;
  for (const char* name : {"", ".", "..", ".a", "/a", "a/b", "a\\b", "a\nb", "a\x7f"})
    EXPECT_FALSE(is_plain_name(name)) << name;
  EXPECT_FALSE(is_plain_name(std::string("a\0b", 3)));
  EXPECT_TRUE(is_plain_name(std::string(240, 'a')));
  EXPECT_FALSE(is_plain_name(std::string(241, 'a')));
}

}  // namespace
}  // namespace planish::studio
