#include "sharp_edges.hpp"

#include "dihedral.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

// Bends without radius. Where two faces of a skin meet at an angle, the sheet is folded if the
// faces opposite meet too, the other way round, or are rounded about the edge by a cylinder of the
// sheet's thickness. Walls of a cut meet both skins convexly, which is how they differ from a fold.
// Mitres grow with the angle, and so does the distance at which the other edge is looked for.

namespace planish::brep {
namespace {

bool rounds(const SolidFace& face, const Outline& outline, const SpaceCurve& edge, double thickness,
            double slack) {
  const auto* surface = std::get_if<Developable>(&face.surface);
  const auto* cylinder = surface ? std::get_if<Cylinder>(surface) : nullptr;
  if (!cylinder || face.sense < 0 || std::abs(cylinder->radius - thickness) > slack) return false;
  const auto off_axis = [&](const Vec3& p) { return cylinder->frame.local(p).head<2>().norm(); };
  if (edge.kind != SpaceCurve::Kind::line || off_axis(edge.start) > slack ||
      off_axis(edge.end) > slack)
    return false;
  const double h0 = cylinder->frame.local(edge.start).z();
  const double h1 = cylinder->frame.local(edge.end).z();
  return std::max(h0, h1) > outline.box.lo.y() && std::min(h0, h1) < outline.box.hi.y();
}

/// An edge at which a skin turns, by a signed angle.
struct Turn {
  int edge = 0;
  double angle = 0.0;
};

/// Edges by the two faces that they lie between, the smaller number first.
using TurnsByFaces = std::map<std::pair<int, int>, std::vector<Turn>>;

TurnsByFaces by_faces(const SolidModel& model, const std::vector<Turn>& turns) {
  TurnsByFaces rows;
  for (const Turn& turn : turns) {
    const auto& [f, g] = model.edges[turn.edge].faces;
    rows[std::minmax(f, g)].push_back(turn);
  }
  return rows;
}

std::vector<Turn> turns_between(const SolidModel& model, const std::vector<bool>& candidates) {
  std::vector<Turn> turns;
  for (int e = 0; e < std::ssize(model.edges); ++e) {
    const auto angle = dihedral(model, e);
    if (!angle) continue;
    const auto& [f, g] = model.edges[e].faces;
    if (candidates[f] && candidates[g] && !smooth_edge(model, e)) turns.push_back({e, *angle});
  }
  return turns;
}

/// Whether an edge lies where the other side of a fold would, seen from the first.
bool beside(const SpaceCurve& a, const SpaceCurve& b, double thickness) {
  // The mitre's length grows with the angle; it is 4 thicknesses at a bend of 150°.
  constexpr double kLongestMitre = 4.0;
  const Vec3 middle = (b.start + b.end) / 2;
  const Vec3 along = (a.end - a.start).normalized();
  const Vec3 d = middle - a.start;
  return (d - d.dot(along) * along).norm() < kLongestMitre * thickness;
}

/// Whether the partners of an edge's faces meet sharply too, the other way round: the other side of
/// its fold.
bool is_mirrored(const SolidModel& model, const std::vector<std::vector<int>>& partners,
                 const TurnsByFaces& turns, const Turn& turn, double thickness) {
  const SolidEdge& edge = model.edges[turn.edge];
  for (const int p : partners[edge.faces[0]])
    for (const int q : partners[edge.faces[1]]) {
      const auto between = turns.find(std::minmax(p, q));
      if (between == turns.end()) continue;
      for (const Turn& other : between->second)
        if (other.edge != turn.edge && other.angle * turn.angle < 0 &&
            beside(edge.curve, model.edges[other.edge].curve, thickness))
          return true;
    }
  return false;
}

}  // namespace

std::vector<RoundedOutside> rounded_outsides(const SolidModel& model,
                                             const std::vector<Outline>& outlines,
                                             const std::vector<bool>& candidates, double thickness,
                                             double slack) {
  std::vector<RoundedOutside> found;
  for (int e = 0; e < std::ssize(model.edges); ++e) {
    const auto angle = dihedral(model, e);
    if (!angle || *angle > -kSmoothAngle) continue;
    const auto& [f, g] = model.edges[e].faces;
    if (!candidates[f] || !candidates[g]) continue;
    for (int c = 0; c < std::ssize(model.faces); ++c)
      if (!candidates[c] &&
          rounds(model.faces[c], outlines[c], model.edges[e].curve, thickness, slack))
        found.push_back({e, c});
  }
  return found;
}

std::vector<SharpEdge> find_sharp_edges(const SolidModel& model,
                                        const std::vector<std::vector<int>>& partners,
                                        const std::vector<bool>& candidates,
                                        const std::vector<RoundedOutside>& rounded,
                                        double thickness) {
  const std::vector<Turn> turns = turns_between(model, candidates);
  const TurnsByFaces rows = by_faces(model, turns);
  std::set<int> rounded_edges;
  for (const RoundedOutside& outside : rounded)
    rounded_edges.insert(outside.edge);
  std::vector<SharpEdge> sharp;
  for (const Turn& turn : turns) {
    const bool is_rounded = rounded_edges.count(turn.edge) > 0;
    if (is_rounded || is_mirrored(model, partners, rows, turn, thickness))
      sharp.push_back({turn.edge, turn.angle < 0, is_rounded});
  }
  return sharp;
}

}  // namespace planish::brep
