#include "support/closed_mesh.hpp"
#include "support/sheets.hpp"

#include <planish/brep/step.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace planish::test {
namespace {

Mesh mesh_of(const Sheet& sheet, double chord = 0.05) {
  auto mesh = folded_mesh(sheet, chord);
  if (!mesh) ADD_FAILURE() << mesh.error().message;
  return mesh.value_or(Mesh{});
}

double area_of(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    sum += 0.5 * (mesh.points[t[1]] - mesh.points[t[0]])
                     .cross(mesh.points[t[2]] - mesh.points[t[0]])
                     .norm();
  return sum;
}

/// Closed, and its volume differs by no more than a layer as thick as the chord.
Mesh expect_sound_mesh(const Sheet& sheet, double chord = 0.05) {
  Mesh mesh = mesh_of(sheet, chord);
  expect_closed(mesh);
  EXPECT_NEAR(volume_in(mesh), *sheet.volume, chord * area_of(mesh));
  return mesh;
}

TEST(FoldedMesh, OfStripsIsClosedAndHasTheirVolume) {
  for (const Sheet& sheet : {l_bracket(), l_bracket_down(), u_channel(), z_profile(), staircase(4),
                             hem(), turn_of_250(), two_turns_of_270(), rolled()})
    expect_sound_mesh(sheet);
}

TEST(FoldedMesh, OfBoxesConesPlatesAndCreasesIsClosedAndHasTheirVolume) {
  for (BendDirection direction : {BendDirection::up, BendDirection::down}) {
    expect_sound_mesh(box({}, direction));
    ConeJoint joint;
    joint.turn.direction = direction;
    expect_sound_mesh(cone_joined(joint));
    expect_sound_mesh(
        strip({Straight{30}, Crease{Angle::degrees(70), direction}, Straight{20}}, 15, 1));
  }
  expect_sound_mesh(truncated_cone(20, 40, 50, Angle::degrees(300), 1.5));
  expect_sound_mesh(plate_with_holes());
  expect_sound_mesh(ring(30, 12, 2));
}

TEST(FoldedMesh, OfOpenedAndGeneralBendsIsClosedAndHasTheirVolume) {
  for (const Sheet& sheet : {slot_across_bend(), slot_into_bend(), hole_in_bend(5, 0.44),
                             hole_across_bend(20, 0.44), as_ruled(l_bracket(), Angle::degrees(2)),
                             as_ruled(cone_joined(), Angle::degrees(2)), lofted_corner()})
    expect_sound_mesh(sheet);
}

TEST(FoldedMesh, OfRandomSheetsIsClosedAtAnySize) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Sheet sheet = random_sheet(random, 1 + static_cast<int>(seed % 6));
    const double factor = seed % 2 == 0 ? 0.1 : 10.0;
    expect_sound_mesh(scaled(sheet, factor), 0.05 * factor);
  }
}

TEST(BodyMesh, OfWhatWasReadIsThatOfTheFoldedSolid) {
  const Sheet sheet = strip(
      {Straight{50}, Turn{Angle::degrees(90), 3.0, BendDirection::up}, Straight{30}}, 40.0, 2.0);
  const auto file = read_step_text(folded_solid_step(sheet, "strip").value(), "strip");
  ASSERT_TRUE(file.has_value());
  const Body& body = file->bodies.front();
  const auto surface = body_mesh(body, 0.01);
  ASSERT_TRUE(surface.has_value());
  expect_closed(surface->mesh);
  EXPECT_NEAR(volume_in(surface->mesh), body.volume(), 0.01 * area_of(surface->mesh));
  EXPECT_EQ(body_mesh(body, 0.0).error().code, code::bad_option);
}

TEST(FoldedMesh, OfPlanesIsExact) {
  const Sheet plain = strip(
      {Straight{30}, Crease{Angle::degrees(90), BendDirection::up}, Straight{20}}, 15, 1.5);
  const Mesh mesh = expect_sound_mesh(plain, 10.0);
  EXPECT_NEAR(volume_in(mesh), *plain.volume, 1e-9 * *plain.volume);
  EXPECT_EQ(mesh.points.size(), 12u) << "the corners of an L, extruded";
  EXPECT_EQ(mesh.triangles.size(), 20u) << "by Euler's formula";
}

/// How far the middles of the sides and of the triangles lie from the nearer skin of `rolled`,
/// and by how much a side that follows a skin turns.
struct Roundness {
  double deviation = 0.0, turn = 0.0;
};

Roundness roundness(const Mesh& mesh, const Sheet& sheet) {
  const auto& cylinder = std::get<Cylinder>(std::get<Developable>(sheet.faces.front().surface));
  const double outer = cylinder.radius + sheet.thickness;
  const auto radius = [&](const Vec3& p) { return cylinder.frame.local2(p).norm(); };
  const auto on = [&](double r, const Vec3& p) { return std::abs(radius(p) - r) < 1e-9; };
  Roundness result;
  const auto look = [&](const Vec3& p, double r) {
    result.deviation = std::max(result.deviation, std::abs(radius(p) - r));
  };
  for (const auto& t : mesh.triangles)
    for (double r : {cylinder.radius, outer}) {
      const Vec3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
      if (!on(r, a) || !on(r, b) || !on(r, c)) continue;
      look((a + b + c) / 3, r);
      for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        look(0.5 * (p + q), r);
        const Vec2 along = cylinder.frame.local2(p), next = cylinder.frame.local2(q);
        result.turn = std::max(result.turn, std::acos(std::min(1.0, along.dot(next) / (r * r))));
      }
    }
  return result;
}

TEST(FoldedMesh, LiesWithinTheChordOfTheSolid) {
  const Sheet sheet = rolled();
  for (double chord : {0.5, 0.05, 0.005}) {
    SCOPED_TRACE(chord);
    const Roundness found = roundness(expect_sound_mesh(sheet, chord), sheet);
    EXPECT_LE(found.deviation, chord);
    EXPECT_GT(found.deviation, 0.1 * std::min(chord, 0.08)) << "finer than anybody asked for";
  }
}

TEST(FoldedMesh, MakesSmallRadiiRound) {
  for (double factor : {0.05, 0.001}) {
    const Sheet sheet = scaled(rolled(), factor);
    const Roundness found = roundness(expect_sound_mesh(sheet, 0.5), sheet);
    EXPECT_LE(found.turn, Angle::degrees(10).radians() + 1e-6);
  }
}

TEST(FoldedMesh, IsTheSameEveryTime) {
  const Mesh a = mesh_of(box()), b = mesh_of(box());
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(FoldedMesh, RefusesWhatHasNoSolidAndChordsThatAreNone) {
  const auto code_of = [](const Sheet& sheet, double chord) {
    const auto mesh = folded_mesh(sheet, chord);
    return mesh ? "none" : std::string(code_name(mesh.error().code));
  };
  for (double chord : {0.0, -1.0, std::nan("")})
    EXPECT_EQ(code_of(l_bracket(), chord), "bad_option");
  Sheet flat = plate_with_holes();
  flat.thickness = 0.0;
  EXPECT_EQ(code_of(flat, 0.05), "invalid_input");
}

}  // namespace
}  // namespace planish::test
