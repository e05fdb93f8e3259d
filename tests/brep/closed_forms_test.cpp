#include "closed_forms.hpp"

#include "solid_models.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish::brep::test {
namespace {

using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

/// A plate with a square opening. Faces: 1 the top, 6 … 9 the opening's walls, which stand for the
/// faces of a form here.
SolidModel with_opening() {
  const auto outer = rectangle_at({0, 0}, {100, 60});
  const auto inner = clockwise(rectangle_at({40, 20}, {60, 40}));
  return plate(2, {{{outer, outer}, {0, 2}}, {{inner, inner}, {0, 2}}});
}

/// Nothing stands out of the sheet.
Rim no_rim(const SolidModel& model) { return {{}, std::vector<int>(model.faces.size(), -1)}; }

/// The top as a flange and a chain of bend, flange and bend behind one side of its opening.
Groups lance(const SolidModel& model) {
  Groups groups;
  groups.rows = {{{1}, true, 1}, {{6}, false, 6}, {{7}, true, 7}, {{8}, false, 8}};
  groups.of_face.assign(model.faces.size(), -1);
  for (int g = 0; g < 4; ++g)
    groups.of_face[groups.rows[g].faces.front()] = g;
  groups.joints = {{edge_between(model, 1, 6), 0, 1, false},
                   {edge_between(model, 6, 7), 1, 2, false},
                   {edge_between(model, 7, 8), 2, 3, false}};
  return groups;
}

TEST(ClosedForms, AreNotLancesThatEndFree) {
  const SolidModel model = with_opening();
  EXPECT_THAT(closed_forms(model, outlines_of(model), lance(model), no_rim(model)), IsEmpty());
}

TEST(ClosedForms, AreBridgesThatComeBackToTheirFlange) {
  const SolidModel model = with_opening();
  Groups groups = lance(model);
  groups.joints.push_back({edge_between(model, 8, 1), 3, 0, false});
  EXPECT_THAT(closed_forms(model, outlines_of(model), groups, no_rim(model)),
              UnorderedElementsAre(6, 7, 8));
}

TEST(ClosedForms, AreBeadsThatMeetTheirFlangeAlongTwoLines) {
  const SolidModel model = with_opening();
  Groups groups;
  groups.rows = {{{1}, true, 1}, {{6, 8}, false, 6}};
  groups.of_face.assign(model.faces.size(), -1);
  groups.of_face[1] = 0;
  groups.of_face[6] = groups.of_face[8] = 1;
  groups.joints = {{edge_between(model, 1, 6), 0, 1, true}};
  EXPECT_THAT(closed_forms(model, outlines_of(model), groups, no_rim(model)), IsEmpty());
  groups.joints.push_back(groups.joints.front());
  EXPECT_THAT(closed_forms(model, outlines_of(model), groups, no_rim(model)), IsEmpty())
      << "a fold that an opening parts, in one line";
  groups.joints.push_back({edge_between(model, 8, 1), 0, 1, true});
  EXPECT_THAT(closed_forms(model, outlines_of(model), groups, no_rim(model)),
              UnorderedElementsAre(6, 8));
}

TEST(ClosedForms, AreNoFoldsOneOfWhosePiecesIsTooShortToShowTheLine) {
  // Both pieces lie on one line to the 1e-5 mm of a file: 100 mm from the short one, whose
  // direction is off by 1e-5 / 0.2, that makes 5e-3 mm.
  SolidModel model = with_opening();
  Groups groups;
  groups.rows = {{{1}, true, 1}, {{6, 8}, false, 6}};
  groups.of_face.assign(model.faces.size(), -1);
  groups.of_face[1] = 0;
  groups.of_face[6] = groups.of_face[8] = 1;
  const int brief = edge_between(model, 1, 6), rest = edge_between(model, 8, 1);
  model.edges[brief].curve = line({0, 20, 2}, {0.2, 20 + 1e-5, 2});
  model.edges[rest].curve = line({20, 20, 2}, {100, 20, 2});
  for (const auto& [first, second] : {std::pair{brief, rest}, std::pair{rest, brief}}) {
    groups.joints = {{first, 0, 1, true}, {second, 0, 1, true}};
    EXPECT_THAT(closed_forms(model, outlines_of(model), groups, no_rim(model)), IsEmpty());
  }
  model.edges[rest].curve = line({20, 20.2, 2}, {100, 20.2, 2});
  EXPECT_THAT(closed_forms(model, outlines_of(model), groups, no_rim(model)),
              UnorderedElementsAre(6, 8))
      << "0.2 mm aside is another line, 80 mm long";
}

TEST(ClosedForms, AreClosedByADrawnFaceThatStandsOut) {
  // The last bend ends at face 9, which comes back to the flange: the round end of a bead.
  SolidModel model = with_opening();
  model.faces[9].surface = DoublyCurved{"sphere"};
  Rim rim = no_rim(model);
  rim.part_of[9] = 0;
  rim.parts.push_back({.faces = {9}, .first = {}, .second = {}, .within = true, .refusal = {}});
  EXPECT_THAT(closed_forms(model, outlines_of(model), lance(model), rim), IsEmpty())
      << "a fillet at a cut edge";
  rim.parts[0].within = false;
  EXPECT_THAT(closed_forms(model, outlines_of(model), lance(model), rim),
              UnorderedElementsAre(6, 7, 8));
}

TEST(ClosedForms, LieInsideAnOpeningAndNotAtTheOutline) {
  // The same ring at the outer contour is a loop of the part itself, for which there is a refusal.
  const SolidModel model = with_opening();
  Groups groups;
  groups.rows = {{{1}, true, 1}, {{2}, false, 2}, {{3}, true, 3}};
  groups.of_face.assign(model.faces.size(), -1);
  groups.joints = {{edge_between(model, 1, 2), 0, 1, false},
                   {edge_between(model, 2, 3), 1, 2, false},
                   {edge_between(model, 3, 1), 2, 0, false}};
  EXPECT_THAT(closed_forms(model, outlines_of(model), groups, no_rim(model)), IsEmpty());
}

}  // namespace
}  // namespace planish::brep::test
