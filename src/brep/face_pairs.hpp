#pragma once

#include "outline.hpp"

namespace planish::brep {

/// Two faces opposite each other at the sheet's thickness; the measures are seen from `a`.
struct FacePair {
  int a = 0;
  int b = 0;
  Opposite opposite;
};

/// All pairs at one thickness, and their properties for each face.
struct FacePairs {
  std::vector<FacePair> rows;
  std::vector<std::vector<int>> partners;  ///< by face: faces opposite it
  std::vector<double> covered;             ///< by face: share of its area with a partner below
};

/// Pairs whose depths are within `slack` (mm) of the thickness everywhere.
FacePairs pair_faces(const SolidModel& model, const std::vector<Outline>& outlines,
                     double thickness, double slack);

}  // namespace planish::brep
