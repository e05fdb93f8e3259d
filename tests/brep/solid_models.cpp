#include "solid_models.hpp"

#include "face_volume.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace planish::brep::test {
namespace {

using std::numbers::pi;
constexpr double kTogether = 1e-9;  // mm

Vec3 middle_of(const SpaceCurve& curve) { return curve.point((curve.t0 + curve.t1) / 2); }

bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() < kTogether; }

SpaceCurve backwards(const SpaceCurve& curve) {
  if (curve.kind == SpaceCurve::Kind::line) return line(curve.end, curve.start);
  return arc(curve.circle, curve.radius, curve.t1, curve.t0);
}

Path backwards(const Path& path) {
  Path result;
  for (auto curve = path.rbegin(); curve != path.rend(); ++curve)
    result.push_back(backwards(*curve));
  return result;
}

/// A curve of the frame's xy plane at a height.
SpaceCurve in_space(const Curve2& curve, const Frame& frame, double height) {
  Frame lifted = frame;
  lifted.origin += height * frame.z;
  if (const auto* segment = std::get_if<Segment>(&curve))
    return line(lifted.point(segment->a), lifted.point(segment->b));
  const Arc& circle = std::get<Arc>(curve);
  lifted.origin = lifted.point(circle.center);
  return arc(lifted, circle.radius, circle.start, circle.start + circle.sweep);
}

void add_wall(SolidMaker& maker, const Curve2& curve, const Frame& frame, double height) {
  const SpaceCurve low = in_space(curve, frame, 0.0);
  const SpaceCurve high = in_space(curve, frame, height);
  const Path loop{low, line(low.end, high.end), backwards(high), line(high.start, low.start)};
  if (const auto* circle = std::get_if<Arc>(&curve)) {
    Frame axis = frame;
    axis.origin = frame.point(circle->center);
    maker.curved(Cylinder{axis, circle->radius}, circle->sweep > 0 ? 1 : -1, {loop});
  } else {
    maker.plane((low.end - low.start).cross(frame.z).normalized(), {loop});
  }
}

Frame at(const Vec2& centre, double height) {
  Frame frame;
  frame.origin = {centre.x(), centre.y(), height};
  return frame;
}

SpaceCurve circle_at(const Vec2& centre, const Vec2& point) {
  return arc(at(centre, point.y()), point.x(), 0.0, 2 * pi);
}

/// The surface between two points of a turned profile.
void add_turned(SolidMaker& maker, const Vec2& centre, const Vec2& a, const Vec2& b) {
  const Vec2 along = (b - a).normalized();
  const Vec2 outward(along.y(), -along.x());
  if (along.y() == 0.0) {
    std::vector<Path> loops;
    if (a.x() > 0) loops.push_back({circle_at(centre, a)});
    if (b.x() > 0) loops.push_back({backwards(circle_at(centre, b))});
    maker.plane(outward.y() * Vec3::UnitZ(), loops);
    return;
  }
  const SpaceCurve first = circle_at(centre, a);
  const SpaceCurve second = circle_at(centre, b);
  const Path loop{first, line(first.start, second.start), backwards(second),
                  line(second.start, first.start)};
  const int sense = outward.x() > 0 ? 1 : -1;
  if (along.x() == 0.0) {
    maker.curved(Cylinder{at(centre, 0.0), a.x()}, sense, {loop});
    return;
  }
  const double growth = (b.x() - a.x()) / (b.y() - a.y());
  Frame apex = at(centre, a.y() - a.x() / growth);
  if (growth < 0) apex = {apex.origin, apex.x, -apex.y, -apex.z};
  maker.curved(Cone{apex, std::atan(std::abs(growth))}, sense, {loop});
}

std::vector<Vec3> lifted(const std::vector<Vec2>& polygon, double height) {
  std::vector<Vec3> points;
  for (const Vec2& p : polygon)
    points.emplace_back(p.x(), p.y(), height);
  return points;
}

void add_walls(SolidMaker& maker, const Lofted& contour) {
  for (size_t k = 0; k + 1 < contour.sections.size(); ++k) {
    const auto low = lifted(contour.sections[k], contour.heights[k]);
    const auto high = lifted(contour.sections[k + 1], contour.heights[k + 1]);
    for (size_t i = 0; i < low.size(); ++i) {
      const size_t j = (i + 1) % low.size();
      maker.plane((low[j] - low[i]).cross(high[i] - low[i]).normalized(),
                  {polygon_path({low[i], low[j], high[j], high[i]})});
    }
  }
}

}  // namespace

SpaceCurve line(const Vec3& from, const Vec3& to) {
  SpaceCurve curve;
  curve.kind = SpaceCurve::Kind::line;
  curve.t1 = (to - from).norm();
  curve.start = from;
  curve.end = to;
  return curve;
}

SpaceCurve arc(const Frame& frame, double radius, double from, double to) {
  SpaceCurve curve;
  curve.kind = SpaceCurve::Kind::circle;
  const bool turned = to < from;
  curve.circle = turned ? Frame{frame.origin, frame.x, -frame.y, -frame.z} : frame;
  curve.radius = radius;
  curve.t0 = turned ? -from : from;
  curve.t1 = turned ? -to : to;
  curve.start = curve.point(curve.t0);
  curve.end = curve.point(curve.t1);
  return curve;
}

Path polygon_path(const std::vector<Vec3>& corners) {
  Path path;
  for (size_t i = 0; i < corners.size(); ++i)
    path.push_back(line(corners[i], corners[(i + 1) % corners.size()]));
  return path;
}

int SolidMaker::plane(const Vec3& outward, const std::vector<Path>& loops) {
  SolidFace face;
  face.surface = frame_from_normal(loops.front().front().start, outward);
  return add(std::move(face), loops);
}

int SolidMaker::curved(const Developable& surface, int sense, const std::vector<Path>& loops) {
  SolidFace face;
  face.surface = surface;
  face.sense = sense;
  return add(std::move(face), loops);
}

int SolidMaker::doubly_curved(const std::string& kind, const std::vector<Path>& loops) {
  SolidFace face;
  face.surface = DoublyCurved{kind};
  return add(std::move(face), loops);
}

int SolidMaker::add(SolidFace face, const std::vector<Path>& loops) {
  const int index = static_cast<int>(model_.faces.size());
  for (const Path& path : loops) {
    auto& loop = face.loops.emplace_back();
    for (const SpaceCurve& curve : path) {
      loop.push_back(use_of(curve));
      SolidEdge& edge = model_.edges[loop.back().edge];
      if (edge.uses < 2) {
        edge.faces[edge.uses] = index;
        edge.forward[edge.uses] = loop.back().forward;
      }
      ++edge.uses;
    }
  }
  model_.faces.push_back(std::move(face));
  return index;
}

CoEdge SolidMaker::use_of(const SpaceCurve& curve) {
  const Vec3 middle = middle_of(curve);
  const auto tangent = [](const SpaceCurve& c) { return c.tangent((c.t0 + c.t1) / 2); };
  for (int e = 0; e < std::ssize(model_.edges); ++e) {
    const SpaceCurve& known = model_.edges[e].curve;
    const bool same = near(known.start, curve.start) && near(known.end, curve.end);
    const bool turned = near(known.start, curve.end) && near(known.end, curve.start);
    if ((same || turned) && near(middle_of(known), middle))
      return {e, tangent(known).dot(tangent(curve)) > 0};
  }
  SolidEdge& edge = model_.edges.emplace_back();
  edge.curve = curve;
  edge.vertices = {vertex_at(curve.start), vertex_at(curve.end)};
  return {static_cast<int>(model_.edges.size()) - 1, true};
}

int SolidMaker::vertex_at(const Vec3& point) {
  for (int v = 0; v < std::ssize(vertices_); ++v)
    if (near(vertices_[v], point)) return v;
  vertices_.push_back(point);
  return static_cast<int>(vertices_.size()) - 1;
}

SolidModel SolidMaker::build() && {
  for (const SolidEdge& edge : model_.edges)
    EXPECT_EQ(edge.uses, 2) << "an edge at " << edge.curve.start.transpose() << " … "
                            << edge.curve.end.transpose();
  return std::move(*this).build_open();
}

SolidModel SolidMaker::build_open() && {
  Vec3 lo = vertices_.front(), hi = lo;
  for (const SolidEdge& edge : model_.edges) {
    for (const Vec3& p : {edge.curve.start, middle_of(edge.curve), edge.curve.end}) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
  }
  model_.size = (hi - lo).norm();
  model_.centre = (lo + hi) / 2;
  for (SolidFace& face : model_.faces)
    if (has_border_volume(face)) face.volume = volume_under(face, model_);
  return std::move(model_);
}

SolidModel prism(const std::vector<Loop>& profile, double height, const Frame& frame) {
  SolidMaker maker;
  std::vector<Path> low, high;
  for (const Loop& loop : profile) {
    Path& bottom = low.emplace_back();
    Path& top = high.emplace_back();
    for (const Curve2& curve : loop) {
      bottom.push_back(in_space(curve, frame, 0.0));
      top.push_back(in_space(curve, frame, height));
    }
    bottom = backwards(bottom);
  }
  maker.plane(-frame.z, low);
  maker.plane(frame.z, high);
  for (const Loop& loop : profile)
    for (const Curve2& curve : loop)
      add_wall(maker, curve, frame, height);
  return std::move(maker).build();
}

Loop strip_profile(double thickness, const std::vector<Leg>& legs) {
  Loop right, left;
  Vec2 at = Vec2::Zero();
  double heading = 0.0;
  const auto direction = [](double angle) { return Vec2(std::cos(angle), std::sin(angle)); };
  for (const Leg& leg : legs) {
    const Vec2 side = direction(heading + pi / 2);
    const Vec2 next = at + leg.length * direction(heading);
    right.push_back(Segment{at, next});
    left.push_back(Segment{next + thickness * side, at + thickness * side});
    at = next;
    if (leg.turn == 0.0) continue;
    const double sign = leg.turn > 0 ? 1.0 : -1.0;
    const double right_radius = leg.inside_radius + (sign > 0 ? thickness : 0.0);
    const double left_radius = leg.inside_radius + (sign > 0 ? 0.0 : thickness);
    const Vec2 centre = at + sign * right_radius * side;
    const double start = heading - sign * pi / 2;
    heading += leg.turn;
    if (right_radius > 0) right.push_back(Arc{centre, right_radius, start, leg.turn});
    if (left_radius > 0) left.push_back(Arc{centre, left_radius, start + leg.turn, -leg.turn});
    at = centre + right_radius * direction(start + leg.turn);
  }
  const Vec2 side = direction(heading + pi / 2);
  right.push_back(Segment{at, at + thickness * side});
  right.insert(right.end(), left.rbegin(), left.rend());
  right.push_back(Segment{{0.0, thickness}, {0.0, 0.0}});
  return right;
}

std::vector<Vec2> rectangle_at(const Vec2& low, const Vec2& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

std::vector<Vec2> clockwise(std::vector<Vec2> polygon) {
  return {polygon.rbegin(), polygon.rend()};
}

SolidModel plate(double thickness, const std::vector<Lofted>& contours,
                 const std::vector<Turned>& turned) {
  std::vector<Path> bottom, top;
  for (const Lofted& contour : contours) {
    bottom.push_back(backwards(polygon_path(lifted(contour.sections.front(), 0.0))));
    top.push_back(polygon_path(lifted(contour.sections.back(), thickness)));
  }
  for (const Turned& feature : turned) {
    const Vec2& first = feature.profile.front();
    const Vec2& last = feature.profile.back();
    if (first.x() > 0) top.push_back({backwards(circle_at(feature.centre, first))});
    if (last.x() > 0) bottom.push_back({circle_at(feature.centre, last)});
  }
  SolidMaker maker;
  maker.plane(-Vec3::UnitZ(), bottom);
  maker.plane(Vec3::UnitZ(), top);
  for (const Lofted& contour : contours)
    add_walls(maker, contour);
  for (const Turned& feature : turned)
    for (size_t i = 0; i + 1 < feature.profile.size(); ++i)
      add_turned(maker, feature.centre, feature.profile[i], feature.profile[i + 1]);
  return std::move(maker).build();
}

SolidModel plate(double thickness, const Vec2& size, const std::vector<Turned>& turned) {
  const auto contour = rectangle_at(Vec2::Zero(), size);
  return plate(thickness, {Lofted{{contour, contour}, {0.0, thickness}}}, turned);
}

int edge_between(const SolidModel& model, int a, int b) {
  for (int e = 0; e < std::ssize(model.edges); ++e) {
    const auto& faces = model.edges[e].faces;
    if ((faces[0] == a && faces[1] == b) || (faces[0] == b && faces[1] == a)) return e;
  }
  ADD_FAILURE() << "faces " << a << " and " << b << " do not meet";
  return 0;
}

}  // namespace planish::brep::test
