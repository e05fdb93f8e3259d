#include "job/job_requests.hpp"

#include <planish/connect/codes.hpp>
#include <planish/job/connect.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using nlohmann::json;

PlatesFile channel_file(const json& plates = test::channel_plates(30)) {
  auto file = parse_plates(plates.dump(), "shop/channel.json");
  EXPECT_TRUE(file);
  return file ? std::move(*file) : PlatesFile{};
}

Request channel_request() {
  Request request;
  request.input = "shop/channel.json";
  request.effort = Effort::draft;
  return request;
}

ConnectReport joined_by(const PlatesFile& file, const Request& request) {
  const auto report = connect_plates(file, request);
  EXPECT_TRUE(report) << (report ? "" : report.error().message);
  return report ? *report : ConnectReport{};
}

TEST(ConnectJob, JoinsThePlatesOfAFile) {
  const ConnectReport report = joined_by(channel_file(), channel_request());
  EXPECT_EQ(report.input, "shop/channel.json");
  EXPECT_EQ(report.body, "channel");
  EXPECT_EQ(report.connection.bends.size(), 2u);
  for (const FittedBend& bend : report.connection.bends)
    EXPECT_EQ(bend.inside_radius, 2.0);
}

TEST(ConnectJob, TakesOptionsInsteadOfTheFilesDefaults) {
  Request request = channel_request();
  request.join.inside_radius = 1.0;
  for (const FittedBend& bend : joined_by(channel_file(), request).connection.bends)
    EXPECT_EQ(bend.inside_radius, 1.0);
}

TEST(ConnectJob, BendsToTheRadiusOfTheShop) {
  Request request = channel_request();
  request.shop = shop::ShopChoice{};
  request.shop->shop.materials = {{.name = "steel",
                                   .density = {},
                                   .tensile_strength = {},
                                   .gauges = {{.thickness = 2.0,
                                               .inside_radius = 1.5,
                                               .k_factor = 0.42,
                                               .k_from = "K",
                                               .smallest_flange = {},
                                               .smallest_opening = {}}}}};
  const auto unchosen = connect_plates(channel_file(), request);
  ASSERT_FALSE(unchosen);
  EXPECT_EQ(unchosen.error().where, "material");
  request.shop->material = 0;
  const ConnectReport report = joined_by(channel_file(), request);
  for (const FittedBend& bend : report.connection.bends)
    EXPECT_EQ(bend.inside_radius, 1.5);
  EXPECT_EQ(report.summary.k_factor, 0.42);
  request.join.inside_radius = 1.0;
  EXPECT_EQ(joined_by(channel_file(), request).connection.bends[0].inside_radius, 1.0)
      << "what is asked for wins";
}

TEST(ConnectJob, IsRefusedWithItsPlaceInTheFile) {
  json plates = test::channel_plates(30);
  plates["bends"][1]["between"][1] = "roof";
  const auto invalid = connect_plates(channel_file(plates), channel_request());
  ASSERT_FALSE(invalid);
  EXPECT_FALSE(invalid.error().shown);
  EXPECT_EQ(invalid.error().code, code::unknown_plate);
  EXPECT_EQ(invalid.error().where.rfind("shop/channel.json/bends/1", 0), 0u);
  plates = test::channel_plates(30);
  plates["plates"][1]["outline"] = {{-60, 0, 0}, {-5, 0, 0}, {-5, 100, 0}, {-60, 100, 0}};
  const auto refused = connect_plates(channel_file(plates), channel_request());
  ASSERT_FALSE(refused);
  EXPECT_TRUE(refused.error().shown);
  EXPECT_EQ(refused.error().code, code::plates_coplanar);
  EXPECT_EQ(refused.error().where.rfind("shop/channel.json/bends/0", 0), 0u);
}

TEST(ConnectJob, FillsTheFirstPartOfTheProgress) {
  std::vector<double> shares;
  Progress progress;
  progress.report = [&](std::string_view, double share) { shares.push_back(share); };
  ASSERT_TRUE(connect_plates(channel_file(), channel_request(), progress));
  ASSERT_FALSE(shares.empty());
  for (std::size_t i = 1; i < shares.size(); ++i)
    EXPECT_GE(shares[i], shares[i - 1]);
  progress.cancelled = [] { return true; };
  const auto stopped = connect_plates(channel_file(), channel_request(), progress);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, code::cancelled);
}

TEST(ConnectJob, ReadsItsFile) {
  Request request = channel_request();
  request.input = test::example("connect/a_folded.json");
  const auto report = connect(request);
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->body, "a_folded");
  EXPECT_GT(report->read_seconds, 0.0);
  request.input = "/no/such.json";
  EXPECT_EQ(connect(request).error().code, code::cannot_read);
}

}  // namespace
}  // namespace planish::job
