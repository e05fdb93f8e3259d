#include "served_work.hpp"

#include "rpc.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace planish::serve {
namespace {

namespace fs = std::filesystem;

const std::string kServedPlates = PLANISH_SOURCE_DIR "/examples/connect/a_folded.json";

process::Parent nobody() {
  return {.progress = {}, .note = [](const process::Texts&) {}};
}

Json drafted(const std::string& input) {
  return {{"maker", "connect"}, {"input", input}, {"effort", "draft"}};
}

WorkDone worked(const WorkTask& task) {
  auto done = work_on(task, job::built_in(), nobody());
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  return done ? std::move(*done) : WorkDone{};
}

std::string refused_at(const WorkTask& task) {
  const auto done = work_on(task, job::built_in(), nobody());
  if (done) return "done";
  return done.error().where;
}

TEST(ServedWork, AnswersWithReportAndArtifacts) {
  Json request = drafted(kServedPlates);
  request["artifacts"] = {"svg", "stl"};
  std::vector<process::Texts> notes;
  const auto done = work_on({text_of(request), {}}, job::built_in(),
                            {{}, [&](const process::Texts& note) { notes.push_back(note); }});
  ASSERT_TRUE(done) << done.error().message;
  EXPECT_EQ(notes, (std::vector<process::Texts>{{kServedPlates}})) << "what is worked on";
  const Json result = Json::parse(done->result);
  EXPECT_EQ(result["status"], "ok");
  EXPECT_EQ(result["report"]["command"], "connect");
  ASSERT_EQ(result["artifacts"].size(), 2u);
  EXPECT_EQ(result["artifacts"][0]["text"].get<std::string>().rfind("<", 0), 0u);
  EXPECT_TRUE(result["artifacts"][1].contains("base64")) << "bytes that are no text";
  EXPECT_FALSE(result["artifacts"][1].contains("text"));
  EXPECT_TRUE(done->files.empty());
  EXPECT_FALSE(done->refused);
  EXPECT_FALSE(done->summary.empty());
}

TEST(ServedWork, WritesWhereItIsTold) {
  const fs::path folder = fs::path(::testing::TempDir());
  Json request = drafted(kServedPlates);
  request["artifacts"] = {"json"};
  const WorkDone done = worked({text_of(request), {{"dxf", (folder / "a.dxf").string()}}});
  ASSERT_EQ(done.files.size(), 1u);
  EXPECT_EQ(done.files[0].path, folder / "a.dxf");
  const Json artifacts = Json::parse(done.result)["artifacts"];
  ASSERT_EQ(artifacts.size(), 2u) << "and what was asked for besides";
  EXPECT_EQ(artifacts[1]["path"], (folder / "a.dxf").string());
  EXPECT_EQ(artifacts[1]["size"], done.files[0].content.size());
  EXPECT_FALSE(artifacts[1].contains("text"));
  EXPECT_NE(done.summary.find((folder / "a.dxf").string()), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "a.dxf")) << "by who asked";
}

TEST(ServedWork, RefusesPlacesWhereNothingCanBeWritten) {
  const std::string folder = ::testing::TempDir();
  const Json request = drafted(kServedPlates);
  EXPECT_EQ(refused_at({text_of(request), {{"dxf", "/no/such/a.dxf"}}}), "/write/dxf");
  EXPECT_EQ(refused_at({text_of(request), {{"json", kServedPlates}}}), "/write/json")
      << "the input would be lost";
  EXPECT_EQ(refused_at({text_of(request), {{"dxf", folder + "/x"}, {"svg", folder + "/x"}}}),
            "/write/svg");
  EXPECT_EQ(refused_at({text_of(request), {{"mould.stl", folder + "/m.stl"}}}), "/write/mould.stl")
      << "connect makes none";
  Json listed = request;
  listed["artifacts"] = {"mould.stl"};
  EXPECT_EQ(refused_at({text_of(listed), {{"dxf", folder + "/a.dxf"}}}), "/artifacts/0");
}

TEST(ServedWork, ReadsNoStandardInput) {
  EXPECT_EQ(refused_at({text_of(drafted("-")), {}}), "/input");
  Json request = drafted(kServedPlates);
  request["options"] = {{"rules", "-"}};
  EXPECT_EQ(refused_at({text_of(request), {}}), "/options/rules");
}

TEST(ServedWork, GoesOverASocketAndBack) {
  const WorkTask task{R"({"a":1})", {{"dxf", "x.dxf"}, {"svg", ""}}};
  const auto again = task_in(texts_of(task));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->request, task.request);
  EXPECT_EQ(again->writes, task.writes);
  EXPECT_FALSE(task_in({"a", "b"}));
  EXPECT_FALSE(task_in({}));
  for (const bool refused : {false, true}) {
    WorkDone done;
    done.result = "{}";
    done.summary = "s";
    done.refused = refused;
    done.files = {{"a.dxf", std::string("\0x", 2)}, {"b", ""}};
    const auto answer = done_in(texts_of(Result<WorkDone>(done)));
    ASSERT_TRUE(answer && *answer);
    const WorkDone* const heard = &**answer;
    EXPECT_EQ(heard->result, "{}");
    EXPECT_EQ(heard->summary, "s");
    EXPECT_EQ(heard->refused, refused);
    ASSERT_EQ(heard->files.size(), 2u);
    EXPECT_EQ(heard->files[0].content, std::string("\0x", 2));
    EXPECT_EQ(heard->files[1].path, "b");
    auto texts = texts_of(Result<WorkDone>(done));
    texts.pop_back();
    EXPECT_FALSE(done_in(texts));
    texts = texts_of(Result<WorkDone>(done));
    texts[0] = "nothing";
    EXPECT_FALSE(done_in(texts));
  }
  const auto failed = done_in(texts_of(Result<WorkDone>(fail(code::bad_option, "m", "/k"))));
  ASSERT_TRUE(failed);
  ASSERT_FALSE(*failed);
  EXPECT_EQ(failed->error().where, "/k");
  EXPECT_FALSE(done_in({"done", "", ""}));
}

}  // namespace
}  // namespace planish::serve
