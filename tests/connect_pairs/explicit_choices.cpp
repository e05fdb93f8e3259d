#include "connect_pairs/explicit_choices.hpp"

#include <array>
#include <optional>

namespace planish::pairs {
namespace {

using Edges = std::optional<std::vector<int>>;

std::vector<Edges> edges_of(const Plate& plate) {
  std::vector<Edges> choices{std::nullopt};
  const int count = static_cast<int>(plate.outline.size());
  for (int e = 0; e < count; ++e)
    choices.push_back(std::vector{e});
  for (int e = 0; e < count; ++e)
    choices.push_back(std::vector{e, (e + 1) % count});
  return choices;
}

// What may be given of the surface: nothing, its kind, or a radius.
std::vector<BendRequest> surfaces_of(const PlateStructure& pair) {
  std::vector<BendRequest> choices{{}};
  for (const SurfaceChoice surface :
       {SurfaceChoice::cylinder, SurfaceChoice::cone, SurfaceChoice::general}) {
    choices.emplace_back();
    choices.back().surface = surface;
  }
  for (const double radius : {0.1, 1.0, 3.0, 10.0, 30.0, 100.0}) {
    choices.emplace_back();
    choices.back().inside_radius = radius;
  }
  choices.emplace_back();
  choices.back().inside_radius = pair.thickness;
  return choices;
}

}  // namespace

bool any_choice(const PlateStructure& pair, const std::function<bool(const BendRequest&)>& tried) {
  const std::vector<BendRequest> surfaces = surfaces_of(pair);
  const auto every_shape = [&](const Edges& a, const Edges& b) {
    const bool free = !a && !b;
    for (BendRequest request : surfaces)
      for (const LateralBoundary lateral :
           {LateralBoundary::straight, LateralBoundary::corner, LateralBoundary::arc})
        for (const double trade_off : {0.0, 0.3, 1.0, 3.0, 100.0}) {
          if (!free && trade_off != 1.0) continue;
          request.between = {pair.plates[0].id, pair.plates[1].id};
          request.edges = {a, b};
          request.lateral = lateral;
          request.trade_off = trade_off;
          if (tried(request)) return true;
        }
    return false;
  };
  for (const Edges& a : edges_of(pair.plates[0]))
    for (const Edges& b : edges_of(pair.plates[1]))
      if (every_shape(a, b)) return true;
  return false;
}

}  // namespace planish::pairs
