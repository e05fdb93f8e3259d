#include "body.hpp"
#include "guarded.hpp"
#include "step_out.hpp"

#include <planish/brep/codes.hpp>
#include <planish/brep/step.hpp>
#include <planish/sheet/codes.hpp>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <regex>
#include <set>

// Solids modelled with the kernel, as a CAD system would: what the recogniser must see in them, and
// what it must refuse.

namespace planish::test {
namespace {

using std::numbers::pi;

Result<StepFile> as_file(const TopoDS_Shape& shape) {
  auto text = brep::guarded([&] { return brep::step_text(shape, "part"); });
  if (!text) return tl::unexpected(text.error());
  return read_step_text(*text, "part.step");
}

struct Seen {
  Recognized recognized;
  FlatPattern flat;
  Certificate certificate;
};

Result<Seen> see(const TopoDS_Shape& shape) {
  const auto file = as_file(shape);
  if (!file) return tl::unexpected(file.error());
  auto recognized = recognize(file->bodies.front());
  if (!recognized) return tl::unexpected(recognized.error());
  auto flat = flatten(recognized->sheet);
  if (!flat) return tl::unexpected(flat.error());
  auto certificate = certify(recognized->sheet, *flat, recognized->distance);
  if (!certificate) return tl::unexpected(certificate.error());
  return Seen{std::move(*recognized), std::move(*flat), *certificate};
}

Error refusal_of(const TopoDS_Shape& shape) {
  const auto seen = see(shape);
  EXPECT_FALSE(seen.has_value()) << "this should have been refused";
  if (seen) return {code::internal, "", ""};
  EXPECT_FALSE(seen.error().message.empty());
  return seen.error();
}

TopoDS_Shape plate(double x, double y, double t) { return BRepPrimAPI_MakeBox(x, y, t).Shape(); }

TopoDS_Shape drilled(const TopoDS_Shape& shape, double x, double y, double radius) {
  const gp_Ax2 axis(gp_Pnt(x, y, -50), gp_Dir(0, 0, 1));
  return BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeCylinder(axis, radius, 100).Shape()).Shape();
}

TEST(RecognizePlate, HasItsSizeWhateverItsFilesUnit) {
  const auto seen = see(plate(100, 60, 2));
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_NEAR(seen->flat.area, 6000.0, 1e-6);
  EXPECT_NEAR(seen->recognized.sheet.thickness, 2.0, 1e-9);
}

TEST(RecognizePlate, IsTheSameInsideOut) {
  const auto seen = see(plate(100, 60, 2).Reversed());
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_NEAR(seen->flat.area, 6000.0, 1e-6);
  EXPECT_NEAR(*seen->certificate.volume_ratio, 1.0, 1e-9);
}

TEST(RecognizePlate, CutsACountersinkToItsBoreAndDrawsItsRim) {
  const gp_Ax2 axis(gp_Pnt(30, 30, 2), gp_Dir(0, 0, -1));
  TopoDS_Shape part = drilled(plate(100, 60, 2), 30, 30, 2.5);
  part = BRepAlgoAPI_Cut(part, BRepPrimAPI_MakeCone(axis, 4.0, 2.5, 1.5).Shape()).Shape();
  const auto seen = see(part);
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_NEAR(seen->flat.area, 6000 - pi * 2.5 * 2.5, 1e-6);
  ASSERT_EQ(seen->flat.features.size(), 1u);
  EXPECT_EQ(seen->flat.features.front().kind, "countersink");
  EXPECT_NEAR(std::abs(signed_area(seen->flat.features.front().outlines.front())), pi * 16, 1e-6);
  const double bore = pi * 2.5 * 2.5 * 2;
  const double cone = pi / 3 * 1.5 * (16 + 4 * 2.5 + 2.5 * 2.5) - pi * 2.5 * 2.5 * 1.5;
  EXPECT_NEAR(*seen->certificate.volume_ratio, (12000 - bore) / (12000 - bore - cone), 1e-9);
  EXPECT_NEAR(*seen->certificate.explained_ratio, 1.0, 1e-9);
}

TEST(RecognizePlate, DrawsBothOutlinesOfASlantedCut) {
  const gp_Ax2 slanted(gp_Pnt(50, 30, 1), gp_Dir(1, 0, 2));
  TopoDS_Shape tool = BRepPrimAPI_MakeCylinder(slanted, 4, 50).Shape();
  tool = BRepAlgoAPI_Fuse(
      tool, BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(50, 30, 1), gp_Dir(-1, 0, -2)), 4, 50).Shape());
  const auto seen = see(BRepAlgoAPI_Cut(plate(100, 60, 2), tool).Shape());
  ASSERT_TRUE(seen) << seen.error().message;
  ASSERT_EQ(seen->flat.features.size(), 1u);
  EXPECT_EQ(seen->flat.features.front().kind, "slanted cut");
  const Box2 near = bounds(seen->flat.openings.front().loop);
  const Box2 far = bounds(seen->flat.features.front().outlines.front());
  EXPECT_NEAR(((near.lo + near.hi) - (far.lo + far.hi)).norm() / 2, 1.0, 1e-4)
      << "2 mm deep at tan 1/2";
  EXPECT_NEAR(*seen->certificate.explained_ratio, 1.0, 1e-6);
}

/// All edges of the upper and lower skin broken.
template <typename Maker>
TopoDS_Shape broken_edges(const TopoDS_Shape& shape, double t, double size) {
  Maker maker(shape);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges(i));
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
    const gp_Pnt b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    const bool skin = std::abs(a.Z() - b.Z()) < 1e-9 &&
                      (std::abs(a.Z()) < 1e-9 || std::abs(a.Z() - t) < 1e-9);
    if (skin) maker.Add(size, edge);
  }
  return maker.Shape();
}

TEST(RecognizePlate, IsAsWideAsItsChamferedRimReaches) {
  const TopoDS_Shape part = broken_edges<BRepFilletAPI_MakeChamfer>(
      drilled(plate(100, 60, 3), 40, 30, 6), 3, 0.5);
  const auto seen = see(part);
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_NEAR(seen->flat.area, 6000 - pi * 36, 1e-6) << "bore and outer size before chamfering";
  EXPECT_FALSE(seen->flat.features.empty());
}

TEST(RecognizePlate, IsAsWideAsItsRoundedRimReaches) {
  const TopoDS_Shape part = broken_edges<BRepFilletAPI_MakeFillet>(plate(100, 60, 3), 3, 0.4);
  const auto seen = see(part);
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_NEAR(seen->flat.area, 6000.0, 1e-6);
}

TEST(RecognizePlate, FillsAPocketAndABossAndDrawsThem) {
  TopoDS_Shape part = BRepAlgoAPI_Cut(plate(100, 60, 3),
                                      BRepPrimAPI_MakeBox(gp_Pnt(10, 10, 2), 20, 10, 5).Shape())
                          .Shape();
  part = BRepAlgoAPI_Fuse(
             part,
             BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(70, 30, 3), gp_Dir(0, 0, 1)), 4, 6).Shape())
             .Shape();
  const auto seen = see(part);
  ASSERT_TRUE(seen) << seen.error().message;
  EXPECT_NEAR(seen->flat.area, 6000.0, 1e-6);
  EXPECT_TRUE(seen->flat.openings.empty());
  EXPECT_EQ(seen->flat.features.size(), 2u);
  EXPECT_NEAR(*seen->certificate.volume_ratio, 18000 / (18000 - 200 + pi * 16 * 6), 1e-9);
  EXPECT_NEAR(*seen->certificate.explained_ratio, 1.0, 1e-9);
}

/// A quarter ellipse extruded and thickened, as systems write it: extrusion and offset surfaces
/// that are no cylinders.
TopoDS_Shape elliptic_shell(double a, double b, double width, double t) {
  const gp_Elips ellipse(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), a, b);
  const TopoDS_Shape edge = BRepBuilderAPI_MakeEdge(ellipse, 0.0, pi / 2).Shape();
  const TopoDS_Shape face = BRepPrimAPI_MakePrism(edge, gp_Vec(0, 0, width)).Shape();
  BRepOffsetAPI_MakeThickSolid maker;
  maker.MakeThickSolidBySimple(face, t);
  return maker.Shape();
}

TEST(RecognizeGeneralBend, UnrollsAnEllipticShellToItsArcLength) {
  constexpr double a = 60, b = 35, width = 50, t = 1.5;
  const auto file = as_file(elliptic_shell(a, b, width, t));
  ASSERT_TRUE(file) << file.error().message;
  const auto recognized = recognize(file->bodies.front());
  ASSERT_TRUE(recognized) << recognized.error().message;
  ASSERT_EQ(recognized->sheet.bends.size(), 1u);
  EXPECT_EQ(recognized->sheet.bends.front().kind, BendKind::general);
  EXPECT_NEAR(recognized->sheet.bends.front().angle.degrees(), 90.0, 0.01);
  const auto flat = flatten(recognized->sheet, {.allowance = ConstantK{0.5, "test"}});
  ASSERT_TRUE(flat) << flat.error().message;
  // A parallel curve is longer by distance times turn; which side the shell grew to shows in the
  // volume.
  const double arc = a * std::comp_ellint_2(std::sqrt(1 - b * b / (a * a)));
  const double outside = width * (arc + t / 2 * pi / 2);
  const double inside = width * (arc - t / 2 * pi / 2);
  const double expected = std::abs(flat->area - outside) < std::abs(flat->area - inside) ? outside
                                                                                         : inside;
  EXPECT_NEAR(flat->area, expected, 1e-6 * expected);
  const auto certificate = certify(recognized->sheet, *flat, recognized->distance);
  ASSERT_TRUE(certificate);
  EXPECT_NEAR(*certificate->volume_ratio, 1.0, 1e-5);
  EXPECT_LT(*certificate->refold_deviation, 1e-3);
}

TEST(RecognizeRefusal, OfSolidBlocksAndBars) {
  EXPECT_EQ(refusal_of(BRepPrimAPI_MakeBox(40, 40, 40).Shape()).code, code::not_a_sheet);
  EXPECT_EQ(refusal_of(BRepPrimAPI_MakeBox(200, 10, 10).Shape()).code, code::not_a_sheet);
  EXPECT_EQ(refusal_of(BRepPrimAPI_MakeSphere(20).Shape()).code, code::not_a_sheet);
  EXPECT_EQ(refusal_of(BRepPrimAPI_MakeCone(20, 5, 30).Shape()).code, code::not_a_sheet);
}

TEST(RecognizeRefusal, OfPipesAsClosedLoops) {
  const TopoDS_Shape pipe = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(20, 100).Shape(),
                                            BRepPrimAPI_MakeCylinder(18, 100).Shape())
                                .Shape();
  const Error error = refusal_of(pipe);
  EXPECT_EQ(error.code, code::closed_loop);
}

TopoDS_Shape square_tube(double from, double to) {
  const TopoDS_Shape inside = BRepPrimAPI_MakeBox(gp_Pnt(2, 2, from - 1), 36, 36, to - from + 2);
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, from), 40, 40, to - from), inside);
}

/// As the kernel numbers edges and faces, which CAD systems show too.
void expect_rip_where_it_is_named(const TopoDS_Shape& shape) {
  const Error error = refusal_of(shape);
  ASSERT_EQ(error.code, code::closed_loop) << error.message;
  std::smatch named;
  ASSERT_TRUE(std::regex_match(error.where, named,
                               std::regex("edge (\\d+) between face (\\d+) and face (\\d+)")))
      << error.where;
  const auto file = as_file(shape);
  const TopoDS_Shape& solid = file->bodies.front().shape().solid;
  TopTools_IndexedMapOfShape faces;
  TopTools_IndexedDataMapOfShapeListOfShape edges;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, edges);
  std::set<int> beside;
  for (const TopoDS_Shape& face : edges(std::stoi(named[1])))
    beside.insert(faces.FindIndex(face));
  EXPECT_EQ(beside, (std::set<int>{std::stoi(named[2]), std::stoi(named[3])})) << error.where;
  ASSERT_FALSE(error.places.empty());
  EXPECT_EQ(error.places[0].id, Place::Id(std::stoi(named[1])));
  EXPECT_EQ(error.places[0].faces, (std::vector<int>{std::stoi(named[2]), std::stoi(named[3])}));
  // The place lies on the edge.
  ASSERT_EQ(error.places[0].at.size(), 3u);
  const std::vector<double>& at = error.places[0].at;
  const TopoDS_Vertex here = BRepBuilderAPI_MakeVertex(gp_Pnt(at[0], at[1], at[2]));
  EXPECT_LT(BRepExtrema_DistShapeShape(here, edges.FindKey(std::stoi(named[1]))).Value(), 1e-6);
}

TEST(RecognizeRefusal, OfSquareTubesWithTheRip) {
  expect_rip_where_it_is_named(square_tube(0, 200));
  // The halves' walls are faces of their own, which are read as one.
  expect_rip_where_it_is_named(BRepAlgoAPI_Fuse(square_tube(0, 80), square_tube(80, 200)).Shape());
}

TEST(RecognizeRefusal, OfDomesAsDoublyCurved) {
  const TopoDS_Shape half = BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(30).Shape(),
                                            BRepPrimAPI_MakeSphere(28).Shape())
                                .Shape();
  const TopoDS_Shape dome = BRepAlgoAPI_Cut(
                                half,
                                BRepPrimAPI_MakeBox(gp_Pnt(-50, -50, -50), 100, 100, 50).Shape())
                                .Shape();
  const Error error = refusal_of(dome);
  EXPECT_TRUE(error.code == code::doubly_curved || error.code == code::not_a_sheet)
      << error.message;
}

TEST(RecognizeRefusal, OfTeeJoints) {
  const TopoDS_Shape tee = BRepAlgoAPI_Fuse(
                               plate(100, 60, 2),
                               BRepPrimAPI_MakeBox(gp_Pnt(49, 0, 2), 2, 60, 40).Shape())
                               .Shape();
  const Error error = refusal_of(tee);
  EXPECT_EQ(exit_status(error.code), 4) << error.message;
}

TEST(RecognizeRefusal, OfWedgesWhoseThicknessVaries) {
  TopoDS_Shape wedge = BRepPrimAPI_MakeBox(100, 60, 6).Shape();
  const TopoDS_Shape half_space = BRepPrimAPI_MakeBox(
                                      gp_Ax2(gp_Pnt(-10, -10, 2), gp_Dir(-0.05, 0, 1)), 200, 200,
                                      50)
                                      .Shape();
  wedge = BRepAlgoAPI_Cut(wedge, half_space).Shape();
  EXPECT_EQ(exit_status(refusal_of(wedge).code), 4);
}

TEST(ReadStep, TellsSurfacesFromSolids) {
  const auto file = as_file(
      BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0, 10, 0, 10).Shape());
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, code::shell_not_solid);
}

TEST(ReadStep, NamesWhatIsWrongWithAFile) {
  EXPECT_EQ(read_step_text("", "a.step").error().code, code::empty_file);
  EXPECT_EQ(read_step_text("solid cube\nfacet", "a.stl").error().code, code::not_step);
  const auto text = brep::guarded([&] { return brep::step_text(plate(10, 10, 1), "part"); });
  ASSERT_TRUE(text);
  EXPECT_EQ(read_step_text(text->substr(0, text->size() / 2), "a.step").error().code,
            code::truncated_file);
  const auto data = text->find("DATA;") + 5;
  EXPECT_EQ(
      read_step_text(text->substr(0, data) + "ENDSEC;\nEND-ISO-10303-21;\n", "a.step").error().code,
      code::no_solid);
  EXPECT_EQ(read_step("/no/such/file.step").error().code, code::cannot_read);
}

TEST(ReadStep, ConvertsInchesToMillimetres) {
  auto text = brep::guarded([&] { return brep::step_text(plate(10, 5, 0.25), "part"); });
  ASSERT_TRUE(text);
  // The same numbers, stated to be inches.
  const std::string metric = "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )";
  const size_t at = text->find(metric);
  ASSERT_NE(at, std::string::npos);
  text->replace(at, metric.size(),
                "( CONVERSION_BASED_UNIT('INCH',#99001) LENGTH_UNIT() NAMED_UNIT(#99002) )");
  const size_t end = text->rfind("ENDSEC;");
  text->insert(end,
               "#99001=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#99003);\n#99002=DIMENSIONAL_"
               "EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
               "#99003=( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) );\n");
  const auto file = read_step_text(*text, "inch.step");
  ASSERT_TRUE(file) << file.error().message;
  const auto recognized = recognize(file->bodies.front());
  ASSERT_TRUE(recognized) << recognized.error().message;
  EXPECT_NEAR(recognized->sheet.thickness, 0.25 * 25.4, 1e-6);
}

TEST(RecognizeOptions, MustBeAboveZero) {
  const auto file = as_file(BRepPrimAPI_MakeBox(100, 50, 2).Shape());
  ASSERT_TRUE(file);
  for (const double wrong : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(recognize(file->bodies[0], {.surface_tolerance = wrong}).error().code,
              code::bad_option);
    EXPECT_EQ(recognize(file->bodies[0], {.thickness_tolerance = wrong}).error().code,
              code::bad_option);
  }
  EXPECT_DEATH(Body(nullptr), "shape_");
}

}  // namespace
}  // namespace planish::test
