#pragma once

#include "assembly.hpp"
#include "solid_models.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace planish::brep::test {

/// A model with all that recognition finds before it assembles the sheet.
struct Recognised {
  SolidModel model;
  std::vector<Outline> outlines;
  Skins skins;
  Rim rim;
  Groups groups;
  Skin skin;

  Recognition view() const { return {model, outlines, skins, rim, groups, skin, 1e-5}; }
};

/// Recognised at this thickness, the skin of face `reference` as the reference skin.
inline Recognised recognised(SolidModel model, double thickness, int reference) {
  Recognised result{std::move(model), {}, {}, {}, {}, Skin::none};
  result.outlines = outlines_of(result.model);
  result.skins = find_skins(result.model, result.outlines, thickness, 0.02).value();
  result.rim = find_rim(result.model, result.outlines, result.skins);
  result.skin = result.skins.skin_of[reference];
  result.groups = group_faces(result.model, result.outlines, result.skins, result.skin);
  return result;
}

/// The sheet of a body of 2 mm, seen on the face `reference`.
inline Sheet sheet_of(SolidModel model, int reference) {
  const Recognised seen = recognised(std::move(model), 2, reference);
  auto sheet = assemble_sheet(seen.view());
  EXPECT_TRUE(sheet) << sheet.error().message;
  return sheet.value_or(Sheet{});
}

}  // namespace planish::brep::test
