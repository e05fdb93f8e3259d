#include "part_drawing.hpp"

#include "job/job_requests.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::job {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(PartDrawing, IsAPdfUnderTheNameOfThePart) {
  const auto made = test::made_from("channel.json", test::channel_plates(30).dump());
  ASSERT_TRUE(made);
  const auto pdf = part_drawing(*made, 0);
  ASSERT_TRUE(pdf) << pdf.error().message;
  EXPECT_THAT(*pdf, StartsWith("%PDF"));
  EXPECT_THAT(*pdf, HasSubstr("channel"));
  EXPECT_EQ(*part_drawing(*made, 0), *pdf) << "the same bytes";
  made->report().mass = 1.0;
  EXPECT_NE(*part_drawing(*made, 0), *pdf) << "with what is known of it";
}

TEST(PartDrawing, IsMadeOfEachPiece) {
  const auto made = test::made_in_two_pieces();
  ASSERT_TRUE(made);
  const auto first = part_drawing(*made, 0), second = part_drawing(*made, 1);
  ASSERT_TRUE(first && second);
  EXPECT_THAT(*first, HasSubstr("net-1"));
  EXPECT_THAT(*second, HasSubstr("net-2"));
}

}  // namespace
}  // namespace planish::job
