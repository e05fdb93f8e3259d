#include "sample_patterns.hpp"

#include <planish/io/flat_json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

namespace planish {
namespace {

using namespace sample;
using testing::HasSubstr;
using testing::Not;

/// The bracket with one of everything that a pattern can hold.
FlatPattern full_pattern() {
  FlatPattern pattern = bracket_with_petal();
  pattern.slits = {Segment{{10, 10}, {15, 10}}, Arc{{30, 80}, 3.0, 0.1, 1.0 / 3.0}};
  pattern.bends[0].kind = BendKind::general;
  pattern.bends[0].lines.push_back({{62, 0}, {61.5, 100}});
  pattern.bends[0].line_angles = {Angle::degrees(30.1), Angle::degrees(59.9)};
  pattern.bends[0].stroke = 2;
  pattern.bends[1].allowance = {0.44, 4.52, 3.48, "table \"steel\", rows 3 and 4"};
  pattern.features.push_back(
      {"countersink", FormSide::down, {hole({20, 50}, 11.0)}, 1, {{20, 50}}, {{1, 2}}});
  pattern.labels.push_back({{1.0 / 3.0, -0.0}, "plate Ä\n"});
  pattern.area = kBracketArea;
  pattern.perimeter = 0.1;
  pattern.closure = 5e-324;
  return pattern;
}

FlatPattern read_back(const FlatPattern& pattern) {
  const auto read = read_flat_json(flat_json(pattern));
  EXPECT_TRUE(read) << read.error().message;
  return read.value_or(FlatPattern());
}

TEST(FlatJson, GivesTheSameDrawingsAgain) {
  const FlatPattern pattern = full_pattern();
  const FlatPattern again = read_back(pattern);
  for (const auto version : {DxfVersion::r2000, DxfVersion::r12})
    for (const auto splines : {Splines::arcs, Splines::keep}) {
      const DxfOptions options{.version = version, .splines = splines, .tangent_lines = true};
      const auto text = dxf_text(pattern, options), text_again = dxf_text(again, options);
      ASSERT_TRUE(text && text_again);
      EXPECT_EQ(*text_again, *text);
    }
  EXPECT_EQ(svg_text(again), svg_text(pattern));
}

TEST(FlatJson, KeepsWhatNoDrawingShows) {
  const FlatPattern pattern = full_pattern();
  const FlatPattern again = read_back(pattern);
  EXPECT_EQ(again.thickness, pattern.thickness);
  EXPECT_EQ(again.area, pattern.area);
  EXPECT_EQ(again.perimeter, pattern.perimeter);
  EXPECT_EQ(again.closure, pattern.closure);
  ASSERT_EQ(again.bends.size(), 2u);
  EXPECT_EQ(again.bends[0].kind, BendKind::general);
  EXPECT_EQ(again.bends[0].stroke, 2);
  EXPECT_EQ(again.bends[1].stroke, std::nullopt);
  EXPECT_EQ(again.bends[0].line_angles, pattern.bends[0].line_angles);
  EXPECT_EQ(again.bends[0].length, pattern.bends[0].length);
  EXPECT_EQ(again.bends[1].allowance.k_factor, 0.44);
  EXPECT_EQ(again.bends[1].allowance.allowance, 4.52);
  EXPECT_EQ(again.bends[1].allowance.deduction, 3.48);
  EXPECT_EQ(again.bends[1].allowance.source, pattern.bends[1].allowance.source);
  ASSERT_EQ(again.features.size(), 1u);
  EXPECT_EQ(again.features[0].kind, "countersink");
  EXPECT_EQ(again.features[0].side, FormSide::down);
  EXPECT_EQ(again.features[0].uncut_openings, 1);
  EXPECT_EQ(again.features[0].pilots, pattern.features[0].pilots);
  EXPECT_EQ(again.features[0].along, pattern.features[0].along);
  ASSERT_EQ(again.labels.size(), 1u);
  EXPECT_EQ(again.labels[0].text, "plate Ä\n");
  EXPECT_TRUE(std::signbit(again.labels[0].at.y()));
  EXPECT_EQ(flat_json(again), flat_json(pattern));
}

TEST(FlatJson, IsOneLine) { EXPECT_THAT(flat_json(full_pattern()), Not(HasSubstr("\n"))); }

TEST(FlatJson, TakesAnEmptyPattern) { EXPECT_TRUE(read_back({}).outer.loop.empty()); }

RC_GTEST_PROP(FlatJson, KeepsEveryBitOfEveryNumber, ()) {
  std::vector<Vec2> corners;
  for (int i = 0; i < 8; ++i) {
    const auto coordinate = [] {
      const double x = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
      return std::isfinite(x) && std::abs(x) < kFarthest ? x : std::nextafter(x > 0 ? 1.1 : 0.3, 0);
    };
    const double x = coordinate();
    corners.emplace_back(x, coordinate());
  }
  FlatPattern pattern;
  pattern.outer.loop = polygon(corners);
  const auto read = read_flat_json(flat_json(pattern));
  RC_ASSERT(read.has_value());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 at = start_of(read->outer.loop[i]);
    for (int k = 0; k < 2; ++k)
      RC_ASSERT(std::bit_cast<std::uint64_t>(at[k]) == std::bit_cast<std::uint64_t>(corners[i][k]));
  }
}

TEST(FlatJson, RefusesTextThatIsCutOff) {
  const std::string text = flat_json(full_pattern());
  for (std::size_t length = 0; length < text.size(); ++length) {
    const auto read = read_flat_json(text.substr(0, length));
    ASSERT_FALSE(read) << length;
    EXPECT_EQ(read.error().code, code::invalid_input);
  }
}

TEST(FlatJson, RefusesTextWithAnyByteChanged) {
  const std::string text = flat_json(full_pattern());
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string damaged = text;
    damaged[at] = damaged[at] == '1' ? '2' : '1';
    const auto read = read_flat_json(damaged);
    ASSERT_FALSE(read) << damaged.substr(at > 20 ? at - 20 : 0, 40);
    EXPECT_EQ(read.error().code, code::invalid_input);
  }
}

TEST(FlatJson, RefusesOtherVersionsAndFormats) {
  const std::string text = flat_json(bracket());
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    const auto read = read_flat_json(other);
    return read ? std::string() : read.error().message;
  };
  EXPECT_EQ(changed("\"version\":1", "\"version\":2"),
            "The stored flat pattern cannot be read: another version of the program has written "
            "it. Make it again.");
  EXPECT_EQ(changed("planish/flat", "planish/report"),
            "The stored flat pattern cannot be read: it is of another format. Make it again.");
  EXPECT_FALSE(read_flat_json("[]"));
  EXPECT_FALSE(read_flat_json(std::string(100000, '[')));
}

}  // namespace
}  // namespace planish
