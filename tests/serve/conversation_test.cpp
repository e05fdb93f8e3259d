#include "conversation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <sstream>

// What is answered at once: without a crew, whose workers are this program started again.

namespace planish::serve {
namespace {

class Pipe {
 public:
  Pipe() { EXPECT_EQ(pipe(ends_.data()), 0); }
  ~Pipe() {
    for (const int end : ends_)
      close(end);
  }
  int reading() const { return ends_[0]; }
  int writing() const { return ends_[1]; }

 private:
  std::array<int, 2> ends_{};
};

/// Says messages and hears the answers.
class Client {
 public:
  Client() : options_{.jobs = 0, .limits = {}, .version = "9.8"} {}

  std::vector<Json> say(const std::string& message) {
    conversation_.take(message);
    writer_.send("end");
    std::string heard;
    for (char c = 0; !heard.ends_with("end\n") && read(pipe_.reading(), &c, 1) == 1;)
      heard += c;
    std::vector<Json> answers;
    std::istringstream lines(heard);
    for (std::string line; std::getline(lines, line) && line != "end";)
      answers.push_back(Json::parse(line));
    return answers;
  }
  /// The only answer to a message.
  Json answer(const std::string& message) {
    const auto answers = say(message);
    EXPECT_EQ(answers.size(), 1u) << message;
    return answers.empty() ? Json() : answers[0];
  }
  Json ask(const std::string& method, const Json& parameters = nullptr) {
    Json request{{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}};
    if (!parameters.is_null()) request["params"] = parameters;
    return answer(request.dump());
  }
  std::optional<int> exit_status() const { return conversation_.exit_status(); }

 private:
  Pipe pipe_;
  ServeOptions options_;
  MessageWriter writer_{pipe_.writing()};
  Conversation conversation_{writer_, options_, job::built_in()};
};

TEST(Conversation, AnswersAtOnceWhatNeedsNoWork) {
  Client client;
  EXPECT_EQ(client.ask("ping")["result"], Json::object());
  EXPECT_EQ(
      client.ask("initialize", {{"protocolVersion", "2024-11-05"}})["result"]["protocolVersion"],
      "2024-11-05");
  EXPECT_EQ(client.ask("initialize")["result"]["serverInfo"]["version"], "9.8");
  EXPECT_GT(client.ask("tools/list")["result"]["tools"].size(), 4u);
  EXPECT_TRUE(client.ask("formats")["result"].contains("makers"));
  EXPECT_TRUE(client.ask("schema", {{"name", "plates"}})["result"].contains("properties"));
  const Json called = client.ask("tools/call", {{"name", "formats"}});
  EXPECT_TRUE(called["result"]["structuredContent"].contains("makers"));
}

TEST(Conversation, SaysWhatIsWrongWithAMessage) {
  Client client;
  const auto code_of = [&](const std::string& message) {
    const Json answer = client.answer(message);
    EXPECT_EQ(answer["jsonrpc"], "2.0");
    return answer["error"]["code"].get<int>();
  };
  EXPECT_EQ(code_of("{"), -32700);
  EXPECT_EQ(code_of(std::string(300, '[')), -32700) << "nested too deep";
  for (const char* no_request :
       {"[]", "7", "{}", R"({"jsonrpc": "1.0", "id": 1, "method": "ping"})",
        R"({"jsonrpc": "2.0", "id": 1, "method": 7})",
        R"({"jsonrpc": "2.0", "id": [1], "method": "ping"})"})
    EXPECT_EQ(code_of(no_request), -32600) << no_request;
  EXPECT_EQ(code_of(R"({"jsonrpc": "2.0", "id": 1, "method": "fold"})"), -32601);
  EXPECT_EQ(code_of(R"({"jsonrpc": "2.0", "id": 1, "method": "ping", "params": [1]})"), -32602);
  EXPECT_EQ(client.ask("schema", {{"name", "no"}})["error"]["data"]["code"], "bad_option");
  EXPECT_EQ(client.ask("tools/call", {{"name", "no"}})["error"]["data"]["where"], "/name");
  EXPECT_EQ(
      client.ask("tools/call", {{"name", "formats"}, {"arguments", {1}}})["error"]["data"]["where"],
      "/arguments");
  EXPECT_EQ(client.ask("tools/call",
                       {{"name", "schema"}, {"arguments", {{"name", "no"}}}})["result"]["isError"],
            true)
      << "which a model is to read";
  EXPECT_EQ(client.answer("{")["id"], nullptr);
}

TEST(Conversation, KeepsTheIdOfARequest) {
  Client client;
  EXPECT_EQ(client.answer(R"({"jsonrpc": "2.0", "id": "x-1", "method": "ping"})")["id"], "x-1");
  EXPECT_EQ(client.answer(R"({"jsonrpc": "2.0", "id": 7.5, "method": "ping"})")["id"], 7.5);
}

TEST(Conversation, AnswersNeitherNotificationsNorAnswers) {
  Client client;
  for (const char* message :
       {R"({"jsonrpc": "2.0", "method": "ping"})", R"({"jsonrpc": "2.0", "id": 1, "result": {}})",
        R"({"jsonrpc": "2.0", "id": 1, "error": {}})",
        R"({"jsonrpc": "2.0", "method": "$/cancelRequest", "params": {"id": 9}})",
        R"({"jsonrpc": "2.0", "method": "ping", "params": [1]})"})
    EXPECT_TRUE(client.say(message).empty()) << message;
}

TEST(Conversation, AnswersAListTogether) {
  Client client;
  const Json answers = client.answer(
      R"([{"jsonrpc": "2.0", "id": 1, "method": "ping"}, {"jsonrpc": "2.0", "method": "ping"}, 7,
          {"jsonrpc": "2.0", "id": 2, "method": "ping"}])");
  ASSERT_EQ(answers.size(), 3u);
  EXPECT_EQ(answers[0]["id"], 1);
  EXPECT_EQ(answers[1]["error"]["code"], -32600);
  EXPECT_EQ(answers[2]["id"], 2);
}

TEST(Conversation, EndsAfterShutdownAndExit) {
  Client client;
  EXPECT_FALSE(client.exit_status());
  EXPECT_EQ(client.ask("shutdown")["result"], nullptr);
  EXPECT_FALSE(client.exit_status());
  EXPECT_EQ(client.ask("ping")["error"]["code"], -32600);
  (void)client.say(R"({"jsonrpc": "2.0", "method": "exit"})");
  EXPECT_EQ(client.exit_status(), 0);
  Client hasty;
  (void)hasty.say(R"({"jsonrpc": "2.0", "method": "exit"})");
  EXPECT_EQ(hasty.exit_status(), 1);
}

}  // namespace
}  // namespace planish::serve
