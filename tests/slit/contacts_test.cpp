#include "contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Two flat strips, 100 by 20, of four quads, of which one lies 12 over the other's edge.

namespace planish::test {
namespace {

using namespace slit_detail;

constexpr double kThickness = 3.0;

FoldedStrip flat_strip(const Vec3& origin, double tilt = 0.0) {
  Frame frame = frame_from_axes(origin, {-std::sin(tilt), 0, std::cos(tilt)},
                                {std::cos(tilt), 0, std::sin(tilt)});
  StripBase base{frame, {0.0, 20.0}, {0.0, 0.0}, {100.0, 100.0}, 4};
  return folded_strip(base, flat_parameters(base));
}

Missing lacking(OnTop on_top, const FoldedStrip& left, const FoldedStrip& right) {
  return missing(pair_of(0, 1, left, on_top), left, right, kThickness);
}

/// Nine stations but that where a strip begins, on one edge of each strip.
constexpr double kPoints = 16.0;

TEST(Contacts, OfDividedQuadsPressAsMuchAtTheSamePlaces) {
  const FoldedStrip left = flat_strip({0, 0, 0}), right = flat_strip({0, 8, 1});
  std::vector<Contact> coarse = contacts_of(pair_of(0, 1, left, OnTop::right), left, right,
                                            kThickness);
  // The place of a point along its strip, in quads.
  const auto place = [](const Contact& contact) {
    double sum = 0.0;
    for (const StripPoint::Share& share : contact.here.shares)
      sum += share.weight * share.ridge;
    return sum;
  };
  double pressed = 0.0, moment = 0.0, number = 0.0;
  for (Contact& contact : coarse) {
    contact.multiplier = ++number;
    pressed += contact.multiplier;
    moment += contact.multiplier * place(contact);
  }
  double fine_pressed = 0.0, fine_moment = 0.0;
  for (const Contact& contact : subdivided(coarse)) {
    fine_pressed += contact.multiplier;
    fine_moment += contact.multiplier * place(contact);
    EXPECT_NEAR(2.0 * place(contact), std::round(2.0 * place(contact)), 1e-12) << "a station";
  }
  EXPECT_NEAR(fine_pressed, pressed, 1e-12 * pressed);
  EXPECT_NEAR(fine_moment, 2.0 * moment, 1e-12 * moment);
}

TEST(Contacts, AskForAThicknessWhereStripsOverlap) {
  const FoldedStrip left = flat_strip({0, 0, 0});
  for (const double above : {1.0, 2.5, -1.0}) {
    const FoldedStrip right = flat_strip({0, 8, above});
    const Missing on_top = lacking(OnTop::right, left, right),
                  below = lacking(OnTop::left, left, right);
    EXPECT_NEAR(on_top.most, kThickness - above, 1e-12);
    EXPECT_NEAR(on_top.squares, kPoints * (kThickness - above) * (kThickness - above), 1e-9);
    EXPECT_NEAR(below.most, kThickness + above, 1e-12);
  }
  EXPECT_EQ(lacking(OnTop::right, left, flat_strip({0, 8, 3.5})).most, 0.0);
}

TEST(Contacts, AskForNothingBesideAndFarAbove) {
  const FoldedStrip left = flat_strip({0, 0, 0});
  for (const auto& right : {flat_strip({0, 20, 0}), flat_strip({0, 26, -5}), flat_strip({0, 8, 40}),
                            flat_strip({0, 45, 0})})
    for (const OnTop on_top : {OnTop::left, OnTop::right})
      EXPECT_EQ(lacking(on_top, left, right).most, 0.0);
}

TEST(Contacts, LeadFromTheEdgeOverTheStripOnASlope) {
  const FoldedStrip left = flat_strip({0, 0, 0});
  // 2 over the edge: as much above is enough.
  const double root = std::numbers::sqrt2 / 2.0;
  EXPECT_NEAR(lacking(OnTop::right, left, flat_strip({0, 18, 0.5})).most, 1.5 * root, 1e-12);
  EXPECT_EQ(lacking(OnTop::right, left, flat_strip({0, 18, 2.0})).most, 0.0);
  // Far below where it should be above and hardly over the edge: back over the edge is nearer.
  EXPECT_NEAR(lacking(OnTop::right, left, flat_strip({0, 19.75, -6})).most, 0.25, 1e-12);
}

TEST(Contacts, PushStripsApartAlongWhatTheyLack) {
  const FoldedStrip left = flat_strip({0, 0, 0}), right = flat_strip({0, 8, 1});
  int facing = 0;
  for (const Contact& contact :
       contacts_of(pair_of(4, 5, left, OnTop::right), left, right, kThickness)) {
    const bool of_left = contact.here.strip == 4;
    EXPECT_EQ(contact.there.strip, of_left ? 5 : 4);
    double sum = 0.0;
    Vec3 here = Vec3::Zero(), there = Vec3::Zero();
    for (const auto& share : contact.here.shares)
      here += share.weight * (of_left ? left : right).ridges[share.ridge].folded[share.side];
    for (const auto& share : contact.there.shares) {
      there += share.weight * (of_left ? right : left).ridges[share.ridge].folded[share.side];
      sum += share.weight;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    if (contact.here.shares.front().side != (of_left ? 1 : 0)) {
      EXPECT_GE(contact.normal.dot(here - there), contact.offset) << "beside the other strip";
      continue;
    }
    ++facing;
    const double up = of_left ? -1.0 : 1.0;
    EXPECT_LE((contact.normal - up * Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_EQ(contact.offset, kThickness);
    EXPECT_LE((here - there - up * Vec3::UnitZ()).norm(), 1e-9);
  }
  EXPECT_EQ(facing, kPoints);
}

/// The right strip rises through the left one at a third of its length.
TEST(Contacts, SeeWhereAnEdgeGoesThrough) {
  const double tilt = std::atan(0.2);
  const FoldedStrip left = flat_strip({0, 0, 0}), right = flat_strip({0, 8, -20.0 / 3.0}, tilt);
  bool seen = false;
  for (const Contact& contact :
       contacts_of(pair_of(0, 1, left, OnTop::right), left, right, kThickness)) {
    if (contact.here.strip != 1 || contact.here.shares.size() != 2) continue;
    Vec3 at = Vec3::Zero();
    for (const auto& share : contact.here.shares)
      at += share.weight * right.ridges[share.ridge].folded[share.side];
    seen |= (at - Vec3(100.0 / 3.0, 8, 0)).norm() < 1e-9;
  }
  EXPECT_TRUE(seen);
}

TEST(Contacts, TakeTheNearerOfTwoStripsOnTopStretchByStretch) {
  const FoldedStrip left = flat_strip({0, 0, 0});
  const auto all = [&](const FoldedStrip& right) {
    return nearest_pair(0, 1, left, right, kThickness).on_top;
  };
  EXPECT_EQ(all(flat_strip({0, 8, 1})), std::vector<OnTop>(9, OnTop::right));
  EXPECT_EQ(all(flat_strip({0, 8, -1})), std::vector<OnTop>(9, OnTop::left));
  // Turned in its plane about a place in the middle: over the left one at the one end, beside it at
  // the other.
  Frame turned = frame_from_axes({0, 18, -1}, Vec3::UnitZ(), {1, 0.08, 0});
  const StripBase base{turned, {0.0, 20.0}, {0.0, 0.0}, {100.0, 100.0}, 4};
  const auto some = all(folded_strip(base, flat_parameters(base)));
  EXPECT_EQ(some.front(), OnTop::left);
}

}  // namespace
}  // namespace planish::test
