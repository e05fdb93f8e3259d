#include "job/job_requests.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::job {
namespace {

using nlohmann::json;
using test::done_by;
using test::error_by;

TEST(RunInfo, SaysTheSameOfAFileAndOfItsContent) {
  const std::string path = test::example("bracket.step");
  json asked{{"maker", "info"}, {"input", path}, {"sheets", true}};
  const RunResult of_file = done_by(asked);
  asked["input"] = {{"name", path}, {"content", test::bytes_of_file(path)}};
  EXPECT_EQ(done_by(asked).report, of_file.report);
  EXPECT_EQ(of_file.status, Status::ok);
  EXPECT_THAT(of_file.summary, ::testing::HasSubstr("bracket"));
  const json report = json::parse(of_file.report);
  EXPECT_EQ(report["units"], "mm");
  EXPECT_EQ(report["bodies"][0]["sheet"]["bends"], 2);
  asked.erase("sheets");
  EXPECT_FALSE(json::parse(done_by(asked).report)["bodies"][0].contains("sheet"));
}

TEST(RunInfo, TakesItsOptionsAndNoOthers) {
  json asked{{"maker", "info"}, {"input", test::example("bracket.step")}};
  asked["options"] = {{"units", "inch"}, {"body", 1}};
  EXPECT_EQ(json::parse(done_by(asked).report)["units"], "inch");
  asked["options"] = {{"body", 2}};
  EXPECT_EQ(error_by(asked).where, "/options/body");
  asked["options"] = {{"k", 0.4}};
  EXPECT_EQ(error_by(asked).where, "/options/k");
  asked["options"] = json::object();
  asked["artifacts"] = {"json"};
  EXPECT_EQ(error_by(asked).where, "/artifacts/0");
}

TEST(RunInfo, HandsOnWhatCannotBeRead) {
  EXPECT_EQ(error_by({{"maker", "info"}, {"input", "/no/such.step"}}).code, code::cannot_read);
  EXPECT_EQ(error_by({{"maker", "info"}, {"input", {{"name", "a.step"}, {"content", "x"}}}}).where,
            "a.step");
}

}  // namespace
}  // namespace planish::job
