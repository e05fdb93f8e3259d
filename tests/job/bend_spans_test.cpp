#include "bend_spans.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

// What `connect` says of bends that hold but that a shop would ask about.

namespace planish::job {
namespace {

using ::testing::HasSubstr;

Plate rectangle(const std::string& id, const Vec3& o, const Vec3& a, const Vec3& b) {
  return {id, {o, o + a, o + a + b, o + b}, {}};
}

ConnectReport connected(std::vector<Plate> plates, std::vector<BendRequest> bends = {}) {
  PlatesFile file;
  file.structure.thickness = 2.0;
  file.structure.plates = std::move(plates);
  file.structure.bends = std::move(bends);
  const auto report = connect_plates(file, {});
  EXPECT_TRUE(report) << (report ? "" : report.error().message);
  return report ? *report : ConnectReport{};
}

/// The finding of that code, which has one place; empty if there is none.
std::string said(const ConnectReport& report, const std::string& code) {
  const auto found = std::ranges::find(report.findings, code, &Finding::code);
  if (found == report.findings.end()) return {};
  EXPECT_EQ(found->severity, Severity::warning);
  EXPECT_EQ(found->at.size(), 1u);
  return found->message;
}

const Plate kFloor = rectangle("A", {0, 0, 0}, {200, 0, 0}, {0, 100, 0});

TEST(SpanFindings, AreNoneForAnOrdinaryBend) {
  const auto report = connected({kFloor, rectangle("B", {0, 110, 10}, {200, 0, 0}, {0, 0, 60})});
  for (const char* code : {"round_the_back", "long_span", "unused_edge", "edges_beside"})
    EXPECT_EQ(said(report, code), "") << code;
}

TEST(SpanFindings, NameABendRoundTheBack) {
  // The outer edges of plates whose inner edges face each other.
  const auto report = connected(
      {kFloor, rectangle("B", {0, 110, 10}, {200, 0, 0}, {0, 0, 100})},
      {{.between = {"A", "B"}, .edges = {std::vector{0}, std::vector{2}}}});
  const std::string message = said(report, "round_the_back");
  EXPECT_THAT(message, HasSubstr("B1 between \"A\" and \"B\" turns 270° round the back"));
  EXPECT_THAT(message, HasSubstr("need 90°"));
}

TEST(SpanFindings, NameABendManyTimesLongerThanWide) {
  // 10 mm wide, an arc of radius 60 at a right angle.
  const auto report = connected({rectangle("A", {0, 0, 0}, {10, 0, 0}, {0, 100, 0}),
                                 rectangle("B", {0, 160, 60}, {10, 0, 0}, {0, 0, 60})});
  EXPECT_THAT(said(report, "long_span"), HasSubstr("10 mm wide: 9."));
}

TEST(SpanFindings, WriteLengthsInPlainDigits) {
  const auto report = connected({rectangle("A", {0, 0, 0}, {10, 0, 0}, {0, 100, 0}),
                                 rectangle("B", {0, 12100, 12000}, {10, 0, 0}, {0, 0, 12000})});
  const std::string message = said(report, "long_span");
  EXPECT_THAT(message, HasSubstr("mm long"));
  EXPECT_THAT(message, ::testing::Not(HasSubstr("e+")));
}

TEST(SpanFindings, NameEdgesThatLieBesideEachOther) {
  const auto report = connected({kFloor, rectangle("B", {205, 110, 10}, {150, 0, 0}, {0, 0, 60})});
  EXPECT_THAT(said(report, "edges_beside"), HasSubstr("beside each other, 5 mm apart"));
  const auto touching = connected(
      {kFloor, rectangle("B", {200, 110, 10}, {150, 0, 0}, {0, 0, 60})});
  EXPECT_THAT(said(touching, "edges_beside"), HasSubstr("beside each other, 0 mm apart"));
}

TEST(SpanFindings, NameEdgesThatAreHardlyUsed) {
  // Of two edges of 200 only 40 lie opposite each other.
  const auto report = connected({kFloor, rectangle("B", {160, 110, 10}, {200, 0, 0}, {0, 0, 60})});
  EXPECT_THAT(said(report, "unused_edge"),
              HasSubstr("is 40 mm wide, and the edges of the plates on its tangent lines have 160 "
                        "mm and 160 mm more"));
  // A short wall on a long floor uses all of its own edge.
  EXPECT_EQ(said(connected({kFloor, rectangle("B", {160, 110, 10}, {40, 0, 0}, {0, 0, 60})}),
                 "unused_edge"),
            "");
}

TEST(TrimFindings, TellAllOpenJointsInOneSentence) {
  std::vector<Plate> plates{rectangle("floor", {0, 0, 0}, {200, 0, 0}, {0, 100, 0}),
                            rectangle("front", {0, 0, 0}, {200, 0, 0}, {0, 0, 50}),
                            rectangle("back", {0, 100, 0}, {200, 0, 0}, {0, 0, 50}),
                            rectangle("left", {0, 0, 0}, {0, 100, 0}, {0, 0, 50}),
                            rectangle("right", {200, 0, 0}, {0, 100, 0}, {0, 0, 50})};
  const auto report = connected(std::move(plates));
  ASSERT_EQ(std::ranges::count(report.findings, "joint_left_open", &Finding::code), 1);
  const auto found = std::ranges::find(report.findings, "joint_left_open", &Finding::code);
  // Of each joint both plates and both ends.
  EXPECT_EQ(found->about.size(), 4u * 4u);
}

}  // namespace
}  // namespace planish::job
