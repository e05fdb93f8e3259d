#include <planish/base/id_vector.hpp>

#include <gtest/gtest.h>

#include <string>

namespace planish {
namespace {

enum class RowId : int {};
enum class OtherId : int {};
using Rows = IdVector<RowId, std::string>;

template <typename Id>
concept SubscriptOfRows = requires(Rows rows, Id id) {
  rows[id];
};

static_assert(SubscriptOfRows<RowId>);
static_assert(!SubscriptOfRows<OtherId>, "another row's id finds nothing");
static_assert(!SubscriptOfRows<int>, "a number names no row");

TEST(IdVector, NamesRowsInTheOrderInWhichTheyCame) {
  Rows rows;
  EXPECT_EQ(rows.push_back("a"), RowId{0});
  EXPECT_EQ(rows.push_back("b"), RowId{1});
  std::string read;
  for (const RowId id : rows.ids())
    read += rows[id];
  EXPECT_EQ(read, "ab");
}

TEST(IdVector, HasItsRowsAndNoOthers) {
  const Rows rows{"a", "b"};
  EXPECT_TRUE(rows.has(RowId{1}));
  EXPECT_FALSE(rows.has(RowId{2}));
  EXPECT_FALSE(rows.has(RowId{-1}));
}

TEST(IdVectorDeathTest, StopsAtARowThatIsNotThere) {
  const Rows rows{"a"};
  EXPECT_DEATH((void)rows[RowId{1}], "has\\(id\\)");
  EXPECT_DEATH((void)rows[RowId{-1}], "has\\(id\\)");
}

}  // namespace
}  // namespace planish
