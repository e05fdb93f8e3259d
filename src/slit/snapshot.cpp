#include "snapshot.hpp"

#include "design_load.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

// What a session knows, as values: parts of a snapshot never change, so copies share them and an
// earlier one can be kept. The problem of a strip is put together here: where it begins and must
// end (a plane of symmetry, a placed end, a facet of the second panel), what attracts it, and its
// limits, with the multipliers it had (math.md#strip-conditions).

namespace planish::slit_detail {
namespace {

/// The strips' places on the curve, evenly spaced from its start to its end; a single strip in its
/// middle.
std::vector<Vec2> places_along(const BezierCurve& curve, const SlitSheet& sheet) {
  double rest = length(curve);
  const int count = static_cast<int>(sheet.strips.size());
  for (int strip = 0; strip < count; ++strip)
    rest -= sheet.width_at_end(strip);
  const double apart = count > 1 ? rest / (count - 1) : 0.0;
  std::vector<double> lengths;
  double at = count > 1 ? 0.0 : 0.5 * rest;
  for (int strip = 0; strip < count; ++strip) {
    const double width = sheet.width_at_end(strip);
    lengths.push_back(at);
    lengths.push_back(at + width);
    at += width + apart;
  }
  return points_at_lengths(curve, lengths);
}

/// `before`: how far before the plane, with its sign, the last ridge ends.
std::vector<EndCondition> at_symmetry_plane(EndAngle angle, const std::array<double, 2>& before) {
  using Of = EndCondition::Of;
  std::vector<EndCondition> ends{{Of::left_end, Vec3::UnitX(), before[0]},
                                 {Of::right_end, Vec3::UnitX(), before[1]}};
  if (angle == EndAngle::right_angle) ends.push_back({Of::normal, Vec3::UnitX(), 0.0});
  if (angle == EndAngle::level) ends.push_back({Of::along, Vec3::UnitY(), 0.0});
  return ends;
}

/// Two directions with `direction` that are a right-handed system.
std::array<Vec3, 2> perpendiculars(const Vec3& direction) {
  const Frame frame = frame_from_normal(Vec3::Zero(), direction.normalized());
  return {frame.x, frame.y};
}

}  // namespace

std::vector<EndCondition> conditions_of(const StripEnd& end) {
  using Of = EndCondition::Of;
  std::vector<EndCondition> ends;
  if (end.position)
    for (int axis = 0; axis < 3; ++axis)
      ends.push_back({Of::middle, Vec3::Unit(axis), (*end.position)[axis]});
  if (end.direction)
    for (const Vec3& across : perpendiculars(*end.direction))
      ends.push_back({Of::along, across, 0.0});
  if (end.across && end.direction)
    ends.push_back({Of::across, end.direction->cross(*end.across).normalized(), 0.0});
  if (end.across && !end.direction)
    for (const Vec3& across : perpendiculars(*end.across))
      ends.push_back({Of::across, across, 0.0});
  return ends;
}

namespace {

auto facet_at(const std::vector<PanelFacet>& panel, int strip) {
  return std::ranges::find(panel, strip, &PanelFacet::strip);
}

const StripParameters& parameters_of(const Snapshot& now, int strip, StripParameters& room) {
  const Slot& slot = now.slot(strip);
  if (slot.p.size()) return slot.p;
  room = flat_parameters(base_of(now, strip));
  return room;
}

}  // namespace

const PanelFacet* far_facet_of(const Snapshot& now, int strip) {
  const auto facet = facet_at(*now.second_panel, strip);
  return facet == now.second_panel->end() ? nullptr : &*facet;
}

StripEnd end_of(const Snapshot& now, int strip) {
  const PanelFacet* facet = far_facet_of(now, strip);
  if (!facet) return now.design->ends[strip];
  return {.position = facet->frame.point(0.5 * (facet->corners[1] + facet->corners[2])),
          .across = base_of(now, strip).along_last_ridge(facet->frame).y};
}

void take_joined(Snapshot& now, std::vector<JoinedEnds> joined) {
  std::vector<PanelFacet> all;
  for (const JoinedEnds& one : joined)
    for (PanelFacet& facet : facets_of(now.design->sheet, one))
      all.push_back(std::move(facet));
  now.second_panel = std::make_shared<const std::vector<PanelFacet>>(std::move(all));
  now.joined = std::move(joined);
  now.placed = true;
}

StripBase base_of(const Snapshot& now, int strip) {
  const SlitSheet& sheet = now.design->sheet;
  const auto facet = facet_at(*now.panel, strip);
  const auto start = sheet.start_of(strip), end = sheet.ends_of(strip);
  const auto edge = [&](std::size_t side) {
    const std::vector<Vec2>& chain = sheet.strips[strip].edges[side];
    return chain.empty() ? EdgeCurve(facet->corners[side == 0 ? 0 : 3].y())
                         : EdgeCurve(chain, start[side], end[side]);
  };
  return {facet->frame, {edge(0), edge(1)}, start, end, now.design->ridges};
}

void take_seat_curve(Snapshot& now, const SlitDesign& design) {
  now.seat = design.seat_curve ? std::make_shared<const BezierSearch>(*design.seat_curve) : nullptr;
  now.seat_places = design.seat_curve ? std::make_shared<const std::vector<Vec2>>(
                                            places_along(*design.seat_curve, design.sheet))
                                      : nullptr;
}

double half_sign(const Snapshot& now) {
  return now.panel->front().frame.point(now.panel->front().corners[0]).x() < 0.0 ? -1.0 : 1.0;
}

std::optional<double> least_height(const Snapshot& now, int strip) {
  if (!now.design->ground) return std::nullopt;
  const StripBase base = base_of(now, strip);
  double height = 0.5 * now.design->sheet.thickness;
  for (std::size_t side = 0; side < 2; ++side) {
    height = std::min(height, base.facet.point(base.sides[side].place(base.start[side]).at).y());
    if (const PanelFacet* far = far_facet_of(now, strip))
      height = std::min(height, far->frame.point(far->corners[1 + side]).y());
  }
  return height;
}

namespace {

/// x of the ends of a strip's last ridge where the uncut sheet beyond crosses the symmetry plane at
/// a right angle.
std::array<double, 2> before_symmetry(const Snapshot& now, int strip) {
  std::array<double, 2> before = now.design->sheet.ends_of(strip);
  for (double& x : before)
    x = half_sign(now) * (now.design->sheet.far_line() - x);
  return before;
}

}  // namespace

StripProblem problem_of(const Snapshot& now, int strip) {
  const SlitDesign& design = *now.design;
  StripProblem problem;
  problem.base = base_of(now, strip);
  problem.base.known_width = problem.base.width();
  const PanelFacet* facet = far_facet_of(now, strip);
  if (facet) problem.far_facet = problem.base.along_last_ridge(facet->frame);
  problem.ends = design.sheet.symmetric && !facet
                     ? at_symmetry_plane(design.end_angle, before_symmetry(now, strip))
                     : conditions_of(end_of(now, strip));
  problem.mirrored = design.sheet.symmetric && !facet && design.end_angle == EndAngle::right_angle;
  problem.objective = design.objective;
  problem.load = load_of(design, strip);
  problem.weights = design.weights;
  for (const SlitAnchor& anchor : design.anchors)
    if (anchor.strip == strip)
      problem.anchors.push_back({anchor.ridge, anchor.side == StripEdge::left ? 0 : 1, anchor.at});
  if (design.sheet.symmetric && now.seat) {
    problem.seat = now.seat;
    problem.seat_places = {(*now.seat_places)[2 * strip], (*now.seat_places)[2 * strip + 1]};
  }
  problem.scan = now.slot(strip).scan;
  problem.min_radius = design.sheet.min_radius();
  problem.inequalities = now.slot(strip).inequalities;
  return problem;
}

FoldedStrip folded_of(const Snapshot& now, int strip) {
  StripParameters room;
  const StripBase base = base_of(now, strip);
  FoldedStrip shape = folded_strip(base, parameters_of(now, strip, room));
  const PanelFacet* facet = far_facet_of(now, strip);
  shape.ends_directed = !facet && (now.design->sheet.symmetric
                                       ? now.design->end_angle != EndAngle::free
                                       : now.design->ends[strip].direction.has_value());
  if (facet)
    shape.ridges.back().fold = fold_into(base.along_last_ridge(shape.quads.back()),
                                         base.along_last_ridge(facet->frame));
  return shape;
}

FoldedSlitSheet folded_sheet(const Snapshot& now) {
  FoldedSlitSheet sheet{now.design->sheet.thickness,
                        now.design->sheet.reach(),
                        now.design->sheet.symmetric,
                        *now.panel,
                        {},
                        *now.second_panel};
  for (int strip = 0; strip < now.count(); ++strip)
    sheet.strips.push_back(folded_of(now, strip));
  return sheet;
}

void reopen(Snapshot& now, int strip) {
  Slot slot = now.slot(strip);
  slot.state.status = StripStatus::open;
  slot.undivided = 0.0;
  now.slots[strip] = std::make_shared<const Slot>(std::move(slot));
}

StripParameters subdivided(const StripBase& base, const StripParameters& p) {
  const int quads = 2 * base.quads;
  StripParameters fine = StripParameters::Zero(parameter_count(quads));
  for (int ridge = 0; ridge < base.quads; ++ridge)
    fine[2 * ridge] = p[ridge];
  for (int ridge = 1; ridge < quads; ++ridge)
    for (int side = 0; side < 2; ++side)
      fine[abscissa_index(quads, ridge, side)] = 0.5 *
                                                 (abscissa(base, p, ridge / 2, side) +
                                                  abscissa(base, p, (ridge + 1) / 2, side)) /
                                                 base.unit();
  return fine;
}

std::shared_ptr<const ScannedSurface> scan_of(std::vector<Vec3> points) {
  return points.empty() ? nullptr : std::make_shared<const ScannedSurface>(std::move(points));
}

}  // namespace planish::slit_detail
