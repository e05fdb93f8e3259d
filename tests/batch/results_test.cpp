#include "results.hpp"

#include "batch/batch_folder.hpp"

#include <planish/sheet/csv.hpp>

#include <gtest/gtest.h>

namespace planish::batch {
namespace {

using Results = test::BatchFolder;

TEST_F(Results, AreWrittenFromTheJournalInTheOrderAsked) {
  auto state = State::open(folder_);
  ASSERT_TRUE(state);
  const auto enter = [&](const std::string& name, const PartDone& part) {
    ASSERT_TRUE(state->journal().add(name, "k", {part}));
  };
  enter("c", test::made_part("c", test::flat_plate(100, 60)));
  enter("a", test::made_part("a", test::flat_plate(100, 60)));
  enter("b", test::refused_part("b", "overlap"));
  enter("d", test::made_part("d", test::flat_plate(70, 60)));
  enter("old", test::made_part("old", test::flat_plate(1, 1)));
  const auto result = write_results({.names = {"a", "b", "c", "d"},
                                     .copies = {{"c", 20}},
                                     .passed_over = {2, {{"x.pdf", "no_input", "no part"}}}},
                                    *state);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->inputs, 4u);
  EXPECT_EQ(result->parts, 4u);
  EXPECT_EQ(result->ok, 3u);
  EXPECT_EQ(result->warnings, 0u);
  EXPECT_EQ(result->refused, 1u);
  EXPECT_EQ(result->distinct, 2u);
  EXPECT_EQ(result->out, folder_);
  ASSERT_EQ(result->refused_for.size(), 1u);
  EXPECT_EQ(result->refused_for[0].first, "b");
  EXPECT_EQ(result->passed_over.count, 2u);
  // The table, as a reader of CSV has it.
  const auto table = split_csv(text_in("summary.csv"), "summary.csv");
  ASSERT_TRUE(table);
  ASSERT_EQ(table->size(), 5u);
  const auto& titles = (*table)[0].fields;
  const auto column = [&](const char* title) {
    return static_cast<std::size_t>(std::ranges::find(titles, title) - titles.begin());
  };
  EXPECT_EQ((*table)[1].fields[column("input")], "a");
  EXPECT_EQ((*table)[1].fields[column("same_as")], "") << "the first of its kind";
  EXPECT_EQ((*table)[2].fields[column("reason")], "overlap");
  EXPECT_EQ((*table)[3].fields[column("same_as")], "a");
  EXPECT_EQ((*table)[4].fields[column("same_as")], "");
  EXPECT_EQ((*table)[3].fields[column("quantity")], "20") << "as often as it is wanted";
  EXPECT_EQ((*table)[4].fields[column("quantity")], "1");
  // A report a line.
  std::istringstream lines(text_in("parts.jsonl"));
  std::string inputs;
  for (std::string line; std::getline(lines, line);)
    inputs += nlohmann::json::parse(line)["input"].get<std::string>();
  EXPECT_EQ(inputs, "abcd");
  const auto summary = nlohmann::json::parse(text_in("summary.json"));
  EXPECT_EQ(summary["format"], "planish/batch");
  EXPECT_EQ(summary["parts"], 4);
  EXPECT_EQ(summary["distinct"], 2);
  EXPECT_EQ(summary["reasons"], nlohmann::json({{"overlap", 1}}));
  EXPECT_EQ(summary["passed_over"]["count"], 2);
  EXPECT_EQ(summary["passed_over"]["files"][0]["file"], "x.pdf");
  EXPECT_NE(text_in("index.html").find("\"name\":\"d\""), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "summary.csv.part"));
}

TEST(RefusedFor, AreCountedByTheirSentence) {
  std::vector<RefusedFor> all;
  count_refused(all, {"overlap", "m", "a"});
  count_refused(all, {"overlap", "n", "b"});
  count_refused(all, {"overlap", "m", "c"});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].count, 2u);
  EXPECT_EQ(all[0].first, "a");
  EXPECT_EQ(all[1].count, 1u);
}

TEST_F(Results, LeaveTheOldOnesWhereTheyFail) {
  auto state = State::open(folder_);
  ASSERT_TRUE(state);
  write("summary.csv", "old");
  PartDone damaged = test::made_part("a", test::flat_plate(100, 60));
  damaged.record.shapes = {"{}"};
  ASSERT_TRUE(state->journal().add("a", "k", {damaged}));
  EXPECT_EQ(write_results({.names = {"a"}}, *state).error().code, code::cannot_read);
  EXPECT_EQ(text_in("summary.csv"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "summary.csv.part"));
}

}  // namespace
}  // namespace planish::batch
