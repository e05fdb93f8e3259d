#include "framing.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <thread>
#include <vector>

namespace planish::serve {
namespace {

using Kind = Incoming::Kind;

bool never() { return false; }

/// What is read of bytes that come in pieces of `piece`, with the messages of at most 20 bytes.
std::vector<std::string> heard(const std::string& bytes, std::size_t piece) {
  constexpr std::size_t kLongest = 20;
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return {};
  std::thread writing([&] {
    for (std::size_t i = 0; i < bytes.size(); i += piece) {
      const std::string some = bytes.substr(i, piece);
      EXPECT_EQ(::write(ends[1], some.data(), some.size()), static_cast<ssize_t>(some.size()));
    }
    close(ends[1]);
  });
  std::vector<std::string> all;
  MessageReader reader(ends[0], kLongest, never);
  for (auto one = reader.next(); one.kind != Kind::end_of_input; one = reader.next()) {
    all.push_back(one.kind == Kind::message    ? one.text
                  : one.kind == Kind::too_long ? "(too long)"
                                               : "(no length)");
    if (one.kind == Kind::no_length) break;
  }
  writing.join();
  close(ends[0]);
  return all;
}

using Texts = std::vector<std::string>;

TEST(MessageReader, TakesLinesHoweverTheyCome) {
  for (const std::size_t piece : {1, 2, 3, 7, 1000})
    EXPECT_EQ(heard("{}\n\n \r\n[1]\r\n{\"a\":2}", piece), (Texts{"{}", "[1]\r", "{\"a\":2}"}));
}

TEST(MessageReader, LeavesOutLinesThatAreTooLong) {
  const std::string fits(20, 'x'), longer(21, 'x'), much(100000, 'x');
  for (const std::size_t piece : {1000, 65536})
    EXPECT_EQ(heard(fits + "\n" + longer + "\n1\n" + much + "\n2\n" + much, piece),
              (Texts{fits, "(too long)", "1", "(too long)", "2", "(too long)"}));
}

TEST(MessageReader, TakesHeadersHoweverTheyCome) {
  for (const std::size_t piece : {1, 2, 5, 1000})
    EXPECT_EQ(heard("Content-Length: 2\r\n\r\n{}CONTENT-TYPE: x\r\ncontent-length:3 \r\n\r\n[1]"
                    "Content-Length: 0\r\n\r\nContent-Length: 1\n\n7",
                    piece),
              (Texts{"{}", "[1]", "", "7"}));
}

TEST(MessageReader, LeavesOutMessagesThatAreTooLong) {
  const std::string much(100000, 'x');
  EXPECT_EQ(heard("Content-Length: 100000\r\n\r\n" + much + "Content-Length: 1\r\n\r\n1", 1000),
            (Texts{"(too long)", "1"}));
}

TEST(MessageReader, EndsWhereNobodyKnowsTheLength) {
  for (const std::string header :
       {"Content-Type: x", "Content-Length: x", "Content-Length: -1", "Content-Length: 1x"})
    EXPECT_EQ(heard(header + "\r\n\r\n{}", 1000), (Texts{"(no length)"}));
  EXPECT_EQ(heard("Content-Length: 9\r\n\r\n{}", 1000), Texts{});
}

TEST(MessageWriter, FramesAsTheReaderReads) {
  for (const Framing framing : {Framing::lines, Framing::headers}) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe(ends.data()), 0);
    MessageWriter writer(ends[1]);
    writer.use(framing);
    const Texts sent{"{}", "[1, 2]", "\"ä\""};
    for (const std::string& one : sent)
      writer.send(one);
    EXPECT_FALSE(writer.is_closed());
    close(ends[1]);
    MessageReader reader(ends[0], 100, never);
    Texts all;
    for (auto one = reader.next(); one.kind == Kind::message; one = reader.next())
      all.push_back(one.text);
    EXPECT_EQ(all, sent);
    EXPECT_EQ(reader.framing(), framing);
    close(ends[0]);
  }
}

TEST(MessageWriter, KnowsThatNobodyReads) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  MessageWriter writer(ends[1]);
  EXPECT_FALSE(writer.is_closed());
  close(ends[0]);
  EXPECT_TRUE(writer.is_closed());
  close(ends[1]);
}

}  // namespace
}  // namespace planish::serve
