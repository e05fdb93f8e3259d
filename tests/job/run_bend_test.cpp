#include "job/job_requests.hpp"

#include <planish/brake/codes.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::job {
namespace {

using nlohmann::json;
using test::channel_plates;
using test::done_by;
using test::error_by;
using ::testing::HasSubstr;
using ::testing::StartsWith;

json bending_of(const json& plates) {
  return {{"maker", "bend"}, {"input", {{"name", "channel.json"}, {"content", plates}}}};
}

TEST(RunBend, PlansWhateverAMakerMakes) {
  json asked = bending_of(channel_plates(30));
  asked["options"] = {{"springback", 1.0}, {"metal", "steel"}};
  asked["artifacts"] = {"json", "svg", "pdf"};
  const RunResult bent = done_by(asked);
  const json report = json::parse(bent.report);
  EXPECT_EQ(report["command"], "bend");
  EXPECT_EQ(report["plan"]["status"], "optimal");
  EXPECT_EQ(report["plan"]["strokes"].size(), 2u);
  EXPECT_NE(bent.status, Status::refused);
  EXPECT_THAT(bent.summary, HasSubstr("2 strokes"));
  ASSERT_EQ(bent.artifacts.size(), 3u);
  EXPECT_EQ(bent.artifacts[0].name, "channel_plan.json");
  EXPECT_EQ(bent.artifacts[0].bytes, bent.report);
  EXPECT_EQ(bent.artifacts[1].name, "channel_plan.svg");
  EXPECT_EQ(bent.artifacts[1].media_type, "image/svg+xml");
  EXPECT_THAT(bent.artifacts[1].bytes, HasSubstr("<svg"));
  EXPECT_THAT(bent.artifacts[1].bytes, HasSubstr("bend plan 1 / 2"));
  EXPECT_THAT(bent.artifacts[2].bytes, StartsWith("%PDF"));
}

TEST(RunBend, ShowsOnAPageWhyAPartCannotBeBent) {
  json asked = bending_of(channel_plates(250));
  asked["artifacts"] = {"svg", "dxf", "json"};
  const RunResult bent = done_by(asked);
  EXPECT_EQ(bent.status, Status::refused);
  EXPECT_EQ(error_by(asked).code, code::cannot_bend);
  EXPECT_EQ(bent.artifacts.size(), 2u);
}

TEST(RunBend, DrawsNothingWhereThereIsNoPattern) {
  json plates = channel_plates(30);
  plates["plates"][1]["outline"] = {
      {-60, 0, 0}, {-5, 0, 0}, {-5, 100, 0}, {-60, 100, 0}};  // in the plane of the web
  json asked = bending_of(plates);
  asked["artifacts"] = {"svg", "json"};
  const RunResult bent = done_by(asked);
  EXPECT_EQ(bent.status, Status::refused);
  ASSERT_EQ(bent.artifacts.size(), 1u);
  EXPECT_EQ(bent.artifacts[0].artifact, "json");
}

TEST(RunBend, TakesNoOptionsOrArtifactsOfPatterns) {
  json asked = bending_of(channel_plates(30));
  asked["options"] = {{"bend_marks", "ticks"}};
  EXPECT_EQ(error_by(asked).where, "/options/bend_marks");
  asked["options"] = json::object();
  asked["artifacts"] = {"svg", "step"};
  EXPECT_EQ(error_by(asked).where, "/artifacts/1");
  asked["artifacts"] = {"svg"};
  asked["sheets"] = true;
  EXPECT_EQ(error_by(asked).where, "/sheets");
}

}  // namespace
}  // namespace planish::job
