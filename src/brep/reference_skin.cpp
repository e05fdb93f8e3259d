#include "reference_skin.hpp"

#include <algorithm>

namespace planish::brep {
namespace {

/// Skin area as the neutral surface (K = ½) would measure it, so that the two skins compare.
double neutral_area(const SolidModel& model, const std::vector<Outline>& outlines,
                    const Skins& skins, Skin skin) {
  double sum = 0.0;
  for (int f = 0; f < std::ssize(model.faces); ++f) {
    if (skins.skin_of[f] != skin) continue;
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

int outward_sharp_edges(const SolidModel& model, const Skins& skins, Skin skin) {
  return static_cast<int>(std::ranges::count_if(skins.sharp, [&](const SharpEdge& edge) {
    return !edge.concave && skins.skin_of[model.edges[edge.edge].faces[0]] == skin;
  }));
}

}  // namespace

Skin reference_skin(const SolidModel& model, const std::vector<Outline>& outlines,
                    const Skins& skins) {
  if (skins.islands_first != skins.islands_second)
    return skins.islands_first < skins.islands_second ? Skin::first : Skin::second;
  const int first = outward_sharp_edges(model, skins, Skin::first);
  const int second = outward_sharp_edges(model, skins, Skin::second);
  if (first != second) return first < second ? Skin::first : Skin::second;
  constexpr double kClearly = 1.0 + 1e-6;  // so that the sampling of outlines does not decide
  return neutral_area(model, outlines, skins, Skin::second) >
                 kClearly * neutral_area(model, outlines, skins, Skin::first)
             ? Skin::second
             : Skin::first;
}

}  // namespace planish::brep
