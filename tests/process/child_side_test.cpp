#include "child_side.hpp"

#include "messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <new>
#include <stdexcept>
#include <thread>

// The side of a child, in a thread of this process: what goes over its socket.

namespace planish::process {
namespace {

using ::testing::ElementsAre;

/// Asks as a parent does, with the other end of the socket.
class AnsweringThread {
 public:
  explicit AnsweringThread(const Answering& answering, const std::function<void()>& after = {}) {
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()), 0);
    thread_ = std::thread([=, this] { status_ = answer_questions(ends_[1], answering, after); });
  }
  ~AnsweringThread() { (void)end(); }
  void ask(const Texts& texts, MessageKind kind = MessageKind::question) {
    EXPECT_TRUE(send_message(ends_[0], {kind, texts}));
  }
  Message heard() {
    auto message = receive_message(ends_[0]);
    EXPECT_TRUE(message);
    return message ? *message : Message{};
  }
  /// Nobody asks any more; the exit status.
  int end() {
    if (ends_[0] >= 0) close(std::exchange(ends_[0], -1));
    if (thread_.joinable()) {
      thread_.join();
      close(ends_[1]);
    }
    return status_;
  }

 private:
  std::array<int, 2> ends_{};
  std::thread thread_;
  int status_ = -1;
};

TEST(ChildSide, AnswersUntilNobodyAsks) {
  int after = 0;
  AnsweringThread child(
      [](const Texts& question, const Parent&) { return Texts{question[0] + "!"}; },
      [&] { ++after; });
  for (const char* word : {"a", "b"}) {
    child.ask({word});
    const Message answer = child.heard();
    EXPECT_EQ(answer.kind, MessageKind::answer);
    EXPECT_THAT(answer.texts, ElementsAre(std::string(word) + "!"));
  }
  EXPECT_EQ(child.end(), 0);
  EXPECT_EQ(after, 2) << "after each answer";
}

TEST(ChildSide, TellsStagesAndNotesBeforeItsAnswer) {
  AnsweringThread child([](const Texts&, const Parent& parent) {
    parent.progress.at("reading", 0.25);
    for (int i = 0; i < 1000; ++i)
      parent.progress.at("reading", 0.5);
    parent.progress.at("bending", 0.75);
    parent.note({"part.step", "2"});
    return Texts{};
  });
  child.ask({});
  std::vector<std::string> stages;
  Message message = child.heard();
  for (; message.kind == MessageKind::stage; message = child.heard())
    stages.push_back(message.texts.at(0) + " " + message.texts.at(1));
  ASSERT_GE(stages.size(), 2u);
  EXPECT_LT(stages.size(), 100u) << "shares of one stage are told now and then";
  EXPECT_EQ(stages.front(), "reading 0.25");
  EXPECT_EQ(stages.back(), "bending 0.75") << "a new stage at once";
  EXPECT_EQ(message.kind, MessageKind::note);
  EXPECT_THAT(message.texts, ElementsAre("part.step", "2"));
  EXPECT_EQ(child.heard().kind, MessageKind::answer);
}

TEST(ChildSide, SaysWhatWasThrown) {
  AnsweringThread child([](const Texts& question, const Parent&) -> Texts {
    if (question[0] == "memory") throw std::bad_alloc();
    if (question[0] == "number") throw 7;
    throw std::runtime_error("defect");
  });
  child.ask({"defect"});
  const Message defect = child.heard();
  EXPECT_EQ(defect.kind, MessageKind::failed);
  EXPECT_THAT(defect.texts, ElementsAre("defect"));
  child.ask({"memory"});
  EXPECT_TRUE(child.heard().texts.empty()) << "memory has no words";
  child.ask({"number"});
  EXPECT_EQ(child.heard().texts.size(), 1u);
  EXPECT_EQ(child.end(), 0) << "and it goes on";
}

TEST(ChildSide, EndsWhereItHearsNoQuestion) {
  AnsweringThread child([](const Texts&, const Parent&) { return Texts{}; });
  child.ask({}, MessageKind::answer);
  EXPECT_EQ(child.end(), 1);
}

/// The exit status of a child that does this.
int status_of_child(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(ChildSide, SettlesUnderItsParentAlone) {
  const pid_t here = getpid();
  EXPECT_EQ(status_of_child([=] { return settle_in(here, 0) ? 10 : 11; }), 10);
  EXPECT_EQ(status_of_child([=] { return settle_in(here + 1, 0) ? 10 : 11; }), 11);
  EXPECT_EQ(status_of_child([=] { return answer_parent("1", {}, {}, 0); }), 1)
      << "its parent is another";
}

TEST(ChildSide, LimitsItsMemoryAndLeavesNoCore) {
  const pid_t here = getpid();
  constexpr rlim_t kLarge = rlim_t{1} << 44;
  EXPECT_EQ(status_of_child([=] {
              settle_in(here, kLarge);
              rlimit memory{}, core{};
              getrlimit(RLIMIT_AS, &memory);
              getrlimit(RLIMIT_CORE, &core);
              return memory.rlim_cur == kLarge && core.rlim_max == 0 ? 10 : 11;
            }),
            10);
  EXPECT_EQ(status_of_child([=] {
              rlimit before{}, after{};
              getrlimit(RLIMIT_AS, &before);
              settle_in(here, 0);
              getrlimit(RLIMIT_AS, &after);
              return before.rlim_cur == after.rlim_cur ? 10 : 11;
            }),
            10)
      << "0 is no limit";
}

TEST(ChildSide, LetsSignalsEndItButNotCtrlC) {
  const pid_t here = getpid();
  EXPECT_EQ(status_of_child([=] {
              std::signal(SIGTERM, SIG_IGN);
              settle_in(here, 0);
              std::raise(SIGINT);
              std::raise(SIGTERM);
              return 10;
            }),
            -SIGTERM);
}

}  // namespace
}  // namespace planish::process
