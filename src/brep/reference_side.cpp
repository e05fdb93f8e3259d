#include "reference_side.hpp"

#include <algorithm>

namespace planish::brep {
namespace {

/// Skin area as the neutral surface (K = ½) would measure it, so that the two skins compare.
double neutral_area(const SolidModel& model, const std::vector<Outline>& outlines,
                    const Skins& skins, Side side) {
  double sum = 0.0;
  for (int f = 0; f < std::ssize(model.faces); ++f) {
    if (skins.side[f] != side) continue;
    double share = 1.0;
    if (const auto* surface = std::get_if<Developable>(&model.faces[f].surface)) {
      double radius = outlines[f].u_scale;
      if (std::holds_alternative<Ruled>(*surface)) radius = 0.0;
      if (radius > 0) share = (radius - model.faces[f].sense * skins.thickness / 2) / radius;
    }
    sum += outlines[f].area * share;
  }
  return sum;
}

int outward_sharp_edges(const SolidModel& model, const Skins& skins, Side side) {
  return static_cast<int>(
      std::count_if(skins.sharp.begin(), skins.sharp.end(), [&](const SharpEdge& edge) {
        return !edge.concave && skins.side[model.edges[edge.edge].faces[0]] == side;
      }));
}

}  // namespace

Side reference_side(const SolidModel& model, const std::vector<Outline>& outlines,
                    const Skins& skins) {
  if (skins.islands_first != skins.islands_second)
    return skins.islands_first < skins.islands_second ? Side::first : Side::second;
  const int first = outward_sharp_edges(model, skins, Side::first);
  const int second = outward_sharp_edges(model, skins, Side::second);
  if (first != second) return first < second ? Side::first : Side::second;
  constexpr double kClearly = 1.0 + 1e-6;  // sampling of outlines must not decide
  return neutral_area(model, outlines, skins, Side::second) >
                 kClearly * neutral_area(model, outlines, skins, Side::first)
             ? Side::second
             : Side::first;
}

}  // namespace planish::brep
