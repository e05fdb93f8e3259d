#include "sharp_edges.hpp"

#include "dihedral.hpp"

#include <algorithm>
#include <cmath>

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

/// Whether two edges are the two sides of one fold.
bool opposite_edges(const SolidModel& model, const std::vector<std::vector<int>>& partners, int e,
                    int other, double thickness) {
  const auto partnered = [&](int a, int b) {
    return std::find(partners[a].begin(), partners[a].end(), b) != partners[a].end();
  };
  const auto& [f, g] = model.edges[e].faces;
  const auto& [p, q] = model.edges[other].faces;
  if (!(partnered(f, p) && partnered(g, q)) && !(partnered(f, q) && partnered(g, p))) return false;
  const SpaceCurve& a = model.edges[e].curve;
  const SpaceCurve& b = model.edges[other].curve;
  // The mitre's length grows with the angle; it is 4 thicknesses at a bend of 150°.
  constexpr double kLongestMitre = 4.0;
  const Vec3 middle = (b.start + b.end) / 2;
  const Vec3 along = (a.end - a.start).normalized();
  const Vec3 d = middle - a.start;
  return (d - d.dot(along) * along).norm() < kLongestMitre * thickness;
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
  std::vector<SharpEdge> sharp;
  for (const Turn& turn : turns) {
    const bool is_rounded = std::any_of(
        rounded.begin(), rounded.end(),
        [&](const RoundedOutside& outside) { return outside.edge == turn.edge; });
    const bool is_mirrored = std::any_of(turns.begin(), turns.end(), [&](const Turn& other) {
      return other.edge != turn.edge && other.angle * turn.angle < 0 &&
             opposite_edges(model, partners, turn.edge, other.edge, thickness);
    });
    if (is_rounded || is_mirrored) sharp.push_back({turn.edge, turn.angle < 0, is_rounded});
  }
  return sharp;
}

}  // namespace planish::brep
