#include "random_transitions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

// Sizes given for either face, pieces and their seams, press lines.

namespace planish::test {
namespace {

TEST(TransitionSizes, AreThoseOfTheFaceTheyAreGivenFor) {
  const double r = 50, t = 4;
  for (const double k : {0.5, 0.4}) {
    TransitionSpec spec = between(EllipseProfile{r, r}, EllipseProfile{r, r}, {0, 0, 80});
    spec.thickness = t;
    spec.k_factor = k;
    for (const auto& [face, share] :
         {std::pair{SizesAre::inside, 0.0}, std::pair{SizesAre::mid, 0.5},
          std::pair{SizesAre::outside, 1.0}}) {
      spec.sizes_are = face;
      const double neutral = r + (k - share) * t;
      expect_sizes(spec, 2 * kPi * neutral * 80, 2 * kPi * neutral, 2 * kPi * neutral);
      EXPECT_NEAR(made(spec).pieces[0].bends.front().inside_radius, neutral - k * t, 1e-9);
    }
  }
}

TEST(TransitionSizes, OfParallelCurvesDifferByTheTurnTimesTheirDistance) {
  TransitionSpec spec = between(EllipseProfile{70, 40}, rectangle(100, 60), {0, 0, 80});
  spec.thickness = 2;
  spec.sizes_are = SizesAre::inside;
  const Transition transition = made(spec);
  EXPECT_NEAR(transition.perimeters[0], ellipse_perimeter(70, 40) + 2 * kPi, 1e-9 * 400);
  EXPECT_NEAR(transition.perimeters[1], 320 + 8, 1e-9 * 400);
}

TEST(TransitionPieces, AddUpAndFitAtTheirSeams) {
  for (unsigned seed = 0; seed < 25; ++seed) {
    std::mt19937 random(seed);
    TransitionSpec spec = random_transition(random);
    spec.from.profile = rectangle(90, 60);
    spec.from.frame = frame_at(Vec3::Zero());
    const auto from = sampled_in_space(spec.from, 1);
    if (std::ranges::any_of(from, [&](const Vec3& p) { return spec.to.frame.local(p).z() > -1.0; }))
      continue;
    const double whole = made(spec).area;
    for (const auto& [pieces, count] : {std::pair{Division::one, 1u}, std::pair{Division::two, 2u},
                                        std::pair{Division::per_side, 4u}}) {
      spec.pieces = pieces;
      const Transition transition = made(spec);
      ASSERT_EQ(transition.pieces.size(), count) << "seed " << seed;
      EXPECT_NEAR(transition.area / whole, 1.0, 1e-9) << "seed " << seed;
      EXPECT_NEAR(flat_area(transition, spec) / whole, 1.0, 1e-9) << "seed " << seed;
      std::vector<std::array<double, 2>> seams;  // lengths at the beginning and the end of pieces
      for (const Sheet& piece : transition.pieces) {
        const BorderLoop &first = piece.faces.front().loops.front(),
                         &last = piece.faces.back().loops.front();
        const bool whole_side = last.size() == 4 || *last[0].edge_length > 0.0;
        const auto index = whole_side && lies_on(piece.faces.back(), last[0], spec.from) ? 1u
                           : last.size() == 4                                            ? 1u
                                                                                         : 0u;
        seams.push_back({*first.back().edge_length, *last[index].edge_length});
      }
      for (std::size_t i = 0; i < seams.size(); ++i)
        EXPECT_NEAR(seams[i][1], seams[(i + 1) % seams.size()][0], 1e-9 * seams[i][1])
            << "seed " << seed;
    }
  }
}

TEST(TransitionPressing, TurnsEachPatchAsManyTimesAsTheAngleAsks) {
  TransitionSpec spec = between(rectangle(100, 100), EllipseProfile{30, 30}, {15, -10, 80});
  spec.seam = SeamEdge{0};
  spec.pressing = PressAngle{Angle::degrees(7.0)};
  const Transition transition = made(spec);
  std::size_t bend = 0;
  std::vector<double> turns;
  for (const TransitionPatch& patch : transition.patches)
    if (patch.kind != PatchKind::plane) turns.push_back(patch.turn.radians());
  double turned = 0.0, all = 0.0;
  for (const double turn : turns)
    all += turn;
  for (const Bend& b : transition.pieces[0].bends) {
    double sum = 0.0;
    for (const PressLine& line : b.press_lines)
      sum += line.angle.radians();
    // Of which patch: the one of the same turn.
    const bool known = std::ranges::any_of(
        turns, [&](double turn) { return std::abs(turn - sum) < 1e-11; });
    EXPECT_TRUE(known) << sum;
    EXPECT_EQ(b.press_lines.size(),
              static_cast<std::size_t>(std::ceil(sum / Angle::degrees(7.0).radians() - 1e-9)));
    turned += sum;
    ++bend;
  }
  EXPECT_EQ(bend, 4u);
  EXPECT_NEAR(turned, all, 1e-11);
}

TEST(TransitionPressing, ByChordPutsLinesAtEqualDistancesAlongTheWiderProfile) {
  TransitionSpec spec = between(EllipseProfile{90, 40}, EllipseProfile{30, 30}, {10, 0, 80});
  spec.pressing = PressChord{11.0};
  const Transition transition = made(spec);
  const Sheet& sheet = transition.pieces.at(0);
  ASSERT_EQ(sheet.bends.size(), 1u);
  const auto& lines = sheet.bends.front().press_lines;
  const double perimeter = ellipse_perimeter(90, 40);
  ASSERT_EQ(lines.size(), static_cast<std::size_t>(std::ceil(perimeter / 11.0)));
  // On the ellipse between the feet of neighbouring lines.
  const FlatPattern pattern = laid_flat(sheet, spec);
  ASSERT_EQ(pattern.bends.at(0).lines.size(), lines.size());
  std::vector<double> eccentric;
  for (const TrueLength& length : transition.true_lengths) {
    const Vec2 p = spec.from.frame.local2(length.points[0]);
    eccentric.push_back(std::atan2(p.y() / 40, p.x() / 90));
  }
  const auto arc = [](double a, double b) {
    const double turn = std::remainder(b - a, 2 * kPi);
    return std::abs(simpson([](double t) { return std::hypot(90 * std::sin(t), 40 * std::cos(t)); },
                            a, a + turn, 200));
  };
  for (std::size_t i = 2; i < eccentric.size(); ++i)  // the first is the seam
    EXPECT_NEAR(arc(eccentric[i - 1], eccentric[i]), perimeter / static_cast<double>(lines.size()),
                1e-5)
        << i;
  double turned = 0.0;
  for (const PressLine& line : lines)
    turned += line.angle.radians();
  EXPECT_NEAR(turned, transition.patches[0].turn.radians(), 1e-9);
}

TEST(TransitionMesh, IsARingWhoseFacetsLeaveTheSurfaceByTheirChord) {
  const TransitionSpec spec = between(rectangle(100, 100), EllipseProfile{30, 30}, {0, 0, 80});
  double missing = 0.0;
  for (const double chord : {0.2, 0.05}) {
    const auto transition = make_transition(spec, {.mesh_chord = chord});
    ASSERT_TRUE(transition);
    const Mesh& mesh = transition->mesh;
    double area = 0.0;
    std::map<std::pair<int, int>, int> edges;
    for (const auto& [a, b, c] : mesh.triangles) {
      const auto at = [&](int i) { return mesh.points[i]; };
      area += 0.5 * (at(b) - at(a)).cross(at(c) - at(a)).norm();
      for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}})
        ++edges[{from, to}];
    }
    // Chords of the circle miss the area in proportion to what they leave the arc by.
    if (missing > 0.0) {
      EXPECT_LT(transition->area - area, 0.4 * missing);
    }
    missing = transition->area - area;
    EXPECT_GT(missing, 0.0);
    EXPECT_LT(missing, chord * transition->perimeters[1]);
    // Each edge once each way, but for those of both openings.
    double openings = 0.0;
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      if (!edges.contains({edge.second, edge.first}))
        openings += (mesh.points[edge.second] - mesh.points[edge.first]).norm();
    }
    EXPECT_NEAR(openings, transition->perimeters[0] + transition->perimeters[1],
                0.1 * chord * transition->perimeters[1]);
  }
}

TEST(TransitionMesh, NeedsAChordAboveZero) {
  const auto refused = make_transition(
      between(rectangle(100, 100), EllipseProfile{30, 30}, {0, 0, 80}), {.mesh_chord = 0.0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, code::bad_option);
}

TEST(TransitionPressing, ByCountPutsThatManyLinesOnEachPatch) {
  TransitionSpec spec = between(rectangle(100, 100), EllipseProfile{30, 30}, {0, 0, 80});
  spec.pressing = PressCount{7};
  spec.seam = SeamEdge{0};
  const Transition transition = made(spec);
  for (const Bend& bend : transition.pieces.at(0).bends) {
    ASSERT_EQ(bend.press_lines.size(), 7u);
    for (const PressLine& line : bend.press_lines)
      EXPECT_NEAR(line.angle.radians(), bend.press_lines[0].angle.radians(), 1e-15);
  }
}

/// The normals between which a press line bends the sheet are those in the middle between it and
/// its neighbours.
TEST(TransitionPressing, AngleOfALineIsThatOfTheSurfaceAboutIt) {
  TransitionSpec spec = between(RoundedRectangleProfile{120, 80, 20}, EllipseProfile{30, 30},
                                {0, 0, 80});
  spec.pressing = PressAngle{Angle::degrees(6.0)};
  const Transition transition = made(spec);
  for (const Sheet& sheet : transition.pieces)
    for (const Bend& bend : sheet.bends) {
      const auto& surface = std::get<Developable>(sheet[bend.faces[0]].surface);
      for (std::size_t i = 1; i < bend.press_lines.size(); ++i) {
        const Vec3 a = normal_on(surface, bend.press_lines[i - 1].u),
                   b = normal_on(surface, bend.press_lines[i].u);
        // The surface turns about moving rulings, so its normals differ a little less than it
        // turns.
        const double between_lines = std::atan2(a.cross(b).norm(), a.dot(b)),
                     pressed = bend.press_lines[i].angle.radians();
        EXPECT_LE(between_lines, pressed * (1 + 1e-3));
        EXPECT_GE(between_lines, pressed * 0.9);
      }
    }
}

/// Labels name the ends of all true lengths, so that those can be found in the net.
TEST(TransitionLabels, StandInTheNetAsFarApartAsTheTrueLengthsSay) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    TransitionSpec spec = random_transition(random);
    spec.pressing = PressCount{3};
    spec.pieces = seed % 2 == 0 ? Division::one : Division::two;
    const Transition transition = made(spec);
    std::vector<FlatPattern> nets;
    for (const Sheet& piece : transition.pieces)
      nets.push_back(laid_flat(piece, spec));
    for (const TrueLength& length : transition.true_lengths) {
      bool found = false;
      for (const FlatPattern& net : nets)
        for (const FlatLabel& a : net.labels)
          for (const FlatLabel& b : net.labels)
            found = found || (a.text == length.from && b.text == length.to &&
                              std::abs((a.at - b.at).norm() - length.length) < 1e-7);
      EXPECT_TRUE(found) << "seed " << seed << ": " << length.from << " – " << length.to << ", "
                         << length.length;
    }
  }
}

TEST(TransitionLabels, AreLettersAtCornersAndNumbersOnCurves) {
  TransitionSpec spec = between(rectangle(100, 100), EllipseProfile{30, 30}, {0, 0, 80});
  spec.seam = SeamEdge{0};
  const FlatPattern net = laid_flat(made(spec).pieces.at(0), spec);
  std::vector<std::string> first;
  for (const FlatLabel& label : net.labels)
    if (label.text.back() != '\'') first.push_back(label.text);
  EXPECT_EQ(first, (std::vector<std::string>{"1", "B", "C", "D", "A", "1"}));
}

/// Where the sheet begins: on the first profile, and on a ruling.
Vec2 beginning(const TransitionSpec& spec) {
  const Sheet sheet = made(spec).pieces.at(0);
  const Border& ruling = sheet.faces.front().loops.front().back();
  Vec2 on_profile = Vec2::Constant(1e9);
  double nearest = 1e9;
  for (const double t : {0.0, 1.0}) {
    const Vec3 p = spec.from.frame.local(
        skin_point(sheet.faces.front(), point_at(ruling.curve, t)));
    if (std::abs(p.z()) >= nearest) continue;
    nearest = std::abs(p.z());
    on_profile = p.head<2>();
  }
  EXPECT_LT(nearest, 1e-9);
  return on_profile;
}

TEST(TransitionSeams, BeginWhereTheyAreWanted) {
  constexpr double kNear = 1e-8;
  const auto expect_at = [&](Profile profile, Seam seam, const Vec2& wanted, const char* what) {
    TransitionSpec spec = between(std::move(profile), EllipseProfile{25, 25}, {3, -2, 80});
    spec.seam = seam;
    EXPECT_LT((beginning(spec) - wanted).norm(), kNear) << what;
  };
  const PolygonProfile triangle{{{-60, -40}, {60, -40}, {0, 70}}};
  expect_at(triangle, SeamEdge{0}, {0, -40}, "middle of edge 0");
  expect_at(triangle, SeamEdge{1}, {30, 15}, "middle of edge 1");
  for (int i = 0; i < 3; ++i)
    expect_at(triangle, SeamCorner{i}, triangle.corners[i], "corner of a triangle");
  const PolygonProfile clockwise{{{-60, -40}, {0, 70}, {60, -40}}};
  expect_at(clockwise, SeamEdge{0}, {-30, 15}, "middle of edge 0, clockwise");
  expect_at(clockwise, SeamEdge{2}, {0, -40}, "middle of edge 2, clockwise");
  expect_at(clockwise, SeamCorner{1}, {0, 70}, "corner 1, clockwise");
  const RoundedRectangleProfile rounded{120, 80, 10};
  expect_at(rounded, SeamEdge{0}, {0, -40}, "below");
  expect_at(rounded, SeamEdge{1}, {60, 0}, "right");
  expect_at(rounded, SeamEdge{2}, {0, 40}, "above");
  expect_at(rounded, SeamEdge{3}, {-60, 0}, "left");
  const double straight = 100, side = 60, arc = 5 * kPi, around = 2 * (straight + side) + 4 * arc;
  expect_at(rounded, SeamParameter{straight / around}, {50, -40}, "end of edge 0");
  expect_at(rounded, SeamParameter{(straight + 0.5 * arc) / around},
            {50 + 10 * std::sqrt(0.5), -30 - 10 * std::sqrt(0.5)}, "middle of an arc");
  const ObroundProfile obround{140, 60};
  expect_at(obround, SeamEdge{0}, {0, -30}, "below");
  expect_at(obround, SeamEdge{1}, {0, 30}, "above");
  const double half = 30 * kPi;
  expect_at(obround, SeamParameter{(80 + 0.5 * half) / (160 + 2 * half)}, {70, 0}, "right end");
  expect_at(EllipseProfile{60, 60}, SeamParameter{0.0}, {60, 0}, "beginning of a circle");
  expect_at(EllipseProfile{60, 60}, SeamParameter{1.0}, {60, 0}, "end of a circle");
  expect_at(EllipseProfile{60, 60}, SeamParameter{1.0 / 3.0}, {-30, 30 * std::sqrt(3.0)},
            "third of a circle");
  expect_at(EllipseProfile{70, 40}, SeamParameter{0.25}, {0, 40}, "quarter of an ellipse");
  expect_at(triangle, SeamParameter{0.0}, {-60, -40}, "start of edge 0");
  const double slant = std::hypot(60.0, 110.0);
  expect_at(triangle, SeamParameter{(120 + 0.25 * slant) / (120 + 2 * slant)}, {45, -12.5},
            "on edge 1");
  // Points of a spline lie on it; the curve begins at the first.
  SplineProfile spline;
  for (int i = 0; i < 12; ++i)
    spline.points.emplace_back(60 * std::cos(kPi / 6 * i), 45 * std::sin(kPi / 6 * i));
  expect_at(spline, SeamParameter{0.0}, {60, 0}, "beginning of a spline");
  expect_at(spline, SeamParameter{0.5}, {-60, 0}, "half of a symmetric spline");
}

TEST(TransitionSeams, AreTheShortestRulingUnlessGiven) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    TransitionSpec spec = random_transition(random);
    spec.pressing = PressCount{40};
    const Transition transition = made(spec);
    const Border& seam = transition.pieces.at(0).faces.front().loops.front().back();
    const Vec2 a = start_of(seam.curve), b = end_of(seam.curve);
    const Face& face = transition.pieces[0].faces.front();
    const double length = (skin_point(face, a) - skin_point(face, b)).norm();
    for (const TrueLength& other : transition.true_lengths)
      EXPECT_LE(length, other.length * (1 + 1e-9)) << "seed " << seed;
  }
}

TEST(TransitionSeams, LeaveNoSliversOfPatches) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    TransitionSpec spec = random_transition(random);
    spec.pieces = Division::two;
    for (const Sheet& piece : made(spec).pieces)
      for (const Face& face : piece.faces) {
        double longest = 0.0;
        for (const Border& border : face.loops.front())
          if (lies_on(face, border, spec.from) || lies_on(face, border, spec.to))
            longest = std::max(longest, *border.edge_length);
        EXPECT_GT(longest, 1e-8) << "seed " << seed;
      }
  }
}

TEST(TransitionSeams, OnCornersWhereAPolygonGoesStraightOn) {
  // A rectangle with two more corners below, to another polygon and to a circle.
  const PolygonProfile cornered{
      {{-60, -40}, {-20, -40}, {30, -40}, {60, -40}, {60, 40}, {-60, 40}}};
  for (const Profile& other : {Profile(rectangle(50, 70)), Profile(EllipseProfile{25, 25})}) {
    TransitionSpec spec = between(cornered, other, {5, 3, 70}),
                   plain = between(rectangle(120, 80), other, {5, 3, 70});
    EXPECT_NEAR(made(spec).area / made(plain).area, 1.0, 1e-12);
    EXPECT_EQ(made(spec).patches.size(), made(plain).patches.size());
    const auto expect_at = [&](Seam seam, const Vec2& wanted) {
      for (const bool turned : {false, true}) {
        TransitionSpec here = spec;
        here.seam = seam;
        if (turned) here.to.frame = frame_at({5, 3, -70});
        EXPECT_LT((beginning(here) - wanted).norm(), 1e-8);
      }
    };
    expect_at(SeamEdge{0}, {-40, -40});
    expect_at(SeamEdge{1}, {5, -40});
    expect_at(SeamEdge{2}, {45, -40});
    expect_at(SeamEdge{3}, {60, 0});
    expect_at(SeamCorner{1}, {-20, -40});
    expect_at(SeamCorner{2}, {30, -40});
    expect_at(SeamCorner{3}, {60, -40});
    expect_at(SeamParameter{0.0}, {-60, -40});
  }
}

TEST(TransitionPressing, CountsTheLinesOfAPatchThatASeamDivides) {
  for (int count = 1; count < 9; ++count) {
    TransitionSpec spec = between(rectangle(100, 100), EllipseProfile{30, 30}, {0, 0, 80});
    spec.pressing = PressCount{count};
    spec.seam = SeamCorner{2};
    const Transition transition = made(spec);
    const auto& bends = transition.pieces.at(0).bends;
    ASSERT_EQ(bends.size(), 5u);
    EXPECT_EQ(bends.front().press_lines.size() + bends.back().press_lines.size(),
              static_cast<std::size_t>(std::max(count, 2)));
  }
}

TEST(TransitionBends, AreMeasuredBetweenTheirEndsTheLongWayRound) {
  // Half and three quarters of flat cones: their normals turn little on the way.
  TransitionSpec spec = between(EllipseProfile{100, 100}, EllipseProfile{50, 50}, {0, 0, 10});
  EXPECT_NEAR(made(spec).pieces.at(0).bends.front().angle.degrees(), 360.0, 1e-9);
  spec.pieces = Division::two;
  const double lean = std::atan2(50, 10);  // of the normals from the cone's plane
  EXPECT_NEAR(made(spec).pieces.at(0).bends.front().angle.radians(), 2 * (kPi / 2 - lean), 1e-9);
}

}  // namespace
}  // namespace planish::test
