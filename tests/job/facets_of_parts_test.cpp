#include "support/real_parts.hpp"

#include <planish/job/unfold.hpp>
#include <planish/sheet/facets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>

// What the studio shows of real parts against their flat patterns: no material is missing where a
// bend is, none is there where the pattern is cut, and what is drawn is not shown as cut.

namespace planish::test {
namespace {

namespace fs = std::filesystem;

constexpr double kChord = 1e-3, kOn = 2e-3;  // mm

double area_of(const Polygon& polygon) {
  double area = ring_area(polygon.outer);
  for (const auto& hole : polygon.holes)
    area += ring_area(hole);
  return area;
}

double distance(const std::vector<Vec2>& ring, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < ring.size(); ++i)
    least = std::min(least, nearest(Segment{ring[i], ring[(i + 1) % ring.size()]}, p).distance);
  return least;
}

bool winds_about(const std::vector<Vec2>& ring, const Vec2& p) {
  bool inside = false;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

bool covers(const Facet& facet, const Vec2& p) {
  return std::ranges::any_of(facet.polygons, [&](const Polygon& polygon) {
    if (distance(polygon.outer, p) <= kOn) return true;
    return winds_about(polygon.outer, p) &&
           std::ranges::none_of(polygon.holes,
                                [&](const auto& hole) { return winds_about(hole, p); });
  });
}

/// Each bend that takes room has facets, on which its lines lie; one that takes none is a line
/// between facets.
void expect_bend_lines_on_facets(const FlatPattern& flat, const Facets& facets) {
  for (const FlatBend& bend : flat.bends) {
    std::vector<const Facet*> own, all;
    for (const Facet& facet : facets.facets) {
      all.push_back(&facet);
      if (facet.part == PartId(bend.bend)) own.push_back(&facet);
    }
    if (bend.allowance.allowance > kOn) {
      EXPECT_FALSE(own.empty()) << bend.id;
    }
    for (const Segment& line : bend.lines)
      for (const double t : {0.02, 0.25, 0.5, 0.75, 0.98}) {
        const Vec2 p = (1.0 - t) * line.a + t * line.b;
        const auto& there = own.empty() ? all : own;
        EXPECT_TRUE(
            std::ranges::any_of(there, [&](const Facet* facet) { return covers(*facet, p); }))
            << bend.id << " at (" << p.x() << ", " << p.y() << ")";
      }
  }
}

double length_of(const Loop& loop) {
  double sum = 0.0;
  for (const Curve2& curve : loop)
    sum += length(curve);
  return sum;
}

/// What the facets cut and draw is as long as what the pattern cuts and draws.
void expect_lines_of_the_pattern(const FlatPattern& flat, const Facets& facets) {
  double cut = 0.0, drawn = 0.0, outlines = 0.0;
  for (const auto& [curve, feature] : facets.borders)
    (feature ? drawn : cut) += length(curve);
  for (const FlatFeature& feature : flat.features)
    for (const Loop& outline : feature.outlines)
      outlines += length_of(outline);
  constexpr double kMerged = 1e-4;  // of a length: curves that are merged in the pattern
  EXPECT_NEAR(cut, flat.perimeter, kMerged * flat.perimeter);
  EXPECT_NEAR(drawn, outlines, kMerged * (1.0 + outlines));
}

void expect_facets_cover(const job::UnfoldReport& report) {
  SCOPED_TRACE("body " + std::to_string(report.number));
  const Facets facets = facets_of(report.sheet, report.layout,
                                  {.chord = kChord, .most = Angle::degrees(1.0)});
  double area = 0.0;
  for (const Facet& facet : facets.facets)
    for (const Polygon& polygon : facet.polygons)
      area += area_of(polygon);
  // Chords lie within `kChord` of the borders.
  EXPECT_NEAR(area, report.flat.area, kChord * report.flat.perimeter);
  expect_bend_lines_on_facets(report.flat, facets);
  expect_lines_of_the_pattern(report.flat, facets);
}

TEST(FacetsOfRealParts, CoverTheFlatPatternAndCarryItsLines) {
  if (!fs::exists(real_parts_folder())) GTEST_SKIP() << kNoRealParts;
  int shown = 0;
  for (const auto& entry : fs::directory_iterator(real_parts_folder())) {
    if (entry.path().extension() != ".step") continue;
    SCOPED_TRACE(entry.path().stem().string());
    job::Request request;
    request.input = entry.path();
    request.effort = job::Effort::draft;
    const auto bodies = job::unfold_all(request);
    if (!bodies) continue;  // not a STEP file with solids: tests/job/corpus_test.cpp
    for (const auto& body : *bodies) {
      if (!body) continue;
      expect_facets_cover(*body);
      ++shown;
    }
  }
  if (shown == 0) GTEST_SKIP() << kNoRealParts;
}

}  // namespace
}  // namespace planish::test
