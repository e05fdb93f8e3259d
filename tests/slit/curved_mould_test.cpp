#include "sample_sheets.hpp"
#include "support/closed_mesh.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/slit/mould.hpp>
#include <planish/slit/slit_curves.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

// Moulds of sheets whose strips have curved edges, end at a second panel, or are joined where they
// end. Seen by rays and distances to the triangles of the sheet, which know nothing of quads and
// ribs: working surfaces lie half the thickness from the sheet, ribs do not come up through it,
// stay below their own strip and stand apart.

namespace planish::test {
namespace {

struct Sample {
  const char* name;
  SlitDesign design;
};

SlitDesign between(SlitDesign design, double width, const std::vector<BezierCurve>& slits) {
  CurvedSlits curves;
  curves.width = width;
  for (const BezierCurve& slit : slits)
    curves.slits.push_back(chain_on(slit, 0.02));
  auto strips = strips_between(design.sheet, curves);
  if (!strips) throw std::runtime_error(strips.error().message);
  design.sheet.strips = *strips;
  return design;
}

/// A thin chair between slits that swing to and fro: their sagitta from ridge to ridge is more than
/// the sheet is thick.
SlitDesign swinging_chair() {
  SlitDesign design = chair();
  design.sheet.thickness = 1.0;
  design.leg_curve = {{{360, 0}, {360, 240}}};
  design.seat_curve = BezierCurve{{{330, 0}, {320, 80}, {330, 160}, {420, 240}}};
  std::vector<BezierCurve> slits;
  for (const double across : {80.0, 160.0})
    slits.push_back({{{420, across},
                      {520, across},
                      {560, across + 60},
                      {650, across - 60},
                      {740, across},
                      {884, across}}});
  return between(design, 240.0, slits);
}

/// Strips that are narrowest in the middle, between two panels, one of which leans.
SlitDesign waisted_bridge() {
  SlitDesign design = arcade();
  design.sheet.thickness = 1.5;
  design.second_panel->lean = Angle::degrees(12);
  std::vector<BezierCurve> slits;
  for (const double across : {60.0, 120.0})
    slits.push_back({{{200, across},
                      {600, across},
                      {500, 90 + 0.4 * (across - 90)},
                      {900, 90 + 0.4 * (across - 90)},
                      {800, across},
                      {1200, across}}});
  return between(design, 180.0, slits);
}

SlitDesign joined_bench() {
  SlitDesign design = chair();
  design.seat_curve.reset();
  design.sheet.thickness = 2.0;
  design.leg_curve = {{{330, 0}, {330, 180}}};
  return between(design, 180.0,
                 {{{{420, 60}, {600, 70}, {840, 60}}}, {{{420, 120}, {600, 110}, {830, 120}}}});
}

std::vector<Sample> samples() {
  return {{"swinging chair", swinging_chair()},
          {"waisted bridge", waisted_bridge()},
          {"joined bench", joined_bench()}};
}

double distance_to(const Mesh& mesh, const Vec3& p) {
  double least = 1e300;
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    const Vec3 normal = (b - a).cross(c - a);
    const Vec3 foot = p - normal.dot(p - a) / normal.squaredNorm() * normal;
    const auto inside = [&](const Vec3& u, const Vec3& v) {
      return (v - u).cross(foot - u).dot(normal) >= 0.0;
    };
    if (inside(a, b) && inside(b, c) && inside(c, a)) {
      least = std::min(least, (foot - p).norm());
      continue;
    }
    for (const auto& [u, v] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
      const double share = std::clamp((v - u).dot(p - u) / (v - u).squaredNorm(), 0.0, 1.0);
      least = std::min(least, (u + share * (v - u) - p).norm());
    }
  }
  return least;
}

/// Heights above `p` at which a ray along `up` meets a mesh.
std::vector<double> met_above(const Mesh& mesh, const Vec3& p, const Vec3& up) {
  std::vector<double> heights;
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.points[t[0]], u = mesh.points[t[1]] - a, v = mesh.points[t[2]] - a;
    const double det = u.dot(up.cross(v));
    if (std::abs(det) < 1e-12) continue;
    const Vec3 from = p - a;
    const double s = from.dot(up.cross(v)) / det, r = up.dot(from.cross(u)) / det;
    if (s >= 0.0 && r >= 0.0 && s + r <= 1.0) heights.push_back(v.dot(from.cross(u)) / det);
  }
  std::ranges::sort(heights);
  return heights;
}

Vec3 place_in(const std::array<Vec3, 4>& facet, double s, double r) {
  return (1 - s) * ((1 - r) * facet[0] + r * facet[3]) + s * ((1 - r) * facet[1] + r * facet[2]);
}

double largest_fold(const FoldedSlitSheet& folded, int strip) {
  double largest = 0.0;
  for (const SlitRidge& ridge : folded.strips[strip].ridges)
    largest = std::max(largest, std::abs(ridge.fold.radians()));
  return largest;
}

TEST(CurvedMould, TouchesTheUndersideAndStandsApart) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const auto& [name, design] : samples()) {
    const FoldedSlitSheet folded = solved(design, 1).folded();
    const auto began = std::chrono::steady_clock::now();
    const auto mould = mould_of(folded);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    ASSERT_TRUE(mould) << name << ": " << mould.error().message;
    EXPECT_LT(took.count(), 3.0) << name;
    const Mesh sheet = mesh_of(folded), ribs = mesh_of(*mould);
    expect_closed(ribs);
    ASSERT_GE(mould->ribs.size(), folded.strips.size()) << name;
    const Vec3& up = mould->base.z;
    const double half = 0.5 * folded.thickness;
    for (const MouldRib& rib : mould->ribs)
      for (std::size_t facet = 0; facet < rib.facets.size(); ++facet)
        for (int i = 0; i < 12; ++i) {
          // Also along the rib's very sides.
          const double r = i == 0 ? 1e-4 : i == 1 ? 1.0 - 1e-4 : share(random);
          const Vec3 p = place_in(rib.facets[facet], share(random), r);
          // At the line between facets it is as far as the mitre says, never nearer.
          const double away = distance_to(sheet, p);
          EXPECT_GE(away, half - 1e-6) << name << " strip " << rib.strip << " at " << r;
          EXPECT_LE(away, half / std::cos(0.5 * largest_fold(folded, rib.strip)) + 1e-6)
              << name << " strip " << rib.strip << " facet " << rib.first_quad + facet << " at "
              << r;
          // The sheet is first met above it, and nothing of it is between it and the base.
          const Vec3 below = p - (p - mould->base.origin).dot(up) * up;
          const auto met = met_above(sheet, below, up);
          ASSERT_FALSE(met.empty()) << name << " strip " << rib.strip << " at " << r;
          EXPECT_GT(met.front(), (p - below).dot(up)) << name << " strip " << rib.strip;
          // And no other rib stands there.
          const auto own = met_above(ribs, below - 10.0 * up, up);
          ASSERT_FALSE(own.empty()) << name;
          EXPECT_NEAR(own.back() - 10.0, (p - below).dot(up), 1e-6)
              << name << " strip " << rib.strip;
        }
  }
}

TEST(CurvedMould, InOneBodyIsClosedAndKeepsClearOfTheSheet) {
  for (const auto& [name, design] : samples()) {
    const FoldedSlitSheet folded = solved(design, 1).folded();
    MouldOptions options;
    options.form = MouldForm::body;
    const auto began = std::chrono::steady_clock::now();
    const auto mould = mould_of(folded, options);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    ASSERT_TRUE(mould) << name << ": " << mould.error().message;
    EXPECT_LT(took.count(), 3.0) << name;
    expect_closed(*mould->body);
    const Mesh sheet = mesh_of(folded);
    for (const Vec3& p : mould->body->points)
      EXPECT_GT(distance_to(sheet, p), 0.5 * folded.thickness - 1e-6)
          << name << ' ' << p.transpose();
  }
}

}  // namespace
}  // namespace planish::test
