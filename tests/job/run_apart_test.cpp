#include <planish/base/assert.hpp>
#include <planish/brake/codes.hpp>
#include <planish/job/run.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <string>
#include <thread>

namespace planish::job {
using namespace process;
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

std::string request_of(const std::string& maker, const std::string& file,
                       const std::string& artifact) {
  return nlohmann::json{{"maker", maker},
                        {"input", PLANISH_SOURCE_DIR "/examples/" + file},
                        {"artifacts", {artifact}}}
      .dump();
}

using Open = decltype(Maker::open);

/// `connect`, but for what happens to it as it opens its input.
Catalogue opening_by(Open open) {
  Catalogue catalogue = built_in();
  for (Maker& maker : catalogue.makers)
    if (maker.name == "connect") maker.open = open;
  return catalogue;
}

Error error_by(Open open, const Progress& progress = {}, const Limits& limits = {}) {
  const auto result = run_apart(request_of("connect", "connect/a_folded.json", "dxf"), progress,
                                limits, opening_by(open));
  EXPECT_FALSE(result);
  return result ? Error{} : Error{result.error()};
}

TEST(RunApart, GivesWhatRunGives) {
  for (const auto& [maker, file] :
       {std::pair("unfold", "bracket.step"), std::pair("connect", "connect/a_folded.json"),
        std::pair("transition", "transition/a_square_to_round.json")}) {
    const std::string request = request_of(maker, file, "svg");
    const auto here = run(request), apart = run_apart(request);
    ASSERT_TRUE(here) << here.error().message;
    ASSERT_TRUE(apart) << apart.error().message;
    EXPECT_EQ(apart->status, here->status);
    // Reports say how long it took.
    auto report = nlohmann::json::parse(apart->report), other = nlohmann::json::parse(here->report);
    report.erase("timing");
    other.erase("timing");
    EXPECT_EQ(report, other);
    EXPECT_EQ(apart->summary, here->summary);
    ASSERT_EQ(apart->artifacts.size(), 1u);
    EXPECT_EQ(apart->artifacts[0].artifact, here->artifacts[0].artifact);
    EXPECT_EQ(apart->artifacts[0].name, here->artifacts[0].name);
    EXPECT_EQ(apart->artifacts[0].media_type, here->artifacts[0].media_type);
    EXPECT_EQ(apart->artifacts[0].bytes, here->artifacts[0].bytes);
  }
}

TEST(RunApart, MayBeCalledWhileOthersRun) {
  const std::string request = request_of("unfold", "bracket.step", "dxf");
  const auto alone = run(request);
  ASSERT_TRUE(alone);
  std::vector<std::thread> threads;
  for (int i = 0; i < 6; ++i)
    threads.emplace_back([&, i] {
      for (int round = 0; round < 3; ++round) {
        const auto result = i % 2 == 0 ? run_apart(request) : run(request);
        ASSERT_TRUE(result) << result.error().message;
        EXPECT_EQ(result->artifacts[0].bytes, alone->artifacts[0].bytes);
      }
    });
  for (std::thread& thread : threads)
    thread.join();
}

TEST(RunApart, HandsOnARefusal) {
  const std::string request = R"({"maker": "bend", "input": ")" PLANISH_SOURCE_DIR
                              R"(/examples/connect/a_folded.json", "artifacts": ["json", "svg"],
                                  "options": {"clearance": 100}})";
  const auto here = run(request), apart = run_apart(request);
  ASSERT_FALSE(here);
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().code, code::cannot_bend);
  EXPECT_EQ(apart.error().message, here.error().message);
  EXPECT_EQ(apart.error().places, here.error().places);
  ASSERT_TRUE(here.error().shown);
  ASSERT_TRUE(apart.error().shown);
  EXPECT_EQ(apart.error().shown->status, Status::refused);
  EXPECT_EQ(apart.error().shown->artifacts.size(), 2u);
  EXPECT_EQ(here.error().shown->artifacts.size(), 2u);
}

TEST(RunApart, HandsOnErrorsAndProgress) {
  const std::string missing = request_of("unfold", "missing.step", "dxf");
  const auto here = run(missing), apart = run_apart(missing);
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().code, here.error().code);
  EXPECT_EQ(apart.error().message, here.error().message);
  EXPECT_EQ(apart.error().where, here.error().where);
  std::vector<std::string> stages;
  Progress progress;
  progress.report = [&](std::string_view stage, double) { stages.emplace_back(stage); };
  ASSERT_TRUE(run_apart(request_of("unfold", "bracket.step", "dxf"), progress));
  EXPECT_THAT(stages, ::testing::Contains("finding the sheet"));
}

TEST(RunApart, SurvivesACrash) {
  const Error error = error_by([](const InputFile&, const Progress& progress) {
    progress.at("reading", 0.5);
    std::raise(SIGSEGV);
    return Result<std::unique_ptr<Work>>();
  });
  EXPECT_EQ(error.code, code::crashed);
  EXPECT_THAT(error.message, HasSubstr("a_folded.json"));
  EXPECT_THAT(error.message, HasSubstr("\"reading\""));
}

TEST(RunApart, SurvivesAnAssertion) {
  const Error error = error_by([](const InputFile&, const Progress&) {
    PLANISH_ASSERT(1 + 1 == 3);
    return Result<std::unique_ptr<Work>>();
  });
  EXPECT_EQ(error.code, code::crashed);
  EXPECT_THAT(error.message, HasSubstr("assertion failed: 1 + 1 == 3"));
}

TEST(RunApart, EndsAtItsTimeAndWhenCancelled) {
  const Open hang = [](const InputFile&, const Progress&) {
    std::this_thread::sleep_for(1h);
    return Result<std::unique_ptr<Work>>();
  };
  EXPECT_EQ(error_by(hang, {}, {.time = 100ms}).code, code::out_of_time);
  const Progress cancelled{.report = {}, .cancelled = [] { return true; }};
  EXPECT_EQ(error_by(hang, cancelled).code, code::cancelled);
}

}  // namespace
}  // namespace planish::job
