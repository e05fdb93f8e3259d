// What a child may do to itself, and what whoever asked learns of it.
#include <planish/base/assert.hpp>
#include <planish/process/child_process.hpp>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

namespace planish::process {
namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Cause = ChildEnd::Cause;

constexpr int kSocket = 3;  // at which a child finds its socket

std::unique_ptr<ChildProcess> child(const Answering& answering,
                                    std::uint64_t memory = default_memory_limit()) {
  auto made = ChildProcess::copy(answering, memory);
  EXPECT_TRUE(made) << made.error().message;
  return std::move(*made);
}

/// How a child ends that does `misdeed` when it is asked.
ChildEnd end_after(const std::function<void()>& misdeed, std::chrono::milliseconds limit = 60s) {
  const auto process = child([&](const Texts&, const Parent& parent) {
    parent.progress.at("reading", 0.25);
    misdeed();
    return Texts{"nothing happened"};
  });
  const auto answer = process->ask({}, limit);
  if (answer) {
    ADD_FAILURE() << "it answered";
    return {};
  }
  EXPECT_EQ(answer.error().stage, "reading");
  return answer.error();
}

TEST(ChildProcess, AnswersAsOftenAsItIsAsked) {
  int times = 0;
  const auto process = child([&](const Texts& question, const Parent&) {
    return Texts{question[0] + question[0], std::to_string(++times)};
  });
  EXPECT_THAT(process->ask({"ab"}, 60s).value(), ElementsAre("abab", "1"));
  EXPECT_THAT(process->ask({""}, 60s).value(), ElementsAre("", "2"));
  EXPECT_TRUE(process->is_alive());
  EXPECT_EQ(times, 0) << "it is a process of its own";
}

TEST(ChildProcess, TellsStagesAndNotes) {
  const auto process = child([](const Texts&, const Parent& parent) {
    parent.progress.at("reading", 0.125);
    parent.note({"body", "3"});
    parent.progress.at("unfolding", 0.5);
    return Texts{};
  });
  std::vector<std::string> heard;
  Parent parent;
  parent.progress.report = [&](std::string_view stage, double share) {
    heard.push_back(std::string(stage) + " " + std::to_string(share));
  };
  parent.note = [&](const Texts& note) { heard.push_back(note[0] + " " + note[1]); };
  ASSERT_TRUE(process->ask({}, 60s, parent));
  EXPECT_THAT(heard, ElementsAre("reading 0.125000", "body 3", "unfolding 0.500000"));
}

TEST(ChildProcess, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const auto process = child([](const Texts&, const Parent&) {
    std::puts("kernel noise");
    std::fputs("more of it", stderr);
    std::fflush(nullptr);
    return Texts{"done"};
  });
  EXPECT_TRUE(process->ask({}, 60s));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ChildProcess, ThatSegfaultsHasCrashed) {
  const ChildEnd end = end_after([] { std::raise(SIGSEGV); });
  EXPECT_EQ(end.cause, Cause::crashed);
  EXPECT_FALSE(end.reason.empty());
}

TEST(ChildProcess, ThatAbortsHasCrashed) {
  const ChildEnd end = end_after([] { std::abort(); });
  EXPECT_EQ(end.cause, Cause::crashed);
  EXPECT_EQ(end.reason, "aborted");
}

TEST(ChildProcess, SaysWhichAssertionEndedIt) {
  const ChildEnd end = end_after([] { PLANISH_ASSERT(1 + 1 == 3); });
  EXPECT_EQ(end.cause, Cause::crashed);
  EXPECT_THAT(end.reason, HasSubstr("assertion failed: 1 + 1 == 3 ("));
}

TEST(ChildProcess, ThatThrowsHasCrashedOfWhatItThrew) {
  EXPECT_EQ(end_after([] { throw std::runtime_error("row 7"); }).reason, "row 7");
  EXPECT_EQ(end_after([] { throw 7; }).reason, "an exception of unknown type");
}

TEST(ChildProcess, ThatHangsIsOutOfTime) {
  const auto begun = steady_clock::now();
  const ChildEnd end = end_after([] { std::this_thread::sleep_for(1h); }, 200ms);
  EXPECT_EQ(end.cause, Cause::out_of_time);
  EXPECT_GE(steady_clock::now() - begun, 200ms);
  EXPECT_LT(steady_clock::now() - begun, 20s);
}

TEST(ChildProcess, ThatTellsWithoutEndIsOutOfTime) {
  const auto process = child([](const Texts&, const Parent& parent) {
    for (int i = 0;; ++i)
      parent.note({std::to_string(i)});
    return Texts{};
  });
  const auto answer = process->ask({}, 200ms);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().cause, Cause::out_of_time);
}

TEST(ChildProcess, ThatAllocatesWithoutEndIsOutOfMemory) {
  if (default_memory_limit() == 0) GTEST_SKIP() << "built with sanitizers, which need any amount";
  constexpr std::uint64_t kLimit = std::uint64_t{1} << 30;
  const auto process = child(
      [](const Texts&, const Parent&) {
        Texts all;
        for (;;)
          all.emplace_back(1 << 24, 'x');
        return all;
      },
      kLimit);
  const auto answer = process->ask({}, 60s);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().cause, Cause::out_of_memory);
}

TEST(ChildProcess, ThatTheSystemKillsIsOutOfMemory) {
  EXPECT_EQ(end_after([] { std::raise(SIGKILL); }).cause, Cause::out_of_memory);
}

TEST(ChildProcess, ThatEndsEarlyHasCrashed) {
  const ChildEnd end = end_after([] { _exit(0); });
  EXPECT_EQ(end.cause, Cause::crashed);
  EXPECT_EQ(end.reason, "exit status 0");
}

TEST(ChildProcess, ThatAnswersHalfHasCrashed) {
  const ChildEnd end = end_after([] {
    const std::string half("\x04\x20\0\0\0\x10\0\0\0half", 13);
    send(kSocket, half.data(), half.size(), 0);
    _exit(0);
  });
  EXPECT_EQ(end.cause, Cause::crashed);
}

TEST(ChildProcess, ThatAnswersGarbageHasCrashed) {
  const ChildEnd end = end_after([] {
    const std::string garbage = "ISO-10303-21;HEADER;";
    send(kSocket, garbage.data(), garbage.size(), 0);
    std::this_thread::sleep_for(1h);
  });
  EXPECT_EQ(end.cause, Cause::crashed);
  EXPECT_EQ(end.reason, kDamagedAnswer);
}

TEST(ChildProcess, ThatClosesItsSocketIsNotWaitedFor) {
  const ChildEnd end = end_after([] {
    close(kSocket);
    std::this_thread::sleep_for(1h);
  });
  EXPECT_EQ(end.cause, Cause::crashed);
  EXPECT_EQ(end.reason, "it closed its socket");
}

TEST(ChildProcess, IsCancelledAtOnce) {
  const auto process = child([](const Texts&, const Parent&) {
    std::this_thread::sleep_for(1h);
    return Texts{};
  });
  Parent parent;
  const auto begun = steady_clock::now();
  parent.progress.cancelled = [&] { return steady_clock::now() - begun > 100ms; };
  const auto answer = process->ask({}, 1h, parent);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().cause, Cause::cancelled);
  EXPECT_LT(steady_clock::now() - begun, 10s);
}

TEST(ChildProcess, IsEndedWithItsObject) {
  pid_t process = 0;
  {
    const auto living = child(
        [](const Texts&, const Parent&) { return Texts{std::to_string(getpid())}; });
    process = std::stoi(living->ask({}, 60s).value()[0]);
    EXPECT_EQ(::kill(process, 0), 0);
  }
  EXPECT_EQ(::kill(process, 0), -1);
  EXPECT_EQ(errno, ESRCH);
}

TEST(ChildProcess, IsEndedWithItsParent) {
  // The parent is a child itself, and tells its child's number before it is killed.
  pid_t grandchild = 0;
  const auto parent = child([](const Texts&, const Parent& asks) {
    auto made = ChildProcess::copy(
        [](const Texts&, const Parent&) { return Texts{std::to_string(getpid())}; }, 0);
    asks.note((*made)->ask({}, 60s).value());
    std::raise(SIGKILL);
    return Texts{};
  });
  Parent asks;
  asks.note = [&](const Texts& note) { grandchild = std::stoi(note[0]); };
  EXPECT_FALSE(parent->ask({}, 60s, asks));
  ASSERT_GT(grandchild, 0);
  const auto is_there = [&] {
    std::ifstream stat("/proc/" + std::to_string(grandchild) + "/stat");
    std::string number, name, state;
    return static_cast<bool>(stat >> number >> name >> state) && state != "Z";
  };
  for (int i = 0; i < 200 && is_there(); ++i)
    std::this_thread::sleep_for(50ms);
  EXPECT_FALSE(is_there());
}

TEST(ChildProcess, IsStartedWhereStandardOutputIsClosed) {
  // In a process of its own, since this one needs its output.
  const auto closed = child([](const Texts&, const Parent&) {
    close(STDIN_FILENO);
    close(STDOUT_FILENO);
    auto made = ChildProcess::copy([](const Texts& question, const Parent&) { return question; },
                                   0);
    return (*made)->ask({"still understood"}, 60s).value();
  });
  EXPECT_THAT(closed->ask({}, 60s).value(), ElementsAre("still understood"));
}

TEST(ChildProcess, KeepsNoOtherDescriptors) {
  const int other = fcntl(STDIN_FILENO, F_DUPFD, 2 * kSocket);
  ASSERT_GE(other, 0);
  const auto process = child([&](const Texts&, const Parent&) {
    return Texts{fcntl(other, F_GETFD) < 0 ? "closed" : "open"};
  });
  EXPECT_THAT(process->ask({}, 60s).value(), ElementsAre("closed"));
  close(other);
}

TEST(ErrorOfAChild, NamesInputStageAndLimit) {
  const Limits limits{1500ms, std::uint64_t{512} << 20};
  const Error crash = error_of({Cause::crashed, "segmentation fault", "reading"}, "a.step", limits);
  EXPECT_EQ(crash.code, code::crashed);
  EXPECT_EQ(exit_status(crash.code), 3);
  for (const char* part : {"a.step", "\"reading\"", "(segmentation fault)", "export it again"})
    EXPECT_THAT(crash.message, HasSubstr(part));
  const Error late = error_of({Cause::out_of_time}, "a.step", limits);
  EXPECT_EQ(exit_status(late.code), 4);
  EXPECT_THAT(late.message, HasSubstr("a.step was given up after 1.5 s. "));
  const Error large = error_of({Cause::out_of_memory}, "a.step", limits);
  EXPECT_EQ(exit_status(large.code), 4);
  EXPECT_THAT(large.message, HasSubstr("512 MiB"));
}

}  // namespace
}  // namespace planish::process
