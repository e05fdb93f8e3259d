#include "batch/batch_folder.hpp"

#include <planish/batch/parts.hpp>

#include <gtest/gtest.h>

namespace planish::batch {
namespace {

using Parts = test::RunFolder;

TEST_F(Parts, AreThoseOfAFinishedBatchInTheirOrder) {
  run("one", {1, 1}, {"a", "r"});
  std::vector<BatchPart> parts;
  const auto keep = [&](BatchPart part) -> Result<void> {
    parts.push_back(std::move(part));
    return {};
  };
  ASSERT_TRUE(for_each_part(folder_ / "one", keep));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].record.folder, "a");
  EXPECT_EQ(parts[0].files, folder_ / "one/parts/a");
  EXPECT_EQ(parts[0].copies, 1);
  EXPECT_EQ(parts[0].record.shapes.size(), 1u);
  EXPECT_TRUE(parts[1].record.shapes.empty());
  EXPECT_EQ(nlohmann::json::parse(parts[1].record.report)["reason"]["code"], "overlap");
  const auto stop = [](BatchPart) -> Result<void> { return fail(code::cancelled, "enough"); };
  EXPECT_EQ(for_each_part(folder_ / "one", stop).error().code, code::cancelled);
  run("cut", {1, 1}, {"a"}, false);
  EXPECT_EQ(for_each_part(folder_ / "cut", keep).error().code, code::cannot_read);
}

}  // namespace
}  // namespace planish::batch
