// Files judged by another program: ezdxf, through tools/check_dxf.py.
#include "dxf_reading.hpp"
#include "sample_patterns.hpp"

#include <planish/geometry/curve.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace planish {
namespace {

using namespace sample;
using testing::HasSubstr;

class DxfByEzdxf : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_ezdxf()) GTEST_SKIP() << PLANISH_PYTHON " has no ezdxf (Debian: python3-ezdxf)";
  }
};

std::string drawn(const FlatPattern& pattern, const DxfOptions& options = {}) {
  return dxf_text(pattern, options).value();
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST_F(DxfByEzdxf, IsRightInEveryProfileVersionAndUnit) {
  FlatPattern pattern = bracket();
  pattern.features.push_back({"formed", FormSide::up, {rectangle({70, 60}, {90, 80})}});
  std::vector<Check> checks;
  for (const LayerProfile profile : {LayerProfile::standard, LayerProfile::inventor,
                                     LayerProfile::onshape, LayerProfile::solid_edge}) {
    for (const DxfVersion version : {DxfVersion::r2000, DxfVersion::r12}) {
      for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch, LengthUnit::m}) {
        for (const bool tangents : {false, true}) {
          checks.push_back({drawn(pattern, {.profile = profile,
                                            .version = version,
                                            .units = unit,
                                            .tangent_lines = tangents}),
                            kBracketArea, 1e-13});
        }
      }
    }
  }
  for (const auto& report : checked(checks)) {
    EXPECT_TRUE(report["ok"]) << report.dump(1);
    EXPECT_EQ(report["outer"], 1);
    EXPECT_EQ(report["openings"], 2);
    EXPECT_EQ(report["circles"], 1);
    EXPECT_EQ(report["bend_up"], 1);
    EXPECT_EQ(report["bend_down"], 1);
    EXPECT_EQ(report["features"], 1);
  }
}

TEST_F(DxfByEzdxf, KeepsTheAreaUnderArcsWithinTheToleranceAndUnderSplinesExactly) {
  const FlatPattern pattern = bracket_with_petal();
  const double area = kBracketArea - kPetalArea;
  const double perimeter = length(pattern.openings.back().loop);
  std::vector<Check> checks;
  for (const double tolerance : {0.1, 0.01, 0.001}) {
    checks.push_back(
        {drawn(pattern, {.arc_tolerance = tolerance}), area, tolerance * perimeter / area});
  }
  for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch, LengthUnit::m}) {
    checks.push_back({drawn(pattern, {.splines = Splines::keep, .units = unit}), area, 1e-13});
  }
  for (const auto& report : checked(checks))
    EXPECT_TRUE(report["ok"]) << report.dump(1);
}

/// A half disc of radius 10 whose flat side is a wave, and so of the half disc's area.
Loop wavy_half_disc() {
  return {CubicSpline{{{-10, 0}, {-5, 8}, {5, -8}, {10, 0}}}, Arc{{0, 0}, 10.0, 0.0, kPi}};
}

TEST_F(DxfByEzdxf, ChainsSplinesArcsAndLinesWithoutAGap) {
  FlatPattern wave;
  wave.outer.loop = wavy_half_disc();
  FlatPattern turned = wave;
  turned.outer.loop = transformed(
      wave.outer.loop, Isometry2(Eigen::Rotation2Dd(0.7)) * Eigen::Translation2d(1234.5, -77.7));
  // Most of a turn, and an arc so flat that no ARC holds its ends: 10⁷ mm of radius.
  FlatPattern flat;
  const double half = std::asin(50.0 / 1e7);
  flat.outer.loop = {Arc{{0, 1e7 * std::cos(half)}, 1e7, -kPi / 2 - half, 2 * half},
                     CubicSpline{{{50, 0}, {50, 30}, {50, 70}, {50, 100}}},
                     Segment{{50, 100}, {-50, 100}}, Segment{{-50, 100}, {-50, 0}}};
  const double sliver = 1e14 * (half - std::sin(half) * std::cos(half));
  const auto reports = checked({{drawn(wave, {.splines = Splines::keep}), 50.0 * kPi, 1e-13},
                                {drawn(turned, {.splines = Splines::keep}), 50.0 * kPi, 1e-12},
                                {drawn(flat, {.splines = Splines::keep}), 1e4 + sliver, 1e-9}});
  for (const auto& report : reports) {
    EXPECT_TRUE(report["ok"]) << report.dump(1);
    EXPECT_EQ(report["outer"], 1);
  }
  EXPECT_EQ(reports[2]["splines"], 2);
}

TEST_F(DxfByEzdxf, SeesTheSamePartHoweverItIsMovedTurnedMirroredOrScaled) {
  std::vector<Check> checks;
  for (const double scale : {0.1, 1.0, 10.0}) {
    for (const bool mirrored : {false, true}) {
      Isometry2 motion = Isometry2::Identity();
      motion.translate(Vec2(-300.0, 5000.0)).rotate(1.1);
      if (mirrored) motion.linear() *= Vec2(1, -1).asDiagonal();
      FlatPattern pattern;
      Loop outer = transformed(rectangle(Vec2(0, 0), scale * Vec2(200, 100)), motion);
      Loop slot = transformed(obround(scale * Vec2(100, 30), scale * 12.0, scale * 5.0), motion);
      std::rotate(outer.begin(), outer.begin() + 1, outer.end());
      std::rotate(slot.begin(), slot.begin() + 3, slot.end());
      pattern.outer.loop = mirrored ? reversed(outer) : outer;
      pattern.openings.push_back({mirrored ? reversed(slot) : slot, {}});
      checks.push_back({drawn(pattern), scale * scale * (20000.0 - 240.0 - 25.0 * kPi), 1e-9});
    }
  }
  for (const auto& report : checked(checks))
    EXPECT_TRUE(report["ok"]) << report.dump(1);
}

// The judge itself: each file breaks one rule, and the report names it.
TEST_F(DxfByEzdxf, RejectsWhatAShopWouldReject) {
  const std::string good = drawn(bracket());
  const double area = kBracketArea;
  FlatPattern outside = bracket();
  outside.openings.push_back({hole({300, 50}, 5.0), {}});
  FlatPattern nested = bracket();
  nested.openings.push_back({hole({20, 50}, 2.0), {}});
  FlatPattern in_the_air = bracket();
  in_the_air.bends.push_back(bend("B3", BendDirection::up, {{15, 50}, {25, 50}}, 1.0));
  const std::string chain = drawn(
      [] {
        FlatPattern wave;
        wave.outer.loop = wavy_half_disc();
        return wave;
      }(),
      {.splines = Splines::keep});
  const std::string text_entity =
      "  0\nTEXT\n  8\nOUTER_PROFILE\n 10\n0.0\n 20\n0.0\n 40\n2.5\n  1\nBracket\n  0\nENDSEC\n  "
      "0\nEOF\n";
  const std::string r12 = drawn(bracket(), {.version = DxfVersion::r12});

  const struct {
    std::string text;
    double area;
    std::string complaint;
  } rows[] = {
      {good, area * (1 + 1e-8), "the area is"},
      {replaced(good, " 90\n4\n 70\n1\n", " 90\n4\n 70\n0\n"), area, "not closed"},
      {replaced(good, "$INSUNITS", "$SKPOLY"), area, "$INSUNITS is not in the file"},
      {replaced(good, "$MEASUREMENT\n 70\n1", "$MEASUREMENT\n 70\n0"), area, "$MEASUREMENT is 0"},
      {replaced(good, "  6\nDASHED\n 62\n5\n100\nAcDbLine",
                "  6\nCONTINUOUS\n 62\n5\n100\nAcDbLine"),
       area, "not DASHED itself"},
      {replaced(good, " 62\n5\n100\nAcDbLine", "100\nAcDbLine"), area, "without a colour"},
      {replaced(r12, "  0\nENDSEC\n  0\nEOF\n", text_entity), area, "TEXT in a cutting file"},
      {drawn(outside), area - 25 * kPi, "outside the outer contour"},
      {drawn(nested), area - 4 * kPi, "inside another"},
      {drawn(in_the_air), area, "no material"},
      {replaced(chain, " 10\n-10.0\n 20\n0.0\n 30\n0.0\n 10\n-5.0",
                " 10\n-10.00000001\n 20\n0.0\n 30\n0.0\n 10\n-5.0"),
       50 * kPi, "an open end"},
      {replaced(good, "$EXTMAX\n 10\n200.0", "$EXTMAX\n 10\n201.0"), area, "$EXTMAX are"},
      {"no DXF at all", area, "cannot read"},
  };
  std::vector<Check> checks;
  for (const auto& row : rows)
    checks.push_back({row.text, row.area});
  const auto reports = checked(checks);
  for (std::size_t i = 0; i < std::size(rows); ++i) {
    EXPECT_FALSE(reports[i]["ok"]) << rows[i].complaint;
    EXPECT_THAT(reports[i]["errors"].dump(), HasSubstr(rows[i].complaint));
  }
}

}  // namespace
}  // namespace planish
