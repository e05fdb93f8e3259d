#include "batch/batch_folder.hpp"

#include <planish/batch/batch.hpp>

#include <gtest/gtest.h>

namespace planish::batch {
namespace {

namespace fs = std::filesystem;

class Merge : public test::RunFolder {
 protected:
  Result<BatchResult> merged(const std::vector<fs::path>& folders, const std::string& out = "all") {
    std::vector<fs::path> whole;
    for (const fs::path& folder : folders)
      whole.push_back(folder_ / folder);
    return merge_batches(whole, folder_ / out, {}, [] { return false; });
  }
};

TEST_F(Merge, GivesWhatOneRunWouldHaveGivenToTheByte) {
  run("one", {1, 1}, {"a", "b", "c", "r"});
  run("dealt/shard-1-of-2", {1, 2}, {"b", "r"});
  run("dealt/shard-2-of-2", {2, 2}, {"a", "c"});
  const auto result = merged({"dealt"});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->parts, 4u);
  EXPECT_EQ(result->refused, 1u);
  EXPECT_EQ(result->left, 0u);
  for (const char* file : {"summary.csv", "summary.json", "parts.jsonl", "index.html"}) {
    EXPECT_EQ(text_in(std::string("all/") + file), text_in(std::string("one/") + file)) << file;
    EXPECT_FALSE(text_in(std::string("one/") + file).empty()) << file;
  }
  for (const char* part : {"a", "b", "c"})
    EXPECT_EQ(text_in(std::string("all/parts/") + part + "/a.dxf"), std::string("dxf of ") + part);
  const auto record = read_record(folder_ / "all");
  EXPECT_TRUE(record->finished);
  EXPECT_EQ(record->names, (std::vector<std::string>{"a", "b", "c", "r"}));
}

TEST_F(Merge, TakesTheFoldersOfShardsThemselves) {
  run("x", {1, 2}, {"b"});
  run("y", {2, 2}, {"a"});
  EXPECT_EQ(merged({"y", "x", "y"})->parts, 2u) << "each once";
}

TEST_F(Merge, RefusesWhatIsNoWholeBatch) {
  const auto code_of = [&](const std::vector<fs::path>& folders) {
    const auto result = merged(folders);
    return result ? "merged" : std::string(code_name(result.error().code));
  };
  run("x", {1, 2}, {"b"});
  EXPECT_EQ(code_of({"x"}), "cannot_read") << "one is missing";
  run("again", {1, 2}, {"b"});
  EXPECT_EQ(code_of({"x", "again"}), "cannot_read") << "one is there twice";
  run("other", {2, 2}, {"a"}, true, "other work");
  EXPECT_EQ(code_of({"x", "other"}), "cannot_read");
  run("three", {2, 3}, {"a"});
  EXPECT_EQ(code_of({"x", "three"}), "cannot_read");
  run("cut", {2, 2}, {"a"}, false);
  EXPECT_EQ(code_of({"x", "cut"}), "cannot_read") << "unfinished";
  EXPECT_EQ(code_of({"absent"}), "cannot_read");
  fs::create_directories(folder_ / "empty");
  EXPECT_EQ(code_of({"empty"}), "cannot_read");
  run("y", {2, 2}, {"a"});
  EXPECT_EQ(code_of({"x", "y"}), "merged");
  EXPECT_EQ(merged({"x", "y"}, "x").error().where, "output");
}

TEST_F(Merge, TellsHowFarItIsAndStopsWhenAsked) {
  run("x", {1, 1}, {"a", "b"});
  std::vector<std::size_t> done;
  ASSERT_TRUE(merge_batches(
      {folder_ / "x"}, folder_ / "all",
      [&](const BatchProgress& progress) {
        done.push_back(progress.done);
        EXPECT_EQ(progress.all, 2u);
      },
      [] { return false; }));
  EXPECT_EQ(done, (std::vector<std::size_t>{1, 2}));
  const auto stopped = merge_batches({folder_ / "x"}, folder_ / "none", {}, [] { return true; });
  EXPECT_EQ(stopped.error().code, code::cancelled);
  EXPECT_EQ(read_record(folder_ / "none")->finished, false);
}

}  // namespace
}  // namespace planish::batch
