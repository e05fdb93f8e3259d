#include "brake/stroke_room.hpp"
#include "cutting.hpp"

#include <planish/geometry/plane.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::test {
namespace {

using namespace brake_detail;

struct Cut {
  FlatSheet flat;
  Workpiece work;
};

Cut cut(const Sheet& sheet) {
  Cut made{*flat_sheet(sheet), {}};
  made.work = *workpiece_of(sheet, made.flat.layout);
  return made;
}

double area(const std::vector<Convex>& pieces) {
  double sum = 0.0;
  for (const Convex& piece : pieces)
    sum += ring_area(piece);
  return sum;
}

/// Bodies and zones together are the pattern: no material is lost, none is there twice.
TEST(CutMaterial, IsThePattern) {
  for (const Sheet& sheet : {l_bracket(), l_bracket_down(), u_channel(), z_profile(), staircase(2),
                             hem(), box(), box({}, BendDirection::down)}) {
    const Cut made = cut(sheet);
    double found = 0.0;
    for (const Body& body : made.work.bodies)
      found += area(body.pieces);
    for (std::size_t line = 0; line < made.work.zones.size(); ++line) {
      const BrakeLine& of = made.work.lines[line];
      // Each is as wide as the allowance, and as long as its line.
      EXPECT_NEAR(area(made.work.zones[line].pieces), of.bend.allowance * of.length(), 1e-6);
      for (const Convex& piece : made.work.zones[line].pieces)
        for (const Vec2& p : piece) {
          EXPECT_LE(std::abs(p.y()), 0.5 * of.bend.allowance + 1e-9);
          EXPECT_GE(p.x(), of.from() - 1e-6);
          EXPECT_LE(p.x(), of.to() + 1e-6);
        }
      found += area(made.work.zones[line].pieces);
    }
    EXPECT_NEAR(found, std::abs(signed_area(made.flat.pattern.outer.loop)), 1e-5);
  }
}

/// All straight free borders are edges of a body or a zone, with the material on their left.
TEST(CutMaterial, HasAllFreeBordersAsEdges) {
  for (const Sheet& sheet : {l_bracket(), l_bracket_down(), u_channel(), box()}) {
    const Cut made = cut(sheet);
    double edges = 0.0;
    const auto look = [&](const FreeEdge& edge, const std::vector<Vec2>& material) {
      edges += (edge.b - edge.a).norm();
      for (const Vec2& p : material)
        EXPECT_GE(cross((edge.b - edge.a).normalized(), p - edge.a), -1e-6);
    };
    for (const Body& body : made.work.bodies)
      for (const FreeEdge& edge : body.edges)
        look(edge, body.pieces.size() == 1 ? body.pieces.front() : Convex());
    for (std::size_t line = 0; line < made.work.zones.size(); ++line)
      for (const FreeEdge& edge : made.work.zones[line].edges)
        look(edge, {made.work.lines[line].origin +
                    0.5 * (made.work.lines[line].from() + made.work.lines[line].to()) *
                        made.work.lines[line].along});
    EXPECT_NEAR(edges, length(made.flat.pattern.outer.loop), 1e-6);
  }
}

/// Of a hole shaped like a D, a slot across a bend and a slot into it, and nothing else, whichever
/// side is up.
TEST(CutMaterial, KnowsTheEdgesOfOpenings) {
  SheetBuilder builder(2.0);
  const Loop shaped_like_d{Segment{{30, 20}, {30, 40}},
                           Arc{{30, 30}, 10.0, std::numbers::pi / 2, -std::numbers::pi}};
  const FaceId plate = builder.flange(Frame{}, {rectangle(80, 60), shaped_like_d});
  builder.flange_behind(
      builder.bend(builder.rim(plate, 0), {Angle::degrees(90), 2, BendDirection::up}),
      {rectangle(80, 30)});
  const double zone = std::numbers::pi / 2 * (4.0 + 0.44 * 2.0);
  const std::vector<std::pair<Sheet, double>> sheets{
      {builder.finish(), 20.0},
      {slot_across_bend(12.0), 2.0 * (12.0 + 8.0 + zone + 8.0)},
      {slot_into_bend(12.0), 2.0 * (12.0 + 8.0 + 0.5 * zone)},
      {plate_with_holes(), 2.0 * 12.0},
      {l_bracket(), 0.0}};
  for (const auto& [sheet, along] : sheets)
    for (const UpSide up : {UpSide::reference, UpSide::other}) {
      FlattenOptions options;
      options.up = up;
      const FlatSheet flat = *flat_sheet(sheet, options);
      double inside = 0.0, outside = 0.0;
      const auto add = [&](const std::vector<FreeEdge>& edges) {
        for (const FreeEdge& edge : edges)
          (edge.in_opening ? inside : outside) += (edge.b - edge.a).norm();
      };
      const auto work = workpiece_of(sheet, flat.layout);
      ASSERT_TRUE(work);
      for (const Body& body : work->bodies)
        add(body.edges);
      for (const Zone& at_line : work->zones)
        add(at_line.edges);
      EXPECT_NEAR(inside, along, 1e-6);
      EXPECT_NEAR(outside, length(flat.pattern.outer.loop), 1e-6);
    }
}

}  // namespace
}  // namespace planish::test
