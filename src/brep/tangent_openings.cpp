#include "tangent_openings.hpp"

#include "borders.hpp"
#include "form_volume.hpp"
#include "narrowest.hpp"
#include "passages.hpp"
#include "plane_opening.hpp"
#include "projection.hpp"
#include "skin_outlines.hpp"
#include "tangent_pieces.hpp"
#include "tangent_runs.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/interval.hpp>
#include <planish/geometry/quadrature.hpp>

#include <algorithm>
#include <cmath>

// Openings beside bends. Chamfers and countersinks round a hole of a flange may cross the tangent
// line, so that it has no outline of its own on that skin: the plane's outline runs along it, and
// so does the bend's. What passes through lies in the flange alone; there it is cut, and the
// tangent line goes on over what is machined. The volume between the skins is that of their faces
// carried on: columns over the plane, of a height that is known on a cylinder in closed form.

namespace planish::brep {
namespace {

/// The outline that crosses the tangent line.
const SkinOutline& crossing_outline(const TangentOpening& opening) {
  return opening.here.on_bend ? opening.here : opening.there;
}

/// How far a loop of the plane reaches over the tangent line; below 0 if it does not.
double reach_over(const BorderLoop& loop, const Frame& plane, const Frame& across) {
  Isometry2 turn = Isometry2::Identity();
  turn.linear() << across.x.dot(plane.x), across.x.dot(plane.y), across.y.dot(plane.x),
      across.y.dot(plane.y);
  const Box2 box = bounds(transformed(mapped(loop, &Border::curve), turn));
  return box.hi.x() - (turn * plane.local2(across.origin)).x();
}

/// The least of what may be cut; empty where nothing closed lies in the flange.
BorderLoop cut_of(const Recognition& of, const TangentOpening& opening) {
  const Frame across = across_tangent(of, opening.plane, crossing_outline(opening));
  const RimPart& part = of.rim.parts[opening.part];
  std::vector<BorderLoop> loops;
  if (auto section = narrowest_section(of, part, opening.plane)) loops.push_back(*section);
  if (auto core = round_core(of, part, opening.plane)) loops.push_back(*core);
  if (!opening.here.on_bend) loops.push_back(seen_here(of, opening));
  if (!opening.there.on_bend) loops.push_back(seen_there(of, opening));
  std::erase_if(loops, [&](const BorderLoop& loop) {
    return reach_over(loop, opening.plane, across) > of.tolerance;
  });
  if (loops.empty()) return {};
  return *std::ranges::min_element(loops, {}, loop_area);
}

/// How long an edge is once the bend lies flat. Of the ends of a wall that is drilled along the
/// normal of the flange the outermost is the least, and all that is cut passes through the others.
double length_when_flat(const Recognition& of, const SkinOutline& outline, const Frame& across,
                        const SpaceCurve& curve) {
  constexpr int kSteps = 128;
  const Vec3 axis = across.local(cylinder_of(of, outline.on_bend->loop.face)->frame.origin);
  const double middle = middle_radius(of, outline);
  const auto image = [&](int step) {
    const Vec3 p = across.local(
        curve.point(std::lerp(curve.t0, curve.t1, static_cast<double>(step) / kSteps)));
    const double height = std::copysign(1.0, -axis.z()) * (p.z() - axis.z());
    return Vec2(p.x() > 0.0 ? middle * std::atan2(p.x(), height) : p.x(), p.y());
  };
  double length = 0.0, farthest = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const Vec2 from = image(i), to = image(i + 1);
    length += (to - from).norm();
    farthest = std::max({farthest, from.x(), to.x()});
  }
  return farthest > 0.0 ? length : curve.length();
}

/// Of borders closed by a straight one.
double closed_area(const BorderLoop& borders) {
  const Segment closing{end_of(borders.back().curve), start_of(borders.front().curve)};
  return std::abs(signed_loop_area(borders) + green_area(closing));
}

/// How far what is cut ends within an outline at the tangent line: the nearer end, the other one.
Interval room_within(const Recognition& of, const TangentOpening& opening,
                     const SkinOutline& outline, const Frame& across) {
  const auto y_of = [&](const Vec2& p) {
    return (opening.plane.point(p) - across.origin).dot(across.y);
  };
  const auto uses = uses_of(of, outline.on_plane);
  const auto [low, high] = std::minmax({across.local(point_of(of, uses.front(), false)).y(),
                                        across.local(point_of(of, uses.back(), true)).y()});
  const auto [first, last] = std::minmax(
      {y_of(start_of(opening.cut.front().curve)), y_of(end_of(opening.cut.back().curve))});
  return {std::min(first - low, high - last), std::max(first - low, high - last)};
}

/// Sets what is cut to the narrowest section across the tangent line; returns whether there is one.
bool cut_across(const Recognition& of, TangentOpening& opening) {
  if (!opening.here.on_bend || !opening.there.on_bend) return false;
  const Frame across = across_tangent(of, opening.plane, opening.here);
  const auto chains = passages(of, of.rim.parts[opening.part], opening.plane, [&](int edge) {
    return length_when_flat(of, opening.here, across, of.model.edges[edge].curve);
  });
  if (chains.size() != 1) return false;
  opening.cut_seen = read_borders(of.model, chains.front(), opening.plane, 0.0, of.tolerance);
  const bool above = is_wider(seen_here(of, opening), opening.cut_seen);
  const bool below = is_wider(seen_there(of, opening), opening.cut_seen);
  const bool slanted = is_slanted(of, of.rim.parts[opening.part], opening.plane.z);
  // What is wider on one skin alone may be drilled at a slant.
  if (above != below && slanted) return false;
  TangentOpening drawn = opening;
  std::vector<CoEdge> outline = uses_of(of, opening.here.on_plane);
  std::ranges::copy(uses_of(of, *opening.here.on_bend), std::back_inserter(outline));
  if (!divide(of, drawn, across, outline) || !divide(of, opening, across, chains.front()))
    return false;
  if (!slanted) narrow_to_cell(of, opening, across);
  const double width = (cut_area(of, drawn) - cut_area(of, opening)) / perimeter(opening.cut_seen);
  if (width <= kSameOutline) {
    drawn.as_drawn = true;
    opening = std::move(drawn);
    return below;
  }
  const Interval here = room_within(of, opening, opening.here, across);
  opening.has_room = here.lo > kWiderOutline;
  const bool ends_alike = here.lo >= -of.tolerance && here.hi <= of.tolerance;
  return (opening.has_room || ends_alike) &&
         room_within(of, opening, opening.there, across).lo >= -of.tolerance;
}

/// ∫ f(x) dy along a run, as its face runs along it.
template <typename Function>
double along(const Recognition& of, const LoopRun& run, const Frame& across, const Function& f) {
  const double error = tolerance::kRounding * std::pow(of.model.size, 3);
  double sum = 0.0;
  for (const CoEdge& use : uses_of(of, run)) {
    const SpaceCurve& curve = of.model.edges[use.edge].curve;
    const auto form = [&](double t) {
      return f(across.local(curve.point(t)).x()) * curve.derivative(t).dot(across.y);
    };
    const double part = adaptive_gauss(form, curve.t0, curve.t1, error);
    sum += use.forward ? part : -part;
  }
  return sum;
}

/// The height of a cylinder along a tangent line over the plane, integrated from `from` to x.
class HeightIntegral {
 public:
  HeightIntegral(const Cylinder& cylinder, const Frame& across, const Vec3& tangent)
      : middle_(across.local(cylinder.frame.origin)),
        radius_(cylinder.radius),
        from_(across.local(tangent).x()),
        side_(across.local(tangent).z() > middle_.z() ? 1.0 : -1.0) {}

  double operator()(double x) const {
    return middle_.z() * (x - from_) + side_ * (circle(x) - circle(from_));
  }

 private:
  /// ∫ √(r² − s²) ds.
  double circle(double x) const {
    const double s = std::clamp(x - middle_.x(), -radius_, radius_);
    return (s * std::sqrt(radius_ * radius_ - s * s) + radius_ * radius_ * std::asin(s / radius_)) /
           2;
  }
  Vec3 middle_;
  double radius_, from_, side_;
};

/// The volume between the plane and the skin's faces carried on over an opening, above 0 where they
/// lie above it and look up, or below and down.
std::optional<double> volume_over_skin(const Recognition& of, const SkinOutline& outline,
                                       const Frame& plane, const Frame& across, Skin skin) {
  const double outwards = skin == of.skin ? 1.0 : -1.0;
  const Vec3 tangent = point_of(of, uses_of(of, outline.on_plane).front(), false);
  const double level = plane.local(tangent).z();
  if (!outline.on_bend) return outwards * level * loop_area(seen_outline(of, outline, plane, skin));
  const double start = across.local(tangent).x();
  // Seen from outside, each skin's faces lie on the left of its runs, and the opening on the right.
  double volume = -along(of, outline.on_plane, across,
                         [&](double x) { return level * (x - start); });
  const Cylinder& cylinder = *cylinder_of(of, outline.on_bend->loop.face);
  constexpr double kSteepest = 0.99;  // of the radius: beyond, a column meets the bend again
  const Box2 box = bounds(seen_outline(of, outline, across, skin));
  if (box.hi.x() > kSteepest * cylinder.radius) return {};
  volume -= along(of, *outline.on_bend, across, HeightIntegral(cylinder, across, tangent));
  return volume;
}

/// Whether all walls lead from skin to skin. Where such an opening ends at the tangent line, the
/// flange and the bend keep their own borders along it.
bool is_plain(const Recognition& of, const RimPart& part) {
  return std::ranges::all_of(part.faces, [&](int wall) {
    return reaches(of, wall, Skin::first) && reaches(of, wall, Skin::second);
  });
}

}  // namespace

double cut_area(const Recognition& of, const TangentOpening& opening) {
  if (opening.cut_of_bend.empty()) return loop_area(opening.cut);
  return closed_area(opening.cut) +
         middle_radius(of, opening.here) * closed_area(opening.cut_of_bend);
}

double depth_of(const Recognition& of, const TangentOpening& opening) {
  const LoopRef& there = opening.there.on_plane.loop;
  return -opening.plane.local(of.outlines[there.face].rings[there.loop].front()).z();
}

std::optional<double> volume_beyond_cut(const Recognition& of, const TangentOpening& opening) {
  const Frame across = across_tangent(of, opening.plane, crossing_outline(opening));
  const auto here = volume_over_skin(of, opening.here, opening.plane, across, of.skin);
  const auto there = volume_over_skin(of, opening.there, opening.plane, across,
                                      other_skin(of.skin));
  if (!here || !there) return {};
  const double walls = sum_of(of.rim.parts[opening.part].faces,
                              [&](int f) { return volume_over(of.model, f, opening.plane); });
  return cut_area(of, opening) * depth_of(of, opening) + walls - *here - *there;
}

std::vector<TangentOpening> tangent_openings(const Recognition& of) {
  std::vector<TangentOpening> found;
  for (int p = 0; p < std::ssize(of.rim.parts); ++p) {
    const RimPart& part = of.rim.parts[p];
    if (!part.within || part.openings != 1) continue;
    const auto here = outline_on(of, p, loops_here(of, part));
    const auto there = outline_on(of, p, loops_there(of, part));
    if (!here || !there || (!here->on_bend && !there->on_bend)) continue;
    const int face = here->on_plane.loop.face;
    if (std::ranges::count(of.skins.partners[face], there->on_plane.loop.face) == 0) continue;
    const int leader = of.groups.rows[of.groups.of_face[face]].leader;
    TangentOpening opening{p,  *here, *there, std::get<Frame>(of.model.faces[leader].surface),
                           {}, {},    {}};
    opening.cut = opening.cut_seen = cut_of(of, opening);
    if (!opening.cut.empty() && is_plain(of, part)) continue;
    if (!opening.cut.empty() || cut_across(of, opening)) found.push_back(std::move(opening));
  }
  return found;
}

}  // namespace planish::brep
