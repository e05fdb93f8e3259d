#include <planish/job/connect.hpp>
#include <planish/job/run.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>

namespace planish::job {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using json = nlohmann::json;

const std::string kExamples = PLANISH_SOURCE_DIR "/examples/";
const std::string kPlates = kExamples + "connect/a_folded.json";

std::string text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

json request(const std::string& maker, const std::string& path) {
  return {{"maker", maker}, {"input", path}};
}

RunResult done(const json& asked) {
  const auto result = run(asked.dump());
  EXPECT_TRUE(result.has_value()) << result.error().message;
  return result ? *result : RunResult{};
}

Error refused(const json& asked) {
  const auto result = run(asked.dump());
  EXPECT_FALSE(result.has_value()) << asked;
  return result ? Error{} : Error{result.error()};
}

TEST(Run, GivesTheReportOfTheMaker) {
  Request typed;
  typed.input = kPlates;
  const auto report = connect(typed);
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(done(request("connect", kPlates)).report, report_json(*report));
}

TEST(Run, TakesTheInputsContentAsWellAsItsPath) {
  json inline_request = request("connect", kPlates);
  inline_request["input"] = {{"name", kPlates}, {"content", json::parse(text_of_file(kPlates))}};
  EXPECT_EQ(done(inline_request).report, done(request("connect", kPlates)).report);
  inline_request["input"]["content"] = text_of_file(kPlates);
  EXPECT_EQ(done(inline_request).report, done(request("connect", kPlates)).report);
  json part = request("unfold", "");
  part["input"] = {{"name", "b.step"}, {"content", text_of_file(kExamples + "bracket.step")}};
  EXPECT_EQ(json::parse(done(part).report)["status"], "ok");
}

TEST(Run, GivesTheArtifactsThatAreAskedForInTheirOrder) {
  json asked = request("connect", kPlates);
  asked["artifacts"] = {"step", "dxf", "flat.step", "json"};
  const RunResult result = done(asked);
  std::vector<std::string> names;
  for (const ArtifactFile& file : result.artifacts)
    names.push_back(file.name);
  EXPECT_THAT(names, ElementsAre("a_folded.step", "a_folded.dxf", "a_folded_flat.step",
                                 "a_folded_report.json"));
  EXPECT_EQ(result.artifacts[0].media_type, "model/step");
  EXPECT_THAT(result.artifacts[0].bytes, StartsWith("ISO-10303-21;"));
  EXPECT_EQ(result.artifacts[3].bytes, result.report);
}

TEST(Run, GivesEachPieceAFileOfItsOwn) {
  json asked = request("transition", "");
  json spec = json::parse(text_of_file(kExamples + "transition/a_square_to_round.json"));
  spec["pieces"] = 2;
  asked["input"] = {{"name", "net.json"}, {"content", spec}};
  asked["artifacts"] = {"dxf", "stl"};
  asked["effort"] = "draft";
  const RunResult result = done(asked);
  ASSERT_EQ(result.artifacts.size(), 3u);
  EXPECT_EQ(result.artifacts[0].name, "net-1.dxf");
  EXPECT_EQ(result.artifacts[1].name, "net-2.dxf");
  EXPECT_EQ(result.artifacts[2].name, "net.stl") << "of both pieces together";
}

TEST(Run, HasNoArtifactsOfWhatIsRefused) {
  json asked = request("transition", "");
  json spec = json::parse(text_of_file(kExamples + "transition/a_square_to_round.json"));
  spec["to"] = spec["from"];
  asked["input"] = {{"content", spec}};
  asked["artifacts"] = {"dxf", "json"};
  const auto ran = run(asked.dump());
  ASSERT_FALSE(ran.has_value()) << "a refusal is an error";
  EXPECT_EQ(exit_status(ran.error().code), 4);
  ASSERT_TRUE(ran.error().shown);
  const RunResult& result = *ran.error().shown;
  EXPECT_EQ(result.status, Status::refused);
  ASSERT_EQ(result.artifacts.size(), 1u);
  EXPECT_EQ(result.artifacts[0].artifact, "json");
}

TEST(Run, EntersOptionsUnderTheirNames) {
  json asked = request("connect", kPlates);
  asked["options"] = {{"k", 0.25}, {"units", "inch"}, {"r12", true}, {"density", nullptr}};
  asked["artifacts"] = {"dxf"};
  const RunResult result = done(asked);
  const json report = json::parse(result.report);
  EXPECT_EQ(report["sheet"]["k_factor"], 0.25);
  EXPECT_EQ(report["units"], "inch");
  EXPECT_TRUE(report["sheet"]["mass"].is_null());
  EXPECT_THAT(result.artifacts[0].bytes, HasSubstr("AC1009"));
  asked["options"] = {
      {"k_table", {{"name", "steel.csv"}, {"content", "r/t, k\n0.1, 0.3\n9, 0.3\n"}}}};
  for (const json& bend : json::parse(done(asked).report)["flat"]["bends"]) {
    EXPECT_EQ(bend["k_factor"], 0.3);
    EXPECT_THAT(bend["k_source"].get<std::string>(), HasSubstr("steel.csv"));
  }
  asked["options"] = {{"rules", {{"content", {{"enabled", false}}}}}};
  EXPECT_EQ(json::parse(done(asked).report)["checks"], json::array());
}

TEST(Run, AnswersAWrongRequestWithThePointerAndTheRule) {
  json asked = request("fold", kPlates);
  EXPECT_EQ(refused(asked).where, "/maker");
  EXPECT_THAT(refused(asked).message,
              HasSubstr("/maker must be one of unfold, connect, transition, slit, bend, info, not "
                        "\"fold\""));
  asked = request("connect", kPlates);
  asked["options"] = {{"k", 2}};
  EXPECT_EQ(refused(asked).where, "/options/k");
  EXPECT_THAT(refused(asked).message, HasSubstr("must be a number from 0 to 1"));
  asked["options"] = {{"root", "largest"}};
  EXPECT_EQ(refused(asked).code, code::bad_option);
  EXPECT_EQ(refused(asked).where, "/options/root");
  asked["options"] = {{"k", 0.4}, {"din6935", true}};
  EXPECT_THAT(refused(asked).message, HasSubstr("`k` and `din6935` each say where K comes from"));
  asked["options"] = json::object();
  asked["artifacts"] = {"mould.stl"};
  EXPECT_THAT(refused(asked).message, HasSubstr("it writes dxf, svg, flat.step, pdf, step, stl"));
  EXPECT_EQ(run("[]").error().code, code::invalid_input);
}

// {"a": {"a": ... 1}}
std::string nested(int depth) {
  std::string text;
  for (int i = 0; i < depth; ++i)
    text += R"({"a":)";
  return text + "1" + std::string(depth, '}');
}

TEST(Run, RefusesWhatIsNestedDeeperThanAHundred) {
  const auto asked = [](const std::string& before, const std::string& inside, const char* after) {
    return run(R"({"maker": "connect", "input": )" + before + inside + after);
  };
  for (const int depth : {101, 80000}) {
    for (const auto& result :
         {asked(R"({"content": )", nested(depth), "}}"),
          asked(R"("x", "options": {"rules": {"content": )", nested(depth), "}}}"),
          asked(R"({"name": "p.json", "content": )", json(nested(depth)).dump(), "}}")}) {
      ASSERT_FALSE(result.has_value());
      EXPECT_EQ(result.error().code, code::invalid_input);
      EXPECT_THAT(result.error().message,
                  HasSubstr("nested more than 100 deep in line 1, column "));
    }
  }
  EXPECT_THAT(asked(R"({"content": )", nested(90), "}}").error().message,
              HasSubstr("/a is not a known key"));
  const auto options = read_options(nested(80000), *built_in().maker("connect"),
                                    OptionFiles::content, "/options");
  EXPECT_EQ(options.error().where, "/options");
  EXPECT_THAT(built_in().maker_for("a.json", nested(80000)).error().message,
              HasSubstr("a.json is nested more than 100 deep"));
}

TEST(Run, ReadsFilesThatAnInputNamesFromItsFolderAlone) {
  const std::string folder = kExamples + "slit";
  json asked = request("slit", "");
  asked["effort"] = "draft";
  asked["input"] = {{"name", "s.json"},
                    {"content", json::parse(text_of_file(folder + "/scanned_chair.json"))}};
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder);  // where they would be found by chance
  const Error error = refused(asked);
  std::filesystem::current_path(before);
  EXPECT_EQ(error.where, "/input/folder");
  EXPECT_THAT(error.message, HasSubstr("/input/folder is missing, but the slit file names"));
  asked["input"]["folder"] = folder;
  asked["effort"] = "full";  // a draft has little time: a busy machine may leave it unsolved
  EXPECT_NE(done(asked).status, Status::refused);
}

TEST(Run, ShowsNoPieceThatThereIsNot) {
  json spec = json::parse(text_of_file(kExamples + "transition/a_square_to_round.json"));
  spec["pieces"] = 2;
  json asked = request("transition", "");
  asked["effort"] = "draft";
  asked["input"] = {{"content", spec}};
  asked["options"] = {{"piece", 1}};
  EXPECT_EQ(done(asked).status, Status::ok);
  asked["options"] = {{"piece", 99}};
  EXPECT_EQ(refused(asked).code, code::bad_option);
  EXPECT_EQ(refused(asked).where, "/options/piece");
  EXPECT_EQ(refused(asked).message, "`piece` is 99; the last piece is 1.");
}

TEST(Run, NamesThePlaceOfEveryWrongOption) {
  const json rules{{"content", {{"k_low", 0.9}}}};
  const json table{{"name", "steel.csv"}, {"content", "r/t, k\n1, 5\n"}};
  struct Wrong {
    const char* maker;
    json options;
    const char* where;
  };
  for (const Wrong& wrong : std::initializer_list<Wrong>{
           {"connect", {{"k", 0.4}, {"din6935", true}}, "/options/din6935"},
           {"connect", {{"k", 0.4}, {"k_table", table}}, "/options/k_table"},
           {"connect",
            {{"rules", {{"content", json::object()}}}, {"no_rules", true}},
            "/options/no_rules"},
           {"connect", {{"splines", "keep"}, {"r12", true}}, "/options/splines"},
           {"connect", {{"tick_length", 3}}, "/options/tick_length"},
           {"connect", {{"rules", rules}}, "/options/rules/content/k_low"},
           {"connect", {{"k_table", table}}, "/options/k_table/content"},
           {"unfold", {{"bend_k", {{"B99", 0.4}}}}, "/options/bend_k/B99"},
           {"unfold", {{"bend_k", {{"a/b", 0.4}}}}, "/options/bend_k/a~1b"},
           {"unfold", {{"bend_k", {{"", 0.4}}}}, "/options/bend_k/"},
           {"unfold", {{"root", 99}}, "/options/root"},
           {"unfold", {{"up", 99}}, "/options/up"},
           {"unfold", {{"body", "x"}}, "/options/body"},
           {"unfold", {{"body", 99}}, "/options/body"},
       }) {
    const bool part = wrong.maker == std::string("unfold");
    json asked = request(wrong.maker, part ? kExamples + "bracket.step" : kPlates);
    asked["options"] = wrong.options;
    asked["effort"] = "draft";
    EXPECT_EQ(refused(asked).where, wrong.where) << wrong.options;
  }
}

TEST(Run, NamesThePlaceOfAnArtifactThatCannotBeWritten) {
  json asked = request("connect", kPlates);
  asked["artifacts"] = {"dxf", "mould.stl"};
  EXPECT_EQ(refused(asked).where, "/artifacts/1");
}

TEST(Run, NamesTheInputOfAWrongSlitFile) {
  json slit = json::parse(text_of_file(kExamples + "slit/chair.json"));
  slit["sheet"]["strips"] = 1;
  slit["sheet"]["strip_width"] = 1e6;
  json asked = request("slit", "");
  asked["input"] = {{"name", "i.json"}, {"content", slit}};
  std::vector<std::string> places;
  for (const char* effort : {"draft", "full"}) {
    asked["effort"] = effort;
    const auto result = run(asked.dump());
    places.push_back(result ? json::parse(result->report)["reason"].value("where", "")
                            : result.error().where);
  }
  EXPECT_THAT(places, ElementsAre("i.json/leg_curve", "i.json/leg_curve"));
}

}  // namespace
}  // namespace planish::job
