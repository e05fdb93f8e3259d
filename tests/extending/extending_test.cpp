// A maker, an artifact and a task in tables of their own: all that docs/extending.md promises
// follows from their rows.
#include "count_task.hpp"
#include "disc_maker.hpp"
#include "points_artifact.hpp"
#include "program.hpp"
#include "support/test_folder.hpp"
#include "work/workbench.hpp"

#include <planish/job/run.hpp>
#include <planish/job/schemas.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

namespace planish {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr double kRadius = 50.0, kPi = std::numbers::pi;
constexpr auto kDisc = R"({"radius": 50, "thickness": 2})";

const job::Catalogue& catalogue() {
  static const job::Catalogue all = [] {
    job::Catalogue extended = job::built_in();
    extended.makers.push_back(job::disc_maker());
    extended.artifacts.push_back(job::points_artifact());
    extended.tasks.push_back(job::count_task());
    return extended;
  }();
  return all;
}

Json request(const std::string& artifact) {
  return {{"maker", "disc"},
          {"input", {{"name", "plate.json"}, {"content", Json::parse(kDisc)}}},
          {"artifacts", {artifact}}};
}

/// Radii about the middle of the pattern, which begins at the origin, and area of points in order,
/// "x,y" a line behind a heading.
struct Ring {
  double smallest = 1e300, largest = 0.0, area = 0.0;
};
Ring ring_of(const std::string& csv) {
  std::istringstream lines(csv.substr(csv.find('\n') + 1));
  std::vector<std::pair<double, double>> points;
  for (std::string line; std::getline(lines, line);)
    points.emplace_back(std::stod(line), std::stod(line.substr(line.find(',') + 1)));
  Ring ring;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [x, y] = points[i];
    const auto [u, v] = points[(i + 1) % points.size()];
    ring.smallest = std::min(ring.smallest, std::hypot(x - kRadius, y - kRadius));
    ring.largest = std::max(ring.largest, std::hypot(x - kRadius, y - kRadius));
    ring.area += 0.5 * (x * v - u * y);
  }
  return ring;
}

void expect_circle(const std::string& csv) {
  constexpr double kChord = 0.01;  // mm, of the artifact
  const Ring ring = ring_of(csv);
  EXPECT_NEAR(ring.smallest, kRadius, 1e-9);
  EXPECT_NEAR(ring.largest, kRadius, 1e-9);
  // A chord's sagitta s takes at most two thirds of s times the arc from the disc.
  EXPECT_NEAR(ring.area, kPi * kRadius * kRadius, kChord * 2.0 * kPi * kRadius);
}

int run_program(const std::vector<std::string>& arguments) {
  std::vector<const char*> argv{"planish"};
  for (const std::string& argument : arguments)
    argv.push_back(argument.c_str());
  return cli::run_program(static_cast<int>(argv.size()), argv.data(), catalogue());
}

TEST(NewMaker, AnswersARequestWithItsReport) {
  const auto done = job::run(request("dxf").dump(), {}, catalogue());
  ASSERT_TRUE(done.has_value()) << done.error().message;
  const Json report = Json::parse(done->report);
  EXPECT_EQ(report["command"], "disc");
  EXPECT_EQ(report["status"], "ok");
  EXPECT_NEAR(report["flat"]["area"].get<double>(), kPi * kRadius * kRadius, 1e-6);
  EXPECT_NEAR(report["verification"]["volume_ratio"].get<double>(), 1.0, 1e-9);
  ASSERT_EQ(done->artifacts.size(), 1u);
  EXPECT_EQ(done->artifacts[0].name, "plate.dxf");
  EXPECT_EQ(done->artifacts[0].media_type, "image/vnd.dxf");
  EXPECT_THAT(done->artifacts[0].bytes, HasSubstr("CIRCLE"));
}

TEST(NewMaker, SaysWhatIsWrongWithItsInputByPointerAndRule) {
  Json wrong = request("dxf");
  wrong["input"]["content"]["radius"] = -1;
  const auto done = job::run(wrong.dump(), {}, catalogue());
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().where, "plate.json/radius");
  EXPECT_THAT(done.error().message, HasSubstr("/radius must be a number above 0, not -1"));
}

TEST(NewMaker, TakesTheOptionsOfItsRowAlone) {
  Json asked = request("dxf");
  asked["options"] = {{"units", "inch"}};
  const auto done = job::run(asked.dump(), {}, catalogue());
  ASSERT_TRUE(done.has_value()) << done.error().message;
  EXPECT_EQ(Json::parse(done->report)["units"], "inch");
  asked["options"] = {{"root", "largest"}};
  const auto refused = job::run(asked.dump(), {}, catalogue());
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().where, "/options/root");
}

TEST(NewMaker, HasAnOptionOfItsOwnThatOthersLack) {
  Json asked = request("dxf");
  asked["options"] = {{"least_radius", 60}};
  const auto done = job::run(asked.dump(), {}, catalogue());
  ASSERT_TRUE(done.has_value()) << done.error().message;
  EXPECT_EQ(Json::parse(done->report)["status"], "warning");
  asked["options"] = {{"least_radius", 0}};
  const auto out_of_range = job::run(asked.dump(), {}, catalogue());
  ASSERT_FALSE(out_of_range.has_value());
  EXPECT_EQ(out_of_range.error().where, "/options/least_radius");
  const Json plates = {{"maker", "connect"},
                       {"input", PLANISH_SOURCE_DIR "/examples/connect/a_folded.json"},
                       {"options", {{"least_radius", 60}}}};
  const auto others = job::run(plates.dump(), {}, catalogue());
  ASSERT_FALSE(others.has_value());
  EXPECT_EQ(others.error().where, "/options/least_radius");
  const Json schema = Json::parse(job::request_schema_text("disc", catalogue()));
  EXPECT_TRUE(schema["properties"]["options"]["properties"].contains("least_radius"));
}

TEST(NewMaker, HasAFindingWithItsPlaceNumbersAndRemedy) {
  Json asked = request("dxf");
  asked["options"] = {{"least_radius", 60}};
  const auto done = job::run(asked.dump(), {}, catalogue());
  ASSERT_TRUE(done.has_value()) << done.error().message;
  const Json report = Json::parse(done->report);
  const auto found = std::ranges::find(report["checks"], Json("small_disc"),
                                       [](const Json& check) { return check["code"]; });
  ASSERT_NE(found, report["checks"].end());
  EXPECT_EQ((*found)["message"], "the disc has a radius of 50 mm, less than 60 mm");
  EXPECT_EQ((*found)["at"], Json({{kRadius, kRadius}}));
  EXPECT_EQ((*found)["numbers"]["least"]["value"], 60.0);
  EXPECT_THAT((*found)["remedy"]["change"].dump(), HasSubstr("another shop"));
  EXPECT_EQ(Json::parse(job::run(request("dxf").dump(), {}, catalogue())->report)["checks"],
            Json::array())
      << "50 mm is not below the default";
}

TEST(NewMaker, HasASchema) {
  EXPECT_THAT(job::schema_names(catalogue()), Contains("disc"));
  const Json schema = Json::parse(job::schema_text("disc", catalogue()));
  EXPECT_EQ(schema["required"], Json({"radius", "thickness"}));
  EXPECT_EQ(schema["properties"]["radius"]["exclusiveMinimum"], 0);
  EXPECT_THAT(Json::parse(job::schema_text("request", catalogue()))["properties"]["maker"]["enum"],
              Contains("disc"));
  EXPECT_THAT(job::schema_names(), Not(Contains("disc"))) << "it is not in the program";
}

TEST(NewMaker, IsACommand) {
  const test::TestFolder folder;
  const std::string disc = folder.write("disc.json", kDisc).string();
  EXPECT_EQ(run_program({"disc", disc, "--quiet", "--least-radius", "60"}), 0);
  EXPECT_THAT(folder.read("disc.dxf"), HasSubstr("CIRCLE"));
  EXPECT_EQ(run_program({"disc", disc, "--flat", (folder / "disc.dwg").string()}), 2);
  EXPECT_EQ(run_program({"disc", disc, "--mould", (folder / "mould.stl").string()}), 2);
  EXPECT_EQ(run_program({"disc", (folder / "none.json").string()}), 3);
  EXPECT_EQ(run_program({"disc", "--help"}), 0);
}

TEST(NewMaker, IsADocumentOfTheStudio) {
  studio::Workbench bench("/nowhere", catalogue());
  const auto opened = bench.perform({"open", "plate.json", kDisc});
  ASSERT_EQ(opened.status, 200) << opened.body;
  EXPECT_EQ(Json::parse(opened.body)["kind"], "disc");
  const std::string asked = std::string("{\"spec\": ") + kDisc + "}";
  for (const char* verb : {"draft", "result"}) {
    const auto shape = bench.perform({verb, "", asked});
    EXPECT_EQ(shape.status, 200) << shape.body;
    EXPECT_EQ(shape.body.substr(0, 4), "PLN1");
  }
}

TEST(NewMaker, KeepsItsOwnOptionInTheStudio) {
  studio::Workbench bench("/nowhere", catalogue());
  ASSERT_EQ(bench.perform({"open", "plate.json", kDisc}).status, 200);
  const auto shape = bench.perform(
      {"result", "",
       std::string("{\"options\": {\"least_radius\": 60}, \"spec\": ") + kDisc + "}"});
  ASSERT_EQ(shape.status, 200) << shape.body;
  EXPECT_THAT(shape.body, HasSubstr("small_disc"));
}

TEST(NewTask, IsAskedForByItsName) {
  Json asked{{"maker", "count"}, {"input", PLANISH_SOURCE_DIR "/examples/bracket.step"}};
  auto done = job::run(asked.dump(), {}, catalogue());
  ASSERT_TRUE(done.has_value()) << done.error().message;
  EXPECT_EQ(done->report, "2\n");
  asked["input"] = {{"name", "plate.json"}, {"content", Json::parse(kDisc)}};
  asked["openings"] = true;
  done = job::run(asked.dump(), {}, catalogue());
  ASSERT_TRUE(done.has_value()) << done.error().message;
  EXPECT_EQ(done->report, "0\n") << "of whatever a maker makes";
}

TEST(NewTask, HasItsOptionsFlagsAndArtifactsAlone) {
  const Json asked{{"maker", "count"}, {"input", PLANISH_SOURCE_DIR "/examples/bracket.step"}};
  const auto where = [&](const char* key, const Json& value, const char* task = "count") {
    Json other = asked;
    other["maker"] = task;
    other[key] = value;
    const auto done = job::run(other.dump(), {}, catalogue());
    return done ? std::string() : done.error().where;
  };
  EXPECT_EQ(where("options", {{"body", 1}}), "");
  EXPECT_EQ(where("options", {{"k", 0.4}}), "/options/k");
  EXPECT_EQ(where("artifacts", {"dxf"}), "/artifacts/0");
  EXPECT_EQ(where("openings", true, "unfold"), "/openings");
  EXPECT_EQ(where("sheets", true), "/sheets");
}

TEST(NewTask, IsInTheSchemaOfRequests) {
  const Json any = Json::parse(job::schema_text("request", catalogue()))["properties"];
  EXPECT_THAT(any["maker"]["enum"], Contains("count"));
  EXPECT_TRUE(any.contains("openings"));
  const Json own = Json::parse(job::request_schema_text("count", catalogue()))["properties"];
  EXPECT_EQ(own["options"]["properties"].size(), 1u);
  EXPECT_TRUE(own.contains("openings"));
  EXPECT_FALSE(own.contains("artifacts"));
  EXPECT_FALSE(own.contains("effort"));
}

TEST(NewArtifact, IsWrittenOfEveryMaker) {
  for (const job::Maker& maker : catalogue().makers)
    EXPECT_TRUE(catalogue().artifact(maker, "points")) << maker.name;
  const auto done = job::run(request("points").dump(), {}, catalogue());
  ASSERT_TRUE(done.has_value()) << done.error().message;
  ASSERT_EQ(done->artifacts.size(), 1u);
  EXPECT_EQ(done->artifacts[0].name, "plate.csv");
  EXPECT_EQ(done->artifacts[0].media_type, "text/csv");
  expect_circle(done->artifacts[0].bytes);
}

TEST(NewArtifact, IsASuffixOfTheCommandLine) {
  const test::TestFolder folder;
  const std::string disc = folder.write("disc.json", kDisc).string();
  EXPECT_EQ(run_program({"disc", disc, "--flat", (folder / "ring.csv").string(), "--quiet"}), 0);
  expect_circle(folder.read("ring.csv"));
  const std::string plates = PLANISH_SOURCE_DIR "/examples/connect/a_folded.json";
  EXPECT_EQ(run_program({"connect", plates, "--flat", (folder / "plates.csv").string(), "--quiet"}),
            0);
  EXPECT_THAT(folder.read("plates.csv"), HasSubstr("x,y\n"));
}

TEST(NewArtifact, IsADownloadOfTheStudio) {
  studio::Workbench bench("/nowhere", catalogue());
  ASSERT_EQ(bench.perform({"open", "plate.json", kDisc}).status, 200);
  const auto file = bench.perform({"files", "points", std::string("{\"spec\": ") + kDisc + "}"});
  ASSERT_EQ(file.status, 200) << file.body;
  EXPECT_EQ(file.type, "text/csv");
  expect_circle(file.body);
}

}  // namespace
}  // namespace planish
