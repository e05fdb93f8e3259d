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

TEST_F(Parts, AreMeantByRowsOfAList) {
  run("one", {1, 1}, {"a", "r"});
  const auto list = shop::PartMaterials::parse(
      "part,material,quantity\nz,Steel,3\na,Steel,2\n*,oak,\na,brass,\n", "list.csv");
  ASSERT_TRUE(list);
  const auto unused = unused_rows(folder_ / "one", *list);
  ASSERT_TRUE(unused) << unused.error().message;
  EXPECT_EQ(*unused, (std::vector<int>{2, 5})) << "no part is called z, and a row before fits a";
  EXPECT_NE(shop::unused_row_text(*list, 2).find("list.csv, line 2: no part takes its material and "
                                                 "quantity"),
            std::string::npos);
  EXPECT_EQ(shop::unused_row_text(*list, 5).find("quantity"), std::string::npos);
}

}  // namespace
}  // namespace planish::batch
