#include "worker/frames.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>
#include <thread>

namespace planish::studio {
namespace {

using namespace std::chrono_literals;

/// Both ends of a socket pair.
class Frames : public testing::Test {
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

std::string all_bytes() {
  std::string bytes;
  for (int i = 0; i < 256; ++i)
    bytes += static_cast<char>(i);
  return bytes;
}

TEST_F(Frames, CarryTasksStagesAndAnswersOfAnyBytes) {
  ASSERT_TRUE(send_frame(there(), task_frame({"files", "dxf", all_bytes()})));
  ASSERT_TRUE(send_frame(there(), progress_frame({"checking\nit", 0.25})));
  ASSERT_TRUE(send_frame(there(), answer_frame({409, "text/plain", all_bytes()})));
  const auto task = task_of(receive_frame(here()).value());
  ASSERT_TRUE(task);
  EXPECT_EQ(task->verb, "files");
  EXPECT_EQ(task->argument, "dxf");
  EXPECT_EQ(task->body, all_bytes());
  const auto stage = stage_of(receive_frame(here()).value());
  ASSERT_TRUE(stage);
  EXPECT_EQ(stage->name, "checking\nit");
  EXPECT_EQ(stage->share, 0.25);
  const auto answer = answer_of(receive_frame(here()).value());
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 409);
  EXPECT_EQ(answer->type, "text/plain");
  EXPECT_EQ(answer->body, all_bytes());
}

TEST_F(Frames, MayBeLargerThanTheSocketHolds) {
  const std::string large(10'000'000, 'x');
  std::thread other([&] { send_frame(there(), answer_frame({200, "", large})); });
  const auto frame = receive_frame(here());
  other.join();
  ASSERT_TRUE(frame);
  EXPECT_EQ(answer_of(*frame)->body, large);
}

TEST_F(Frames, EndWithTheOtherSide) {
  say("\x03");
  hang_up();
  EXPECT_EQ(receive_frame(here()).error(), FrameFailure::ended);
  EXPECT_FALSE(send_frame(here(), task_frame({"draft", "", ""})));
}

TEST_F(Frames, AreLateAtTheirTime) {
  const auto soon = std::chrono::steady_clock::now() + 50ms;
  EXPECT_EQ(receive_frame(here(), soon).error(), FrameFailure::late);
  EXPECT_GE(std::chrono::steady_clock::now(), soon);
  say("\x03\x10");
  EXPECT_EQ(receive_frame(here(), soon).error(), FrameFailure::late);
}

TEST_F(Frames, OfAGigabyteAreNone) {
  say(std::string("\x03\xff\xff\xff\xff", 5));
  EXPECT_EQ(receive_frame(here()).error(), FrameFailure::ended);
}

TEST(FrameContents, ThatAreNoneAreEmpty) {
  for (const char* content : {"", "200", "200\n", "x\ny\nz", "-5\n\n", "99999\n\n"})
    EXPECT_FALSE(answer_of({FrameKind::answer, content})) << content;
  EXPECT_FALSE(stage_of({FrameKind::progress, "much\n\nname"}));
  EXPECT_FALSE(task_of({FrameKind::task, "draft"}));
  EXPECT_FALSE(task_of(answer_frame({200, "", ""})));
  EXPECT_FALSE(answer_of(task_frame({"200", "", ""})));
}

}  // namespace
}  // namespace planish::studio
