// What a batch and its workers tell each other arrives as it was sent, or not at all.

#include "worker_talk.hpp"

#include <planish/batch/codes.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

namespace planish::batch {
namespace {

TEST(WorkerTalk, ATaskArrives) {
  const FileTask task{
      .file = "/a/\xff.step",
      .name = "b\n.step",
      .options = R"({"k":0.4})",
      .formats = {"dxf", "json"},
      .given_up = {{3, {code::time_limit, "too long", "b"}}, {7, {code::worker_died, "", ""}}},
      .share = {2, 3}};
  const auto read = task_in(texts_of(task));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->file, task.file);
  EXPECT_EQ(read->name, task.name);
  EXPECT_EQ(read->options, task.options);
  EXPECT_EQ(read->formats, task.formats);
  EXPECT_EQ(read->share.number, 2);
  EXPECT_EQ(read->share.of, 3);
  ASSERT_EQ(read->given_up.size(), 2U);
  EXPECT_EQ(read->given_up.at(3).code, code::time_limit);
  EXPECT_EQ(read->given_up.at(3).message, "too long");
  EXPECT_EQ(read->given_up.at(7).code, code::worker_died);
}

TEST(WorkerTalk, APartArrives) {
  const PartDone part = part_done("f", R"({"reason":{"code":"overlap"}})", {"s", "t"},
                                  {{"a.dxf", std::string("\0\n", 2)}, {"b", ""}}, 4);
  const auto read = part_in(texts_of(part));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->record.folder, "f");
  EXPECT_EQ(read->record.report, part.record.report);
  EXPECT_EQ(read->record.reason, "overlap");
  EXPECT_EQ(read->body, 4);
  EXPECT_EQ(read->record.shapes, (std::vector<std::string>{"s", "t"}));
  EXPECT_EQ(read->record.files, (std::vector<std::string>{"a.dxf", "b"}));
  ASSERT_EQ(read->files.size(), 2U);
  EXPECT_EQ(read->files[0].bytes, part.files[0].bytes);
  EXPECT_EQ(read->files[1].name, "b");
}

TEST(WorkerTalk, ABodyIsNoPart) {
  EXPECT_EQ(body_in(beginning(12)), 12);
  EXPECT_FALSE(part_in(beginning(12)));
  EXPECT_FALSE(body_in(texts_of(part_done("f", "{}", {}, {}))));
}

// Cut off anywhere, it is either nothing or a shorter list, and is never read past its end.
TEST(WorkerTalk, WhatIsCutOffIsNotRead) {
  const process::Texts task = texts_of(FileTask{.file = "a",
                                                .name = "b",
                                                .options = "{}",
                                                .formats = {"dxf"},
                                                .given_up = {{3, {code::overlap, "m", "w"}}}});
  for (std::size_t length = 0; length < task.size(); ++length) {
    const auto read = task_in({task.begin(), task.begin() + static_cast<std::ptrdiff_t>(length)});
    EXPECT_EQ(read.has_value(), length == 6) << length;
  }
  const process::Texts part = texts_of(part_done("f", "{}", {"s", "t"}, {{"a", "b"}, {"c", "d"}}));
  for (std::size_t length = 0; length < part.size(); ++length) {
    const auto read = part_in({part.begin(), part.begin() + static_cast<std::ptrdiff_t>(length)});
    EXPECT_EQ(read.has_value(), length == 7 || length == 9) << length;
  }
  EXPECT_FALSE(part_in({"part", "f", "{}", "0", "-1"}));
  EXPECT_FALSE(part_in({"part", "f", "{}", "0", "999999999999"}));
  EXPECT_FALSE(part_in({"part", "f", "no json", "0", "0"}));
  EXPECT_FALSE(task_in({"a", "b", "{}", "{", "1", "1"}));
  EXPECT_FALSE(task_in({"a", "b", "{}", "[]", "1", "0"}));
}

}  // namespace
}  // namespace planish::batch
