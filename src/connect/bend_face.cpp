#include "general_fit.hpp"
#include "joined_face.hpp"
#include "plate_outline.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>

// The face of a bend in the (u, v) of its mid-surface: two lateral boundaries and two tangent
// rulings, each of these cut into joints with its plate and what lies free beside them. Lengths are
// measured by chords in space and extrapolated, independent of the development that lays the face
// flat later, so that a wrong one shows in the certificate (math.md#certificate-independence).

namespace planish::connect_detail {
namespace {

// Parts of a ruling shorter than this share of the bend's length are left out.
constexpr double kNoPiece = tolerance::kComputed;

struct TaggedCurve {
  Curve2 curve;
  std::optional<int> plate = {};  // that is joined there
  int row = 0;                    // of the fits, whose joint it is
};
using TaggedLoop = std::vector<TaggedCurve>;

Curve2 shifted(const Curve2& curve, double v) {
  return transformed(curve, Isometry2(Eigen::Translation2d(0.0, v)));
}

// Length on the skin by chords in space, extrapolated, independent of any development. A ruling is
// its own chord.
double length_in_space(const Developable& surface, const Curve2& uv) {
  const auto* segment = std::get_if<Segment>(&uv);
  if (segment && segment->a.x() == segment->b.x())
    return (point_on(surface, segment->b) - point_on(surface, segment->a)).norm();
  const auto* spline = std::get_if<CubicSpline>(&uv);
  const int chords = std::max(64, spline ? 16 * static_cast<int>(spline->poles.size() / 3) : 0);
  std::vector<Vec3> points;
  for (int i = 0; i <= chords; ++i)
    points.push_back(point_on(surface, point_at(uv, static_cast<double>(i) / chords)));
  const auto length = [&](std::size_t step) {
    double sum = 0.0;
    for (std::size_t i = step; i < points.size(); i += step)
      sum += (points[i] - points[i - step]).norm();
    return sum;
  };
  const double a = length(4), b = length(2), c = length(1);
  const double ab = b + (b - a) / 3.0, bc = c + (c - b) / 3.0;
  return bc + (bc - ab) / 15.0;
}

TaggedLoop reversed_loop(TaggedLoop loop) {
  std::ranges::reverse(loop);
  for (TaggedCurve& border : loop)
    border.curve = reversed(border.curve);
  return loop;
}

/// A joint of a side: along the ruling, and the row of the fits that it belongs to.
struct RulingJoint {
  JointRange range;
  int row = 0;
};

// The joints of a band with the plate on one of its sides, from lower to higher v.
std::vector<RulingJoint> joints_of(const Parts& parts, int bend, int side, int plate) {
  std::vector<RulingJoint> joints;
  for (int row = 0; row < static_cast<int>(parts.fits.size()); ++row)
    if (row == bend || parts.fits[row].joint_of == std::pair{bend, side})
      joints.push_back({joint_range(parts.fits[row], side, parts.plates[plate]), row});
  std::ranges::sort(joints, {}, [](const RulingJoint& joint) { return joint.range.low; });
  return joints;
}

// The ruling at a side from lower to higher v.
TaggedLoop ruling(const Parts& parts, int bend, int side) {
  const BendFit& fit = parts.fits[bend];
  const double u = fit.surface.azimuth(side), low = fit.boundaries.low.v[side],
               high = fit.boundaries.high.v[side];
  const auto plate = parts.plate_of(bend, side);
  if (!plate) return {TaggedCurve{Segment{{u, low}, {u, high}}}};
  const double least = kNoPiece * (high - low);
  TaggedLoop part;
  double from = low;
  for (auto [range, row] : joints_of(parts, bend, side, *plate)) {
    if (range.low - from <= least) range.low = from;
    if (high - range.high <= least) range.high = high;
    if (range.low > from) part.push_back({Segment{{u, from}, {u, range.low}}});
    part.push_back({Segment{{u, range.low}, {u, range.high}}, plate, row});
    from = range.high;
  }
  if (from < high) part.push_back({Segment{{u, from}, {u, high}}});
  return part;
}

// Counter-clockwise in (u, v).
TaggedLoop loop_of(const Parts& parts, int bend) {
  const BendFit& fit = parts.fits[bend];
  TaggedLoop loop{TaggedCurve{fit.boundaries.low.curve}};
  const auto append = [&](const TaggedLoop& part) {
    loop.insert(loop.end(), part.begin(), part.end());
  };
  append(ruling(parts, bend, 1 - fit.surface.first));
  append({TaggedCurve{reversed(fit.boundaries.high.curve)}});
  append(reversed_loop(ruling(parts, bend, fit.surface.first)));
  return loop;
}

// The reference skin, and the shift of its v from that of the mid-surface.
std::pair<Developable, double> skin_of(const BendSurface& surface, double offset) {
  if (const auto* cylinder = std::get_if<Cylinder>(&surface.mid))
    return {Cylinder{cylinder->frame, cylinder->radius + offset}, 0.0};
  if (surface.kind == BendKind::general) return {offset_surface(surface, offset), 0.0};
  Cone cone = std::get<Cone>(surface.mid);
  cone.frame.origin -= offset / std::sin(cone.half_angle) * cone.frame.z;
  return {cone, offset / std::tan(cone.half_angle)};
}

}  // namespace

JoinedFace bend_face(const Parts& parts, int bend, int sense) {
  const auto [surface, shift] = skin_of(parts.fits[bend].surface, 0.5 * parts.thickness * sense);
  JoinedFace made;
  made.face.surface = surface;
  made.face.sense = sense;
  TaggedLoop loop = loop_of(parts, bend);
  if (sense < 0) loop = reversed_loop(std::move(loop));
  BorderLoop borders;
  for (const TaggedCurve& border : loop) {
    const Curve2 curve = shifted(border.curve, shift);
    if (border.plate)
      made.joints.push_back({*border.plate, border.row, static_cast<int>(borders.size())});
    borders.push_back({.curve = curve, .edge_length = length_in_space(surface, curve)});
  }
  made.face.loops.push_back(std::move(borders));
  return made;
}

}  // namespace planish::connect_detail
