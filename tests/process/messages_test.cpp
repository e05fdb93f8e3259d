#include "messages.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>
#include <thread>

namespace planish::process {
namespace {

using namespace std::chrono_literals;

/// Both ends of a socket pair.
class Messages : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()), 0); }
  void TearDown() override {
    for (const int end : ends_)
      close(end);
  }
  int here() const { return ends_[0]; }
  int there() const { return ends_[1]; }
  void hang_up() {
    close(ends_[1]);
    ends_[1] = -1;
  }
  void say(const std::string& bytes) {
    ASSERT_EQ(send(there(), bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

std::string every_byte() {
  std::string bytes;
  for (int i = 0; i < 256; ++i)
    bytes += static_cast<char>(i);
  return bytes;
}

TEST_F(Messages, CarryTextsOfAnyBytes) {
  const Texts texts{"", every_byte(), "\n", every_byte() + every_byte()};
  for (const MessageKind kind : {MessageKind::question, MessageKind::failed}) {
    ASSERT_TRUE(send_message(there(), {kind, texts}));
    const auto message = receive_message(here());
    ASSERT_TRUE(message);
    EXPECT_EQ(message->kind, kind);
    EXPECT_EQ(message->texts, texts);
  }
  ASSERT_TRUE(send_message(there(), {MessageKind::answer, {}}));
  EXPECT_TRUE(receive_message(here())->texts.empty());
}

TEST_F(Messages, MayBeLargerThanTheSocketHolds) {
  const Texts large{std::string(10'000'000, 'x'), "y"};
  std::thread other([&] { send_message(there(), {MessageKind::answer, large}); });
  const auto message = receive_message(here());
  other.join();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->texts, large);
}

TEST_F(Messages, EndWithTheOtherSide) {
  say("\x03");
  hang_up();
  EXPECT_EQ(receive_message(here()).error(), MessageFailure::ended);
  EXPECT_FALSE(send_message(here(), {MessageKind::question, {"?"}}));
}

TEST_F(Messages, AreLateAtTheirTime) {
  Waiting soon{.until = std::chrono::steady_clock::now() + 50ms};
  EXPECT_EQ(receive_message(here(), soon).error(), MessageFailure::late);
  EXPECT_GE(std::chrono::steady_clock::now(), *soon.until);
  say("\x03\x10");
  EXPECT_EQ(receive_message(here(), soon).error(), MessageFailure::late);
}

TEST_F(Messages, AreWaitedForUntilCancelled) {
  int asked = 0;
  Waiting impatient{.cancelled = [&] { return ++asked > 2; }};
  EXPECT_EQ(receive_message(here(), impatient).error(), MessageFailure::cancelled);
}

TEST_F(Messages, OfDamagedBytesAreNone) {
  const std::string damaged[] = {
      std::string("\x04\xff\xff\xff\xff", 5),           // longer than any message
      std::string("\x07\0\0\0\0", 5),                   // of no kind
      std::string("\x04\x02\0\0\0ab", 7),               // too short for a text's length
      std::string("\x04\x08\0\0\0\x05\0\0\0abcd", 13),  // a text longer than the message
  };
  for (const std::string& bytes : damaged) {
    say(bytes);
    EXPECT_EQ(receive_message(here()).error(), MessageFailure::garbled);
    // What was left of it.
    std::array<char, 64> rest{};
    recv(here(), rest.data(), rest.size(), MSG_DONTWAIT);
  }
}

}  // namespace
}  // namespace planish::process
