#include "bend_fit.hpp"
#include "refusals.hpp"
#include "tolerances.hpp"

#include <planish/connect/codes.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

// A curved section with a free end, at a plate or by itself (math.md#free-sections). All of it is
// given: radius, or radii at both ends of the ruling, sweep and length. The frame is that whose
// tangent ruling is where the section begins; a cone's apex lies where the radii would vanish, and
// its azimuth runs back where it opens the other way.

namespace planish::connect_detail {
namespace {

// A full turn: both ends touch, as the seam of a pipe does.
constexpr double kFullTurn = 2.0 * std::numbers::pi;

/// The ruling where a section begins: on the mid-surface, from `start` along `d`; the sheet
/// continues towards `onward` and turns towards `inside`; unit vectors.
struct Beginning {
  Vec3 start, d, onward, inside;
  double length = 0.0;
};

/// The refusal of a task for what stands at a key of its request.
tl::unexpected<Error> refused(const FitTask& task, const Refusal& refusal, const char* key,
                              Facts facts = {}) {
  facts.emplace_back("field", place::pointer(key));
  return fail(in_request(task, error_of(refusal, about(task, std::move(facts)))));
}

Result<Beginning> beginning(const FitTask& task) {
  const PlacedPlate* plate = task.plates[0];
  if (plate == nullptr)
    return Beginning{Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitY(), -Vec3::UnitX(),
                     *task.request.length};
  const auto& edges = task.request.edges[0];
  if (!edges || edges->size() != 1) return refused(task, refuse::section_without_edge, "/edges");
  const int edge = edges->front();
  if (task.taken[0].whole.contains(edge) || task.taken[0].parts.contains(edge))
    return refused(task, refuse::edge_taken, "/edges", {{"edge", edge}});
  const EdgePlace place = plate->place_of(edge);
  const std::vector<Vec2>& ring = plate->ring(place.ring);
  const Vec3 from = plate->frame.point(ring[place.corner]);
  const Vec3 to = plate->frame.point(ring[(place.corner + 1) % ring.size()]);
  const Vec3 d = (to - from).normalized();
  const double up = task.request.angle->radians() > 0.0 ? 1.0 : -1.0;
  return Beginning{from, d, d.cross(plate->frame.z), up * plate->frame.z, (to - from).norm()};
}

// A surface about `frame` whose tangent ruling runs from v = a to v = b, seen from the beginning.
void set_ends(BendFit& fit, double a, double b) {
  const double sweep = fit.surface.sweep;
  const auto boundary = [&](double v) { return Boundary{{v, v}, Segment{{0.0, v}, {sweep, v}}}; };
  fit.boundaries = {LateralBoundary::arc, boundary(std::min(a, b)), boundary(std::max(a, b))};
}

void roll_cylinder(BendFit& fit, const Beginning& begin, double radius, double sweep) {
  const Vec3 axis = (-begin.inside).cross(begin.onward);
  fit.surface.mid = Cylinder{
      frame_from_axes(begin.start + radius * begin.inside, axis, -begin.inside), radius};
  fit.surface.sweep = sweep;
  fit.surface.tangents[0] = {begin.start, axis, -begin.onward};
  set_ends(fit, 0.0, begin.length * axis.dot(begin.d));
}

// The cone whose radii of curvature at both ends of the ruling are given.
void roll_cone(BendFit& fit, const Beginning& begin, const std::array<double, 2>& radii,
               double sweep) {
  const double tangent = (radii[1] - radii[0]) / begin.length;
  const Vec3 apex = begin.start - radii[0] / tangent * begin.d;
  const Vec3 ruling = std::copysign(1.0, tangent) * begin.d;
  const double half = std::atan(std::abs(tangent));
  const Vec3 axis = std::cos(half) * ruling + std::sin(half) * begin.inside;
  Frame frame = frame_from_axes(apex, axis, ruling - ruling.dot(axis) * axis);
  fit.surface.kind = BendKind::cone;
  fit.surface.tan_half_angle = std::abs(tangent);
  fit.surface.sweep = sweep;
  fit.surface.tangents[0] = {apex, ruling, -begin.onward};
  if (frame.y.dot(begin.onward) < 0.0) {
    // The azimuth runs towards the beginning: it starts at the free end.
    fit.surface.first = 1;
    const Vec3 end = std::cos(sweep) * frame.x - std::sin(sweep) * frame.y;
    frame = frame_from_axes(apex, axis, end);
  }
  fit.surface.mid = Cone{frame, half};
  const double from = std::abs(radii[0] / tangent), to = std::abs(radii[1] / tangent);
  set_ends(fit, from, to);
}

// Without a plate the radii are those of the inner skin's circles, and the length is the height.
std::array<double, 2> free_cone(Beginning& begin, const std::array<double, 2>& inside,
                                double height, double thickness) {
  const double tangent = (inside[1] - inside[0]) / height;
  const double half = std::atan(tangent), cosine = std::cos(half);
  begin.length = height / cosine;
  begin.d = std::sin(half) * Vec3::UnitX() + cosine * Vec3::UnitZ();
  begin.inside = Vec3(-cosine, 0.0, std::sin(half));
  begin.start = inside[0] * Vec3::UnitX() - 0.5 * thickness * begin.inside;
  return {inside[0] / cosine + 0.5 * thickness, inside[1] / cosine + 0.5 * thickness};
}

bool conical(const BendRequest& request) {
  return request.inside_radii && (*request.inside_radii)[0] != (*request.inside_radii)[1];
}

Result<void> check(const FitTask& task) {
  const BendRequest& request = task.request;
  if (!request.angle) return refused(task, refuse::section_without_angle, "/angle");
  const double angle = std::abs(request.angle->radians());
  if (!(angle > 0.0) || angle > kFullTurn * (1.0 + tolerance::kRounding))
    return refused(task, refuse::bad_value, "/angle",
                   {{"name", "angle"},
                    {"value", request.angle->degrees(), unit::degrees},
                    {"range", "more than 0° and at most 360°"}});
  if (!request.inside_radius && !request.inside_radii)
    return refused(task, refuse::section_without_radius, "/inside_radius");
  if (task.plates[0] == nullptr && !(request.length && *request.length > 0.0))
    return refused(task, refuse::section_without_length, "/length");
  if (request.surface == SurfaceChoice::cone && !conical(request))
    return refused(task, refuse::section_cone_of_one_radius, "/surface");
  if (request.surface == SurfaceChoice::general)
    return refused(task, refuse::section_general, "/surface");
  if (request.surface == SurfaceChoice::cylinder && conical(request))
    return refused(task, refuse::section_cylinder_of_two_radii, "/surface");
  const double smallest = request.inside_radii
                              ? std::min((*request.inside_radii)[0], (*request.inside_radii)[1])
                              : *request.inside_radius;
  if (smallest < kSmallestInsideRadius)
    return refused(task, refuse::small_radius,
                   request.inside_radii ? "/inside_radii" : "/inside_radius",
                   {{"radius", smallest, unit::mm}, {"least", kSmallestInsideRadius, unit::mm}});
  return {};
}

}  // namespace

Result<BendFit> fit_section(const FitTask& task, const ConnectOptions&) {
  if (auto sound = check(task); !sound) return pass_on(sound);
  auto begin = beginning(task);
  if (!begin) return pass_on(begin);
  const BendRequest& request = task.request;
  const double half = 0.5 * task.thickness;
  const double sweep = std::min(std::abs(request.angle->radians()), kFullTurn);
  BendFit fit;
  const double radius = request.inside_radii ? (*request.inside_radii)[0] : *request.inside_radius;
  if (!conical(request)) {
    if (task.plates[0] == nullptr) begin->start = (radius + half) * Vec3::UnitX();
    roll_cylinder(fit, *begin, radius + half, sweep);
  } else {
    std::array<double, 2> radii{(*request.inside_radii)[0] + half,
                                (*request.inside_radii)[1] + half};
    if (task.plates[0] == nullptr)
      radii = free_cone(*begin, *request.inside_radii, *request.length, task.thickness);
    roll_cone(fit, *begin, radii, sweep);
  }
  if (task.plates[0] != nullptr) {
    const EdgePlace place = task.plates[0]->place_of(request.edges[0]->front());
    fit.runs[0] = {place.corner, 1, place.ring};
    fit.report.edges[0] = *request.edges[0];
  }
  FittedBend& report = fit.report;
  report.request = request;
  report.kind = fit.surface.kind;
  report.frame = {begin->start, begin->d, {-begin->onward, -begin->onward}, Vec3::Zero(), {}};
  report.angle = fit.surface.turned();
  report.lateral = LateralBoundary::arc;
  report.width = begin->length;
  if (conical(request)) report.half_angle = Angle::radians(std::atan(fit.surface.tan_half_angle));
  const double low = fit.surface.radius(fit.boundaries.low.v[0]) - half;
  const double high = fit.surface.radius(fit.boundaries.high.v[0]) - half;
  report.inside_radius = 0.5 * (low + high);
  report.inside_radii = {low, high};
  // The radii as given, of circles about the axis; left is where the ruling begins.
  if (request.inside_radii) report.inside_radii = *request.inside_radii;
  return fit;
}

}  // namespace planish::connect_detail
