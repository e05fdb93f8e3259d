#include "support/folded_box.hpp"
#include "support/sheets.hpp"

#include <planish/brep/step.hpp>
#include <planish/job/unfold.hpp>
#include <planish/sheet/codes.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace planish::job {
namespace {

Body body_of(const Sheet& sheet) {
  auto body = folded_body(sheet, "part");
  if (!body) throw std::runtime_error(body.error().message);
  return *body;
}

UnfoldReport unfolded(const Sheet& sheet, const Request& request = {}) {
  const auto report = unfold_body(body_of(sheet), request);
  EXPECT_TRUE(report) << (report ? "" : report.error().message);
  return report ? *report : UnfoldReport{};
}

TEST(UnfoldBody, LaysAnAngleFlat) {
  Request request;
  request.allowance = ConstantK{0.4, "ours"};
  request.density = 7.85;
  const UnfoldReport report = unfolded(test::l_bracket(), request);
  // 50 | 90° r 3 | 30, width 40, t 2
  const double bend = std::numbers::pi / 2 * (3.0 + 0.4 * 2.0);
  EXPECT_NEAR(report.flat.area, 40.0 * (80.0 + bend), 1e-3);
  EXPECT_NEAR(report.size.x(), 80.0 + bend, 1e-3);
  EXPECT_NEAR(report.size.y(), 40.0, 1e-3);
  EXPECT_EQ(report.summary.flanges, 2);
  EXPECT_EQ(report.summary.bends, 1);
  EXPECT_EQ(report.summary.k_factor, 0.4);
  EXPECT_EQ(report.summary.k_source, "ours");
  const double volume = 80.0 * (80.0 + std::numbers::pi / 2 * 4.0);
  EXPECT_NEAR(report.summary.volume, volume, 1e-3);
  EXPECT_NEAR(*report.mass, 7.85e-6 * volume, 1e-8);
  EXPECT_NEAR(*report.certificate.volume_ratio, 1.0, 1e-6);
  EXPECT_EQ(report.status(), Status::ok);
  EXPECT_GT(report.unfold_seconds, 0.0);
}

TEST(UnfoldBody, KeepsTheNameAndTheColourOfTheSolid) {
  std::string text = folded_solid_step(test::l_bracket(), "bracket").value();
  const std::size_t kind = text.find("MANIFOLD_SOLID_BREP("), number = text.rfind('#', kind);
  const std::string solid = text.substr(number, text.find_first_of(" =", number) - number);
  text.insert(text.rfind("ENDSEC;"), R"(#9201=COLOUR_RGB('',1.,0.,0.);
#9202=FILL_AREA_STYLE_COLOUR('',#9201);
#9203=FILL_AREA_STYLE('',(#9202));
#9204=SURFACE_STYLE_FILL_AREA(#9203);
#9205=SURFACE_SIDE_STYLE('',(#9204));
#9206=SURFACE_STYLE_USAGE(.BOTH.,#9205);
#9207=PRESENTATION_STYLE_ASSIGNMENT((#9206));
#9208=STYLED_ITEM('color',(#9207),)" + solid +
                                         R"();
#9209=REPRESENTATION_CONTEXT('','');
#9210=MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(#9208),#9209);
)");
  const auto file = read_step_text(text, "bracket.step");
  ASSERT_TRUE(file) << file.error().message;
  const auto report = unfold_body(file->bodies.front(), {});
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->body, "bracket");
  EXPECT_EQ(report->colour, "#ff0000");
}

TEST(UnfoldBody, TakesKOfSingleBends) {
  Request request;
  request.bend_k = {{"B1", 0.3}};
  UnfoldReport report = unfolded(test::u_channel(), request);
  EXPECT_FALSE(report.summary.k_factor) << "they differ";
  EXPECT_EQ(report.summary.k_source, "mixed");
  request.bend_k = {{"B7", 0.3}};
  const auto wrong = unfold_body(body_of(test::u_channel()), request);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().where, "bend_k/B7");
}

TEST(UnfoldBody, RefusesWhatIsNoSheetAndKeepsItsName) {
  const auto step = mesh_solid_step(
      [] {
        Mesh cube;
        for (int i = 0; i < 8; ++i)
          cube.points.emplace_back(50.0 * (i & 1), 50.0 * (i >> 1 & 1), 50.0 * (i >> 2));
        cube.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                          {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
        return cube;
      }(),
      "cube");
  ASSERT_TRUE(step) << step.error().message;
  const auto file = read_step_text(*step, "cube.step");
  ASSERT_TRUE(file);
  const auto report = unfold_body(file->bodies.front(), {});
  ASSERT_FALSE(report);
  EXPECT_NE(report.error().where, "rip_edges") << "which nobody asked for";
  ASSERT_TRUE(report.error().shown);
  EXPECT_EQ(report.error().shown->body, "cube");
  EXPECT_EQ(report.error().shown->status(), Status::refused);
  EXPECT_TRUE(report.error().shown->flat.outer.loop.empty());
}

TEST(UnfoldBody, CutsOpenWhatIsClosed) {
  const test::FoldedBox box = test::folded_box({.length = 80, .width = 50, .height = 25});
  Request request;
  request.effort = Effort::draft;
  const auto closed = unfold_body(body_of(box.sheet), request);
  ASSERT_FALSE(closed);
  EXPECT_TRUE(closed.error().shown);
  EXPECT_EQ(closed.error().code, code::closed_loop);
  ASSERT_FALSE(closed.error().remedies.empty());
  EXPECT_EQ(closed.error().remedies[0].option, "rip_edges");
  // The remedy is one: with it the part lies flat.
  const std::string& rips = closed.error().remedies[0].value;
  for (std::size_t at = 0; at < rips.size(); at = rips.find(',', at) + 1) {
    request.rip_edges.push_back(std::stoi(rips.substr(at)));
    if (rips.find(',', at) == std::string::npos) break;
  }
  const UnfoldReport open = unfolded(box.sheet, request);
  ASSERT_FALSE(open.notes.empty());
  for (const int edge : request.rip_edges)
    EXPECT_NE(open.notes.back().find(std::to_string(edge)), std::string::npos);
  request.rip_edges = {9999};
  const auto absent = unfold_body(body_of(box.sheet), request);
  ASSERT_FALSE(absent);
  EXPECT_FALSE(absent.error().shown) << "the request is wrong, not the body";
  EXPECT_EQ(absent.error().where, "rip_edges");
}

TEST(UnfoldBody, AddsToTheRipsThatWereAskedFor) {
  const test::FoldedBox box = test::folded_box({.length = 80, .width = 50, .height = 25});
  Request request;
  request.effort = Effort::draft;
  const auto closed = unfold_body(body_of(box.sheet), request);
  ASSERT_FALSE(closed);
  ASSERT_FALSE(closed.error().remedies.empty());
  const std::string all = closed.error().remedies[0].value;
  ASSERT_NE(all.find(','), std::string::npos) << "several edges";
  request.rip_edges = {std::stoi(all)};
  const auto half = unfold_body(body_of(box.sheet), request);
  ASSERT_FALSE(half);
  ASSERT_FALSE(half.error().remedies.empty());
  const std::string& more = half.error().remedies[0].value;
  EXPECT_EQ(more.rfind(std::to_string(request.rip_edges[0]) + ",", 0), 0u) << more;
}

TEST(UnfoldBody, TakesTheMaterialOfTheShop) {
  using namespace shop;
  Request request;
  request.effort = Effort::draft;
  request.shop = ShopChoice{};
  request.shop->shop.materials = {
      {.name = "a", .density = 1.0, .tensile_strength = {}, .gauges = {}},
      {.name = "b", .density = 2.0, .tensile_strength = {}, .gauges = {}}};
  const auto unsaid = unfold_body(body_of(test::l_bracket()), request);
  ASSERT_FALSE(unsaid);
  EXPECT_EQ(unsaid.error().where, "material");
  request.shop->material = 1;
  EXPECT_TRUE(unfold_body(body_of(test::l_bracket()), request));
}

}  // namespace
}  // namespace planish::job
