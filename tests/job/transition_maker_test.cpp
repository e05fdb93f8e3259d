#include "job/job_requests.hpp"
#include "support/closed_mesh.hpp"

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using nlohmann::json;

json square_to_square() {
  return json::parse(R"({"thickness": 1, "pieces": 2,
      "from": {"profile": {"polygon": [[0, 0], [100, 0], [100, 100], [0, 100]]}},
      "to": {"profile": {"circle": {"radius": 30}}, "frame": {"origin": [50, 50, 80]}}})");
}

std::unique_ptr<Made> draft_of(const json& document) {
  Request request;
  request.effort = Effort::draft;
  return test::made_from("net.json", document.dump(), request);
}

TEST(TransitionMaker, MakesEachPieceAndOneMeshOfAll) {
  const auto made = draft_of(square_to_square());
  ASSERT_TRUE(made);
  EXPECT_EQ(made->pieces(), 2);
  EXPECT_EQ(made->piece(1).body, "net-2");
  const auto mesh = made->folded_mesh();
  ASSERT_TRUE(mesh);
  EXPECT_GT(mesh->triangles.size(), 8u);
  EXPECT_FALSE(made->folded_solid(0)) << "a draft has none";
}

TEST(TransitionMaker, GivesThePageBothProfilesToDrag) {
  const json handles = json::parse(draft_of(square_to_square())->handles());
  ASSERT_EQ(handles["profiles"].size(), 2u);
  EXPECT_EQ(
      handles["profiles"][0]["points"],
      json::parse("[[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [100.0, 100.0, 0.0], [0.0, 100.0, 0.0]]"));
  EXPECT_EQ(handles["profiles"][1]["points"].size(), 96u);
  for (const json& p : handles["profiles"][1]["points"])
    EXPECT_EQ(p[2], 80.0);
}

TEST(TransitionMaker, LeavesOutTrueLengthsOfADraft) {
  const json draft = json::parse(draft_of(square_to_square())->json());
  EXPECT_TRUE(draft["transition"]["true_lengths"].empty());
  EXPECT_FALSE(draft["transition"]["press_lines"].is_null());
}

TEST(TransitionMaker, TakesAnEditedFileAndKeepsTheLastThatWasRight) {
  const Maker& maker = *built_in().maker("transition");
  const auto work = maker.open({"net.json", square_to_square().dump(), {}}, {});
  ASSERT_TRUE(work);
  Request request;
  request.input = "net.json";
  request.effort = Effort::draft;
  json one = square_to_square();
  one["pieces"] = 1;
  EXPECT_TRUE((*work)->edit({"net.json", one.dump(), {}}));
  EXPECT_EQ((*(*work)->make(request, {}))->pieces(), 1);
  EXPECT_FALSE((*work)->edit({"net.json", "{", {}}));
  EXPECT_EQ((*(*work)->make(request, {}))->pieces(), 1);
  EXPECT_FALSE(maker.open({"net.json", "{", {}}, {}));
}

}  // namespace
}  // namespace planish::job
