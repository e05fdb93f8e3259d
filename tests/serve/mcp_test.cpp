#include "mcp.hpp"

#include <planish/sheet/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::serve {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Mcp, SpeaksTheVersionThatIsAskedForElseItsNewest) {
  for (const char* known : {"2024-11-05", "2025-03-26", "2025-06-18"})
    EXPECT_EQ(protocol_version(known), known);
  EXPECT_EQ(protocol_version("1999-01-01"), "2025-06-18");
  EXPECT_EQ(protocol_version(""), "2025-06-18");
}

TEST(Mcp, IntroducesItself) {
  const Json said = introduction("2025-03-26", "9.8");
  EXPECT_EQ(said["protocolVersion"], "2025-03-26");
  EXPECT_EQ(said["serverInfo"]["name"], "planish");
  EXPECT_EQ(said["serverInfo"]["version"], "9.8");
  EXPECT_EQ(said["capabilities"]["tools"]["listChanged"], false);
  EXPECT_FALSE(said["instructions"].get<std::string>().empty());
}

TEST(Mcp, SaysWhichToolsWriteFiles) {
  const Json writing = Json::parse(R"({"type": "object", "properties": {"write": {}}})");
  const Json reading = Json::parse(R"({"type": "object", "properties": {}})");
  const Json list = tool_list(
      {{"unfold", "lays flat", writing, true}, {"info", "says", reading, true}});
  ASSERT_EQ(list["tools"].size(), 2u);
  EXPECT_EQ(list["tools"][0]["name"], "unfold");
  EXPECT_EQ(list["tools"][0]["description"], "lays flat");
  EXPECT_EQ(list["tools"][0]["inputSchema"], writing);
  EXPECT_EQ(list["tools"][0]["annotations"]["readOnlyHint"], false);
  EXPECT_EQ(list["tools"][1]["annotations"]["readOnlyHint"], true);
}

TEST(Mcp, HoldsAResultWhereTheClientReadsIt) {
  WorkDone done;
  done.result = R"({"status":"ok"})";
  done.summary = "a \"part\"";
  for (const auto& [protocol, items] : {std::pair{"2024-11-05", 2u}, {"2025-06-18", 1u}}) {
    const Json told = Json::parse(call_result(done, protocol));
    EXPECT_EQ(told["content"].size(), items) << protocol;
    EXPECT_EQ(told["content"][0]["text"], done.summary);
    EXPECT_EQ(told["structuredContent"]["status"], "ok");
    EXPECT_EQ(told["isError"], false);
    if (items == 2u) {
      EXPECT_EQ(Json::parse(told["content"][1]["text"].get<std::string>())["status"], "ok");
    }
  }
  done.refused = true;
  EXPECT_EQ(Json::parse(call_result(done, "2025-06-18"))["isError"], true);
}

TEST(Mcp, AnswersAtOnceWithTheSameAsTextAndAsData) {
  const Json answer{{"names", {"plates"}}};
  const Json told = Json::parse(call_result(answer));
  EXPECT_EQ(told["structuredContent"], answer);
  EXPECT_EQ(Json::parse(told["content"][0]["text"].get<std::string>()), answer);
  EXPECT_EQ(told["isError"], false);
}

TEST(Mcp, TellsAModelWhatIsWrongAndWhere) {
  const auto said = [](const Error& error) {
    const Json told = Json::parse(call_result(error));
    EXPECT_EQ(told["isError"], true);
    EXPECT_EQ(told["structuredContent"]["code"], code_name(error.code));
    return told["content"][0]["text"].get<std::string>();
  };
  EXPECT_EQ(said({code::overlap, "It covers itself.", "flange 3"}),
            "[overlap] It covers itself. (flange 3)");
  EXPECT_EQ(said({code::overlap, "flange 3 covers itself.", "flange 3"}),
            "[overlap] flange 3 covers itself.")
      << "the place is said once";
  EXPECT_THAT(said({code::overlap, "It covers itself.", ""}), Not(HasSubstr("(")));
}

}  // namespace
}  // namespace planish::serve
