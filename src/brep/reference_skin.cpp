#include "reference_skin.hpp"

#include "divided_skin.hpp"

#include <planish/geometry/region.hpp>

#include <algorithm>
#include <optional>

namespace planish::brep {
namespace {

/// Area of the plane faces of a skin with all in them filled: holes, and pockets, which lie on one
/// skin alone and say nothing about which is wider.
double filled_area(const SolidModel& model, const std::vector<Outline>& outlines,
                   const Skins& skins, Skin skin) {
  double sum = 0.0;
  for (int f = 0; f < std::ssize(model.faces); ++f)
    if (skins.skin_of[f] == skin && std::holds_alternative<Frame>(model.faces[f].surface))
      sum += std::abs(ring_area(outlines[f].flat[outlines[f].outer]));
  return sum;
}

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
  const int pieces_first = divided_pieces(model, outlines, skins, Skin::first);
  const int pieces_second = divided_pieces(model, outlines, skins, Skin::second);
  if (pieces_first != pieces_second)
    return pieces_first < pieces_second ? Skin::first : Skin::second;
  const int first = outward_sharp_edges(model, skins, Skin::first);
  const int second = outward_sharp_edges(model, skins, Skin::second);
  if (first != second) return first < second ? Skin::first : Skin::second;
  constexpr double kClearly = 1.0 + 1e-6;  // so that the sampling of outlines does not decide
  constexpr double kWider = 1.0 + 1e-4;    // nor do rounded tangent lines: bends are left out
  const auto wider = [&](const auto& area, double clearly) -> std::optional<Skin> {
    const double of_first = area(model, outlines, skins, Skin::first);
    const double of_second = area(model, outlines, skins, Skin::second);
    if (of_second > clearly * of_first) return Skin::second;
    if (of_first > clearly * of_second) return Skin::first;
    return std::nullopt;
  };
  if (const auto skin = wider(filled_area, kWider)) return *skin;
  return wider(neutral_area, kClearly).value_or(Skin::first);
}

}  // namespace planish::brep
