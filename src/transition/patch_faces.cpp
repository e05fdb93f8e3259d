// A part of a patch as a face of the sheet: plane, right cone or cylinder where its sides are
// coaxial circles, else a general developable with rulings as knots. Borders are the profile's
// stretches and the end rulings, tips cut off along them; a side that stands still is a point.

#include "ruled_patch.hpp"

#include <planish/geometry/fit.hpp>

#include <algorithm>
#include <cmath>

namespace planish::transition_detail {
namespace {

Border border(const Curve2& curve, double length) {
  Border border;
  border.curve = curve;
  border.edge_length = length;
  return border;
}

}  // namespace

std::vector<RuledPatch::PanelCorner> RuledPatch::panel_corners(double from, double to,
                                                               const Tips& tips) const {
  const auto [p0, q0] = ruling(from);
  const auto [p1, q1] = ruling(to);
  struct Corner {
    Vec3 at;
    double cut = 0.0;
    bool edge_after = false;  ///< an edge of a profile follows
  };
  std::vector<Corner> corners{{p0, tips.at_from[0], !stands(0)}};
  if (!stands(0)) corners.push_back({p1, tips.at_to[0], false});
  if (!stands(1)) corners.push_back({q1, tips.at_to[1], true});
  corners.push_back({q0, tips.at_from[1], false});
  // Room is only needed beside folds; part of a profile's edge is enough.
  constexpr double kMostOfEdge = 0.4;
  const auto cut_on = [](const Corner& corner, const Vec3& towards, bool edge) -> Vec3 {
    const Vec3 way = towards - corner.at;
    const double cut = edge ? std::min(corner.cut, kMostOfEdge * way.norm()) : corner.cut;
    return corner.at + cut * way.normalized();
  };
  std::vector<PanelCorner> cut;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner &before = corners[(i + corners.size() - 1) % corners.size()], &here = corners[i],
                 &after = corners[(i + 1) % corners.size()];
    cut.push_back({here.at, cut_on(here, before.at, before.edge_after),
                   cut_on(here, after.at, here.edge_after)});
  }
  return cut;
}

RuledPatch::Part RuledPatch::part(double from, double to, const Tips& tips) const {
  if (hull_patch_.plane) return plane_part(from, to, tips);
  return right_ ? right_part(from, to, tips) : ruled_part(from, to, tips);
}

RuledPatch::Part RuledPatch::plane_part(double from, double to, const Tips& tips) const {
  const std::vector<PanelCorner> corners = panel_corners(from, to, tips);
  Part part;
  part.from = from;
  part.to = to;
  const Frame frame = frame_from_axes(corners[0].at, normal(from),
                                      (stands(0) ? corners.back() : corners[1]).at - corners[0].at);
  part.face.surface = frame;
  BorderLoop loop;
  const auto add = [&](const Vec3& a, const Vec3& b) {
    loop.push_back(border(Segment{frame.local2(a), frame.local2(b)}, (b - a).norm()));
  };
  const std::size_t over = stands(0) ? 0 : 1;  // the ruling at `to` begins here
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PanelCorner &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if (i == over) part.ruling_borders[1] = static_cast<int>(loop.size());
    if (i + 1 == corners.size()) part.ruling_borders[0] = static_cast<int>(loop.size());
    add(a.cut_after, b.cut_before);
    if (b.cut_before != b.cut_after) add(b.cut_before, b.cut_after);
  }
  part.face.loops.push_back(std::move(loop));
  return part;
}

RuledPatch::Part RuledPatch::right_part(double from, double to, const Tips& tips) const {
  Part part;
  part.from = from;
  part.to = to;
  part.u0 = std::lerp(right_->u0, right_->u1, from);
  part.u1 = std::lerp(right_->u0, right_->u1, to);
  part.face.surface = right_->surface;
  const double v0 = right_->v[0] + (stands(0) ? tips.at_from[0] : 0.0),
               v1 = right_->v[1] + (stands(1) ? tips.at_from[1] : 0.0);
  const Vec2 p0(part.u0, v0), p1(part.u1, v0), q0(part.u0, v1), q1(part.u1, v1);
  const double length = std::abs(v1 - v0);
  part.face.loops.push_back(
      {border(Segment{p0, p1}, border_length(0, from, to)), border(Segment{p1, q1}, length),
       border(Segment{q1, q0}, border_length(1, from, to)), border(Segment{q0, p0}, length)});
  part.ruling_borders = {3, 1};
  return part;
}

RuledPatch::Part RuledPatch::ruled_part(double from, double to, const Tips& tips) const {
  const double cut = (stands(0) ? tips.at_from[0] : 0.0) + (stands(1) ? tips.at_from[1] : 0.0);
  const double sign = base_ == 0 ? 1.0 : -1.0;
  const std::vector<double> breaks = breaks_between(from, to);
  Part part;
  part.from = part.u0 = from;
  part.to = part.u1 = to;
  part.face.surface = ruled_through(
      [&](double at) -> Ruling {
        const Local l = local(at);
        return {l.knot, sign * l.length};
      },
      breaks, tolerance_);
  const double speed = std::max(border_length(0, from, to), border_length(1, from, to)) /
                       (to - from);
  const CubicSpline far = fit_cubics_on_surface(
      [&](double at) -> CurveSample {
        const Local l = local(at);
        return {{at, sign * (l.length - cut)}, {1.0, sign * l.length_rate}};
      },
      from, to, speed, tolerance_);
  const Curve2 near = Segment{{from, 0.0}, {to, 0.0}};
  const auto length = [&](double at) { return local(at).length - cut; };
  const Curve2 bottom = base_ == 0 ? near : Curve2(far);
  const Curve2 top = reversed(base_ == 0 ? Curve2(far) : near);
  const Vec2 p0 = start_of(bottom), p1 = end_of(bottom), q1 = start_of(top), q0 = end_of(top);
  part.face.loops.push_back(
      {border(bottom, border_length(0, from, to)), border(Segment{p1, q1}, length(to)),
       border(top, border_length(1, from, to)), border(Segment{q0, p0}, length(from))});
  part.ruling_borders = {3, 1};
  return part;
}

}  // namespace planish::transition_detail
