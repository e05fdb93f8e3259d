#include <planish/process/worker.hpp>

#include <gtest/gtest.h>

#include <charconv>
#include <cstdlib>
#include <thread>

namespace planish::process {
namespace {

using namespace std::chrono_literals;
using Cause = ChildEnd::Cause;

/// "double" doubles a number, "steps" tells so many notes, "lengthen" answers with so many bytes;
/// the others end the process or hang.
struct Chore {
  std::string what;
  int number = 0;
};

Texts texts_of(const Chore& chore) { return {chore.what, std::to_string(chore.number)}; }

struct Doubled {
  int number = 0;
  std::string bytes = {};
};

Texts texts_of(const Doubled& doubled) { return {std::to_string(doubled.number), doubled.bytes}; }

std::optional<Doubled> doubled_in(const Texts& texts) {
  if (texts.size() != 2) return std::nullopt;
  int number = 0;
  const auto read = std::from_chars(texts[0].data(), texts[0].data() + texts[0].size(), number);
  return read.ec == std::errc() ? std::optional(Doubled{number, texts[1]}) : std::nullopt;
}

std::optional<Chore> chore_in(const Texts& texts) {
  if (texts.size() != 2) return std::nullopt;
  return Chore{texts[0], std::atoi(texts[1].c_str())};
}

constexpr auto kStep = 50ms, kStepLimit = 600ms;

Doubled performed(const Chore& chore, const Parent& parent) {
  if (chore.what == "crash") std::abort();
  if (chore.what == "hang") std::this_thread::sleep_for(1h);
  if (chore.what == "swell") std::string().resize(std::size_t{1} << 40);
  if (chore.what == "lengthen")
    return {chore.number, std::string(static_cast<std::size_t>(chore.number), '\0')};
  for (int i = 0; chore.what == "steps" && i < chore.number; ++i) {
    std::this_thread::sleep_for(kStep);
    parent.progress.at("step", 0.0);
    parent.note({std::to_string(i)});
  }
  return {2 * chore.number};
}

using Doubler = Worker<Chore, Doubled>;

Starting doubler(std::uint64_t memory = 0) {
  return [memory] { return ChildProcess::copy(answering<Chore>(chore_in, performed), memory); };
}

TEST(Worker, DoesOneTaskAfterAnotherInTheSameProcess) {
  Doubler worker(doubler(), doubled_in);
  EXPECT_FALSE(worker.is_alive());
  for (int i = 1; i <= 3; ++i) {
    ASSERT_TRUE(worker.begin());
    EXPECT_EQ(worker.work_on({"double", i}, {.time = 10s}).value().number, 2 * i);
    EXPECT_EQ(worker.done(), i);
  }
}

TEST(Worker, SaysHowItsProcessEndedAndGetsAnother) {
  Doubler worker(doubler(), doubled_in);
  ASSERT_TRUE(worker.begin());
  const auto crashed = worker.work_on({"crash"}, {.time = 10s});
  ASSERT_FALSE(crashed);
  EXPECT_EQ(crashed.error().cause, Cause::crashed);
  EXPECT_FALSE(worker.is_alive());
  ASSERT_TRUE(worker.begin());
  EXPECT_EQ(worker.done(), 0);
  EXPECT_EQ(worker.work_on({"double", 4}, {.time = 10s}).value().number, 8);
}

TEST(Worker, IsHeldToItsMemory) {
  if (default_memory_limit() == 0) GTEST_SKIP() << "built with sanitizers, which need any amount";
  Doubler worker(doubler(std::uint64_t{1} << 30), doubled_in);
  ASSERT_TRUE(worker.begin());
  EXPECT_EQ(worker.work_on({"swell"}, {.time = 10s}).error().cause, Cause::out_of_memory);
  EXPECT_FALSE(worker.is_alive());
}

TEST(Worker, CarriesAnswersOfMegabytes) {
  constexpr int kBytes = (20 << 20) + 1;
  Doubler worker(doubler(), doubled_in);
  ASSERT_TRUE(worker.begin());
  for (int i = 0; i < 2; ++i) {
    const auto done = worker.work_on({"lengthen", kBytes}, {.time = 60s});
    ASSERT_TRUE(done);
    EXPECT_EQ(done->bytes, std::string(kBytes, '\0'));
  }
  EXPECT_EQ(worker.done(), 2);
}

TEST(Worker, SendsTasksOfMegabytes) {
  const std::string what(20 << 20, 'x');
  Doubler worker(doubler(), doubled_in);
  ASSERT_TRUE(worker.begin());
  EXPECT_EQ(worker.work_on({what, 3}, {.time = 60s}).value().number, 6);
}

TEST(Worker, GivesUpWhatTakesTooLong) {
  Doubler worker(doubler(), doubled_in);
  ASSERT_TRUE(worker.begin());
  EXPECT_EQ(worker.work_on({"hang"}, {.time = 30ms}).error().cause, Cause::out_of_time);
  ASSERT_TRUE(worker.begin());
  EXPECT_EQ(worker.work_on({"hang"}, {.time = 30ms, .by_step = true}).error().cause,
            Cause::out_of_time);
}

TEST(Worker, GivesEachStepItsTime) {
  Doubler worker(doubler(), doubled_in);
  ASSERT_TRUE(worker.begin());
  Texts notes;
  const Parent parent{.progress = {},
                      .note = [&](const Texts& note) { notes.push_back(note.at(0)); }};
  // Longer altogether than a step may take.
  const auto done = worker.work_on({"steps", 20}, {kStepLimit, parent, true});
  EXPECT_EQ(done.value().number, 40);
  ASSERT_EQ(notes.size(), 20U);
  EXPECT_EQ(notes.back(), "19");
  EXPECT_EQ(worker.work_on({"steps", 40}, {kStepLimit, parent}).error().cause, Cause::out_of_time);
}

TEST(Worker, IsCancelledByWhoAsks) {
  for (const bool by_step : {false, true}) {
    Doubler worker(doubler(), doubled_in);
    ASSERT_TRUE(worker.begin());
    const Parent parent{.progress = {.report = {}, .cancelled = [] { return true; }}, .note = {}};
    EXPECT_EQ(worker.work_on({"hang"}, {10s, parent, by_step}).error().cause, Cause::cancelled);
  }
}

TEST(Worker, IsKilledFromAnotherThread) {
  Doubler worker(doubler(), doubled_in);
  ASSERT_TRUE(worker.begin());
  std::thread other([&] {
    std::this_thread::sleep_for(kStep);
    worker.kill();
  });
  EXPECT_TRUE(worker.work_on({"hang"}, {.time = 10s}).error().from_outside);
  other.join();
}

TEST(Worker, ThatWasEndedMeanwhileGivesNoAnswer) {
  Doubler worker(doubler(), doubled_in);
  ASSERT_TRUE(worker.begin());
  worker.end();
  EXPECT_EQ(worker.work_on({"double", 1}, {.time = 10s}).error().cause, Cause::crashed);
}

TEST(Worker, WhoseProcessDoesNotStartSaysSo) {
  Doubler worker(
      []() -> Result<std::unique_ptr<ChildProcess>> { return fail(code::internal, "no room"); },
      doubled_in);
  EXPECT_EQ(worker.begin().error().message, "no room");
  EXPECT_FALSE(worker.is_alive());
}

TEST(Worker, GivesNothingForATaskThatItsProcessCannotRead) {
  EXPECT_EQ(answering<Chore>(chore_in, performed)({"one text"}, {}), Texts());
}

TEST(Worker, TakesAnAnswerThatNobodyUnderstandsForACrash) {
  const auto mumbling = [] {
    return ChildProcess::copy([](const Texts&, const Parent&) { return Texts{"a", "b"}; }, 0);
  };
  Doubler worker(mumbling, doubled_in);
  ASSERT_TRUE(worker.begin());
  const auto done = worker.work_on({"double", 1}, {.time = 10s});
  EXPECT_EQ(done.error().cause, Cause::crashed);
  EXPECT_EQ(done.error().reason, kDamagedAnswer);
  EXPECT_FALSE(worker.is_alive());
}

}  // namespace
}  // namespace planish::process
