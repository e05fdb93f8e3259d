#include "job/job_requests.hpp"

#include <planish/brake/codes.hpp>
#include <planish/job/transition.hpp>
#include <planish/job/transition_json.hpp>
#include <planish/transition/codes.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

using nlohmann::json;

/// A straight duct of 100 × 60, 80 high: four flanges and four sharp folds.
TransitionFile straight_duct() {
  const auto file = parse_transition(
      R"({"thickness": 1,
          "from": {"profile": {"polygon": [[0, 0], [100, 0], [100, 60], [0, 60]]}},
          "to": {"profile": {"polygon": [[0, 0], [100, 0], [100, 60], [0, 60]]},
                 "frame": {"origin": [0, 0, 80]}}})",
      "duct.json");
  EXPECT_TRUE(file) << (file ? "" : file.error().message);
  return file.value_or(TransitionFile{});
}

Request request_for(const std::string& input = "shop/duct.json") {
  Request request;
  request.input = input;
  return request;
}

TransitionReport reported(const TransitionFile& file, const Request& request) {
  const auto report = transition_between(file, request);
  EXPECT_TRUE(report) << (report ? "" : report.error().message);
  return report ? *report : TransitionReport{};
}

TEST(TransitionJob, LaysAStraightDuctFlat) {
  Request request = request_for();
  request.density = 7.85;
  const TransitionReport report = reported(straight_duct(), request);
  ASSERT_EQ(report.pieces.size(), 1u);
  EXPECT_EQ(report.body, "duct");
  EXPECT_EQ(report.pieces[0].body, "duct");
  EXPECT_NEAR(report.transition.area, 320.0 * 80.0, 1e-6);
  EXPECT_NEAR(report.flat.area, 320.0 * 80.0, 1e-3);
  EXPECT_NEAR(report.size.x(), 320.0, 1e-4);
  EXPECT_NEAR(report.size.y(), 80.0, 1e-4);
  EXPECT_NEAR(*report.mass, 7.85e-6 * 320 * 80 * 1, 1e-5) << "kg";
  EXPECT_EQ(report.summary.k_factor, 0.5);
  EXPECT_EQ(report.summary.k_source, "default");
  ASSERT_TRUE(report.pieces[0].solid.has_value());
  EXPECT_EQ(report.status(), Status::ok);
}

TEST(TransitionJob, DrawsADraftWithoutSolidOrCertificate) {
  Request request = request_for();
  request.effort = Effort::draft;
  const TransitionReport report = reported(straight_duct(), request);
  EXPECT_NEAR(report.flat.area, 320.0 * 80.0, 1.0);
  EXPECT_FALSE(report.pieces[0].solid.has_value());
  EXPECT_FALSE(report.certificate.volume_ratio);
  EXPECT_TRUE(report.findings.empty());
}

TEST(TransitionJob, SumsUpItsPieces) {
  TransitionFile file = straight_duct();
  file.spec.pieces = Division::two;
  Request request = request_for();
  request.effort = Effort::draft;
  request.density = 7.85;
  request.units = LengthUnit::inch;
  const TransitionReport report = reported(file, request);
  ASSERT_EQ(report.pieces.size(), 2u);
  double area = 0.0;
  int flanges = 0, bends = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const TransitionPiece& piece = report.pieces[i];
    EXPECT_EQ(piece.body, "duct-" + std::to_string(i + 1));
    EXPECT_EQ(piece.input, "shop/duct.json");
    EXPECT_EQ(piece.units, LengthUnit::inch);
    area += piece.flat.area;
    flanges += piece.summary.flanges;
    bends += piece.summary.bends;
  }
  EXPECT_NEAR(area, 320.0 * 80.0, 1.0);
  EXPECT_NEAR(*report.mass, 7.85e-6 * 320 * 80, 1e-4);
  EXPECT_EQ(report.summary.flanges, flanges);
  EXPECT_EQ(report.summary.bends, bends);
  EXPECT_EQ(report.summary.thickness, 1.0);
}

TEST(TransitionJob, TakesKFromTheCommandThenTheFileThenTheDefault) {
  TransitionFile file = straight_duct();
  Request request = request_for();
  request.effort = Effort::draft;
  file.has_default_k = false;
  file.spec.k_factor = 0.4;
  EXPECT_EQ(reported(file, request).summary.k_factor, 0.4);
  EXPECT_EQ(reported(file, request).summary.k_source, "transition file");
  request.allowance = ConstantK{0.3, "x"};
  const TransitionReport report = reported(file, request);
  EXPECT_EQ(report.summary.k_factor, 0.3);
  EXPECT_EQ(report.spec.k_factor, 0.3) << "the surface moves with it";
  request.allowance = Din6935{};
  const auto ruled = transition_between(file, request);
  ASSERT_FALSE(ruled);
  EXPECT_EQ(ruled.error().code, code::bad_option);
  EXPECT_EQ(ruled.error().where, "din6935");
}

TEST(TransitionJob, IsRefusedWithItsPlaceInTheFile) {
  TransitionFile file = straight_duct();
  file.spec.to.frame.origin = Vec3(0, 0, 0);
  const auto refused = transition_between(file, request_for());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::profiles_meet);
  EXPECT_EQ(refused.error().where.rfind("shop/duct.json", 0), 0u);
  ASSERT_TRUE(refused.error().shown);
  EXPECT_EQ(refused.error().shown->spec.thickness, 1.0);
  file = straight_duct();
  std::get<PolygonProfile>(file.spec.from.profile).corners.resize(2);
  const auto invalid = transition_between(file, request_for());
  ASSERT_FALSE(invalid);
  EXPECT_FALSE(invalid.error().shown) << "an input that is wrong gives no report";
  EXPECT_EQ(invalid.error().where.rfind("shop/duct.json/from/profile/polygon", 0), 0u);
}

TEST(TransitionJob, KeepsThePatternOfAPieceThatIsRefused) {
  Request request = request_for();
  request.bending.ask = Bending::Ask::plan;  // no brake closes a duct
  const auto refused = transition_between(straight_duct(), request);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::cannot_bend);
  ASSERT_TRUE(refused.error().shown);
  EXPECT_NEAR(refused.error().shown->flat.area, 320.0 * 80.0, 1e-3);
  EXPECT_TRUE(refused.error().shown->plan);
}

/// In one piece a duct closes round the punch; of its halves no such thing is said.
TEST(TransitionJob, AdvisesHalvesWhereOnePieceCannotBeBent) {
  TransitionFile file = straight_duct();
  Request request = request_for();
  for (const auto ask : {Bending::Ask::plan, Bending::Ask::finding}) {
    request.bending.ask = ask;
    const auto made = transition_between(file, request);
    if (ask == Bending::Ask::plan) {
      ASSERT_FALSE(made);
      EXPECT_NE(made.error().message.find("`\"pieces\": 2`"), std::string::npos);
      EXPECT_EQ(made.error().remedies.back().change, "\"pieces\": 2");
    } else {
      ASSERT_TRUE(made) << made.error().message;
      const auto found = std::ranges::find(made->findings, "cannot_bend", &Finding::code);
      ASSERT_NE(found, made->findings.end());
      EXPECT_NE(found->message.find("`\"pieces\": 2`"), std::string::npos);
    }
  }
  file.spec.pieces = Division::two;
  request.bending.ask = Bending::Ask::plan;
  EXPECT_TRUE(transition_between(file, request));
}

TEST(TransitionJob, ReadsItsFile) {
  Request request = request_for(test::example("transition/a_square_to_round.json"));
  request.effort = Effort::draft;
  const auto report = transition(request);
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->body, "a_square_to_round");
  EXPECT_GT(report->read_seconds, 0.0);
  EXPECT_EQ(transition(request_for("/no/such.json")).error().code, code::cannot_read);
}

}  // namespace
}  // namespace planish::job
