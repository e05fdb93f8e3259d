#include "made_report.hpp"

#include <planish/job/connect.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace planish::job {
namespace {

using schema::Json;

TEST(MadeReport, GivesPointsToThePage) {
  EXPECT_EQ(page_point({1.5, -2, 3}), Json::parse("[1.5, -2.0, 3.0]"));
  EXPECT_EQ(page_point({std::nan(""), HUGE_VAL, 3}), Json::parse("[null, null, 3.0]"));
  EXPECT_TRUE(page_point({0, 0, -HUGE_VAL})[2].is_null());
  EXPECT_EQ(page_points({}), Json::array());
  EXPECT_EQ(page_points({{1, 2, 3}, {4, 5, 6}}), Json::parse("[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]"));
}

TEST(MadeReport, GivesOneLineToThePageWhateverNamesHold) {
  EXPECT_EQ(page_text({{"id", "tr\xE4ger"}, {"n", 1}}), "{\"id\":\"tr\uFFFDger\",\"n\":1}");
}

TEST(MadeReport, RepeatsTheRequest) {
  Request request;
  request.input = "shop/plates.v2.json";
  auto report = begun<ConnectReport>(request, LengthUnit::inch);
  EXPECT_EQ(report.input, "shop/plates.v2.json");
  EXPECT_EQ(report.body, "plates.v2");
  EXPECT_EQ(report.units, LengthUnit::inch) << "the file's";
  EXPECT_FALSE(report.refusal);
  request.units = LengthUnit::m;
  request.input = "-";
  report = begun<ConnectReport>(request, LengthUnit::inch);
  EXPECT_EQ(report.units, LengthUnit::m) << "the request's";
  EXPECT_EQ(report.body, "stdin");
  const auto failed = failed_report<ConnectReport>(request, {code::invalid_input, "m", "w"});
  EXPECT_EQ(failed.refusal->where, "w");
  EXPECT_EQ(failed.status(), Status::refused);
}

}  // namespace
}  // namespace planish::job
