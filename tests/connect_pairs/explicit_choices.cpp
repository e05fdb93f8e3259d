#include "connect_pairs/explicit_choices.hpp"

#include <array>

namespace planish::pairs {
namespace {

// Any edge, any two neighbours.
std::vector<std::vector<int>> edges_of(const Plate& plate) {
  std::vector<std::vector<int>> choices;
  const int count = static_cast<int>(plate.outline.size());
  for (int e = 0; e < count; ++e)
    choices.push_back({e});
  for (int e = 0; e < count; ++e)
    choices.push_back({e, (e + 1) % count});
  return choices;
}

BendRequest asked(const PlateStructure& pair) {
  BendRequest request;
  request.between = {pair.plates[0].id, pair.plates[1].id};
  return request;
}

// What may be given of the surface between given edges.
std::vector<BendRequest> surfaces_of(const PlateStructure& pair, bool single) {
  std::vector<BendRequest> choices;
  for (const SurfaceChoice surface :
       {SurfaceChoice::cylinder, SurfaceChoice::cone, SurfaceChoice::general}) {
    if (surface == SurfaceChoice::general && !single) continue;
    choices.push_back(asked(pair));
    choices.back().surface = surface;
  }
  for (const double radius : {0.1, pair.thickness, 10.0, 100.0}) {
    choices.push_back(asked(pair));
    choices.back().inside_radius = radius;
  }
  return choices;
}

constexpr std::array kLaterals{LateralBoundary::straight, LateralBoundary::corner,
                               LateralBoundary::arc};

}  // namespace

bool any_choice(const PlateStructure& pair, const std::function<bool(const BendRequest&)>& tried) {
  for (const double trade_off : {0.0, 0.3, 3.0, 100.0}) {
    BendRequest request = asked(pair);
    request.trade_off = trade_off;
    if (tried(request)) return true;
  }
  for (const std::vector<int>& a : edges_of(pair.plates[0]))
    for (const std::vector<int>& b : edges_of(pair.plates[1]))
      for (BendRequest request : surfaces_of(pair, a.size() + b.size() == 2))
        for (const LateralBoundary lateral : kLaterals) {
          request.edges = {a, b};
          request.lateral = lateral;
          if (tried(request)) return true;
        }
  return false;
}

}  // namespace planish::pairs
