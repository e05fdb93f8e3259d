#include "batch/batch_folder.hpp"

#include <gtest/gtest.h>

namespace planish::batch {
namespace {

namespace fs = std::filesystem;

using BatchState = test::BatchFolder;

TEST_F(BatchState, KeepsARecordOfTheRun) {
  EXPECT_FALSE(is_batch(folder_));
  EXPECT_EQ(read_record(folder_).error().code, code::cannot_read);
  auto state = State::open(folder_);
  ASSERT_TRUE(state);
  EXPECT_TRUE(is_batch(folder_));
  ASSERT_TRUE(state->record({{2, 5},
                             17,
                             "hash",
                             true,
                             {"a.step", "b \"c\".step"},
                             {{"a.step", 20}},
                             {3, {{"x.pdf", "no_input", "no part"}}}}));
  const auto record = read_record(folder_);
  ASSERT_TRUE(record) << record.error().message;
  EXPECT_EQ(record->shard.number, 2);
  EXPECT_EQ(record->shard.of, 5);
  EXPECT_EQ(record->inputs, 17u);
  EXPECT_EQ(record->work, "hash");
  EXPECT_TRUE(record->finished);
  EXPECT_EQ(record->names, (std::vector<std::string>{"a.step", "b \"c\".step"}));
  EXPECT_EQ(record->copies_of("a.step"), 20);
  EXPECT_EQ(record->copies_of("b \"c\".step"), 1);
  EXPECT_EQ(record->passed_over.count, 3u);
  ASSERT_EQ(record->passed_over.files.size(), 1u);
  EXPECT_EQ(record->passed_over.files[0].why, "no part");
  write(".planish-batch/run.json", "{}");
  EXPECT_EQ(read_record(folder_).error().code, code::cannot_read);
}

TEST_F(BatchState, IsOfOneRunAtATime) {
  {
    auto first = State::open(folder_);
    ASSERT_TRUE(first);
    const State moved = std::move(*first);
    const auto second = State::open(folder_);
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().code, code::cannot_write);
    EXPECT_EQ(second.error().where, folder_.string());
  }
  EXPECT_TRUE(State::open(folder_));
}

TEST_F(BatchState, PutsFilesInPlaceOfThoseBefore) {
  auto state = State::open(folder_);
  ASSERT_TRUE(state);
  const PartDone part = part_done("in/a", "{}", {}, {{"a.dxf", "1"}, {"a.svg", "2"}});
  ASSERT_TRUE(state->store({part}, {}));
  EXPECT_EQ(text_in("parts/in/a/a.dxf"), "1");
  EXPECT_EQ(state->folder_of("in/a"), folder_ / "parts/in/a");
  write("parts/in/a/mine.txt", "kept");
  write("parts/in/a/.planish-x.part", "cut off");
  const PartDone other = part_done("in/b", "{}", {}, {{"b.dxf", "3"}});
  PartRecord before;
  before.folder = "in/a";
  before.files = {"a.dxf", "a.svg"};
  const PartDone again = part_done("in/a", "{}", {}, {{"a.dxf", "4"}});
  ASSERT_TRUE(state->store({again, other}, {before}));
  EXPECT_EQ(text_in("parts/in/a/a.dxf"), "4");
  EXPECT_FALSE(fs::exists(folder_ / "parts/in/a/a.svg"));
  EXPECT_FALSE(fs::exists(folder_ / "parts/in/a/.planish-x.part"));
  EXPECT_EQ(text_in("parts/in/a/mine.txt"), "kept") << "what is of others";
  EXPECT_EQ(text_in("parts/in/b/b.dxf"), "3");
  before.folder = "in/b";
  before.files = {"b.dxf"};
  ASSERT_TRUE(state->store({}, {before}));
  EXPECT_FALSE(fs::exists(folder_ / "parts/in/b")) << "left empty";
  EXPECT_TRUE(fs::exists(folder_ / "parts/in/a"));
}

TEST(BatchHash, IsOfEveryByte) {
  EXPECT_EQ(hash_of("").size(), 32u);
  // XXH3 128 of nothing, from its reference.
  EXPECT_EQ(hash_of(""), "99aa06d3014798d86001c324468d497f");
  EXPECT_NE(hash_of("a"), hash_of("b"));
  EXPECT_NE(hash_of(std::string("a\0", 2)), hash_of("a"));
  EXPECT_EQ(hash_of("planish"), hash_of("planish"));
}

}  // namespace
}  // namespace planish::batch
