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

TEST(PartDrawing, SaysOfThePressBrakeWhatAnyFindingSays) {
  const auto made = test::made_from("channel.json", test::channel_plates(30).dump());
  ASSERT_TRUE(made);
  // Findings for information are not drawn themselves.
  const auto with = [&](const std::vector<std::string>& codes) {
    made->report().findings = mapped(codes, [](const std::string& code) {
      return Finding{code, Severity::info, "Said elsewhere.", {}};
    });
    return part_drawing(*made, 0).value();
  };
  const std::string plain = with({}), bent = with({"cannot_bend"}), unplanned = with({"no_plan"});
  EXPECT_NE(bent, plain);
  EXPECT_NE(unplanned, plain);
  EXPECT_NE(unplanned, bent);
  EXPECT_EQ(with({"edge_length"}), plain);
  EXPECT_EQ(with({"edge_length", "cannot_bend"}), bent);
  EXPECT_EQ(with({"no_plan", "edge_length"}), unplanned);
  EXPECT_EQ(with({"no_plan", "cannot_bend"}), bent) << "which says more";
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
