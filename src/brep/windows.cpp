#include "windows.hpp"

#include "borders.hpp"
#include "skin_outlines.hpp"
#include "tangent_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// Windows that are cut through a flange, the bend and the flange behind it. Cut in one direction,
// their ends are slanted, and one skin's outline lies inside that of the other. What is cut is the
// inner one, on whichever skin. Walls that lean both ways have none; the pattern then keeps the
// reference skin's.

namespace planish::brep {
namespace {

/// Sine of the slope from which a wall is slanted: 3°, as slanted cuts are.
constexpr double kSlanted = 0.05;

bool is_bent(const Recognition& of, const LoopRef& ref) { return cylinder_of(of, ref.face); }

/// Whether a part leads from skin to skin through planes and cylinders, over whole bends.
bool is_window(const Recognition& of, int p) {
  const RimPart& part = of.rim.parts[p];
  const auto& here = loops_here(of, part);
  if (!part.within || part.openings != 1 ||
      std::ranges::none_of(here, [&](const LoopRef& ref) { return is_bent(of, ref); }))
    return false;
  if (std::ranges::count(of.tangent_openings, p, &TangentOpening::part) > 0 ||
      std::ranges::count(of.bend_openings, p, &BendOpening::part) > 0)
    return false;
  for (const auto* loops : {&here, &loops_there(of, part)})
    for (const LoopRef& ref : *loops)
      if (ref.loop != of.outlines[ref.face].outer ||
          (!is_bent(of, ref) && !std::holds_alternative<Frame>(of.model.faces[ref.face].surface)))
        return false;
  return std::ranges::all_of(part.faces, [&](int wall) {
    return reaches(of, wall, Skin::first) && reaches(of, wall, Skin::second);
  });
}

/// Whether walls along the reference skin lean inwards below it, some of them, and none outwards.
bool narrows_below(const Recognition& of, const std::vector<LoopRun>& runs) {
  double least = 0.0, most = 0.0;
  for (const LoopRun& run : runs)
    for (const CoEdge& use : uses_of(of, run)) {
      const SolidFace& wall = of.model.faces[face_across(of.model.edges[use.edge], run.loop.face)];
      if (std::holds_alternative<DoublyCurved>(wall.surface)) return false;
      const SpaceCurve& curve = of.model.edges[use.edge].curve;
      for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        const Vec3 p = curve.point(std::lerp(curve.t0, curve.t1, share));
        const double slope = outward_normal_at(wall, p).dot(
            outward_normal_at(of.model.faces[run.loop.face], p));
        least = std::min(least, slope);
        most = std::max(most, slope);
      }
    }
  return most > kSlanted && least > -kSlanted;
}

std::vector<CoEdge> reversed_uses(std::vector<CoEdge> uses) {
  std::ranges::reverse(uses);
  for (CoEdge& use : uses)
    use.forward = !use.forward;
  return uses;
}

/// The run across the sheet; empty if there is none, or several.
std::optional<LoopRun> run_across(const Recognition& of, int p, const LoopRun& here) {
  std::optional<LoopRun> across;
  for (const LoopRef& ref : loops_there(of, of.rim.parts[p])) {
    if (std::ranges::count(of.skins.partners[here.loop.face], ref.face) == 0) continue;
    if (across) return {};
    across = run_along(of, p, ref);
    if (!across) return {};
  }
  return across;
}

/// Empty where not all of a window can be cut along the other skin.
std::vector<FarRun> far_runs_of(const Recognition& of, int p) {
  std::vector<LoopRun> here;
  std::vector<FarRun> runs;
  for (const LoopRef& ref : loops_here(of, of.rim.parts[p])) {
    const auto run = run_along(of, p, ref);
    const auto across = run ? run_across(of, p, *run) : std::nullopt;
    if (!across) return {};
    here.push_back(*run);
    runs.push_back({*run, reversed_uses(uses_of(of, *across))});
  }
  return narrows_below(of, here) ? runs : std::vector<FarRun>{};
}

}  // namespace

const FarRun* far_run_at(const Recognition& of, const LoopRef& ref, int use) {
  const int count = static_cast<int>(loop_of(of, ref).size());
  for (const FarRun& run : of.far_runs)
    if (run.here.loop == ref && run.here.holds(use + count, count)) return &run;
  return nullptr;
}

int outermost(const Recognition& of) {
  const auto size = [&](const RimPart& part) {
    Box3 box;
    for (const int wall : part.faces)
      box.extend(of.outlines[wall].space);
    return box.diagonal().norm();
  };
  return static_cast<int>(std::ranges::max_element(of.rim.parts, {}, size) - of.rim.parts.begin());
}

std::vector<FarRun> far_runs(const Recognition& of) {
  std::vector<FarRun> runs;
  if (of.rim.parts.empty()) return runs;
  const int outer = outermost(of);
  for (int p = 0; p < std::ssize(of.rim.parts); ++p)
    if (p != outer && is_window(of, p))
      std::ranges::copy(far_runs_of(of, p), std::back_inserter(runs));
  return runs;
}

}  // namespace planish::brep
