#include "rpc.hpp"

#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>

namespace planish::serve {
namespace {

TEST(Rpc, WordsAnswersAsTheStandard) {
  EXPECT_EQ(response(7, R"({"a":1})"), R"({"jsonrpc":"2.0","id":7,"result":{"a":1}})");
  EXPECT_EQ(response("x", "null"), R"({"jsonrpc":"2.0","id":"x","result":null})");
  EXPECT_EQ(response(nullptr, {RpcCode::parse_error, "no JSON"}),
            R"({"jsonrpc":"2.0","id":null,"error":{"code":-32700,"message":"no JSON"}})");
  EXPECT_EQ(
      response(1, {RpcCode::failed, "m", {{"code", "c"}}}),
      R"({"jsonrpc":"2.0","id":1,"error":{"code":-32000,"message":"m","data":{"code":"c"}}})");
  EXPECT_EQ(notification("$/progress", {{"id", 1}}),
            R"({"jsonrpc":"2.0","method":"$/progress","params":{"id":1}})");
  EXPECT_EQ(text_of({{"name", "tr\xE4ger"}}), "{\"name\":\"tr\uFFFDger\"}");
}

TEST(Rpc, KnowsWhetherTheRequestIsAtFault) {
  EXPECT_TRUE(is_of_request({code::bad_option, "m", "/options/k"}));
  EXPECT_TRUE(is_of_request({code::bad_option, "m", ""}));
  EXPECT_TRUE(is_of_request({code::invalid_input, "m", "/maker", {place::pointer("/maker")}}));
  // A field of a file: its name stands before the pointer.
  EXPECT_FALSE(
      is_of_request({code::invalid_input, "m", "p.json/plates", {place::pointer("/plates")}}));
  EXPECT_FALSE(is_of_request({code::invalid_input, "m", "/tmp/p.json"}));
  EXPECT_FALSE(is_of_request({code::overlap, "m", "/maker", {place::pointer("/maker")}}));
}

TEST(Rpc, GivesErrorsTheirCodeAndTheirData) {
  const RpcError wrong = rpc_error({code::bad_option, "m", "/options/k"});
  EXPECT_EQ(wrong.code, RpcCode::invalid_params);
  EXPECT_EQ(wrong.message, "m");
  EXPECT_EQ(wrong.data["code"], "bad_option");
  EXPECT_EQ(wrong.data["where"], "/options/k");
  EXPECT_FALSE(wrong.data.contains("message")) << "said once";
  EXPECT_EQ(rpc_error({code::cancelled, "m", ""}).code, RpcCode::cancelled);
  EXPECT_EQ(rpc_error({code::overlap, "m", ""}).code, RpcCode::failed);
}

/// What a writer sends while `work` is done.
template <typename Work>
std::string sent_by(const Work& work) {
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe(ends.data()), 0);
  {
    MessageWriter writer(ends[1]);
    work(writer);
  }
  close(ends[1]);
  std::string all(4096, '\0');
  all.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(ends[0], all.data(), all.size()))));
  close(ends[0]);
  return all;
}

TEST(Rpc, SendsSingleAnswersAsTheyCome) {
  EXPECT_EQ(sent_by([](MessageWriter& writer) {
              const Sink sink = single_sink(writer);
              sink("1");
              sink(std::nullopt);
              sink("2");
            }),
            "1\n2\n");
}

TEST(Rpc, SendsTheAnswersOfAListTogether) {
  EXPECT_EQ(sent_by([](MessageWriter& writer) {
              const Sink sink = list_sink(writer, 3);
              sink("1");
              sink(std::nullopt);
            }),
            "")
      << "one is missing";
  EXPECT_EQ(sent_by([](MessageWriter& writer) {
              const Sink sink = list_sink(writer, 3);
              sink("1");
              sink(std::nullopt);
              sink("2");
            }),
            "[1,2]\n");
  EXPECT_EQ(sent_by([](MessageWriter& writer) {
              const Sink sink = list_sink(writer, 2);
              sink(std::nullopt);
              sink(std::nullopt);
            }),
            "")
      << "notifications have no answers";
}

}  // namespace
}  // namespace planish::serve
