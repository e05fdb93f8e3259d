// Where the back gauge touches. Straight borders of what lies in the plane of the sheet that face
// the gauge are tried from the longest on, then outer faces of flanges that stand upright, and on
// request edges of openings by the finger's nose; at each the section of finger or nose is swept
// over all parts, and it must be clear over its width. Where no finger can touch with all its
// width, one may stand over an end. What must hold: before the stroke no finger stands in a tool;
// beside the die it is lifted over it (math.md#gauging).
#include "gauge.hpp"

#include "gauge_edges.hpp"
#include "obstruction.hpp"
#include "sentences.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace planish::brake_detail {

namespace {

constexpr double kLeastTouching = 0.5;  // of a finger's width, and of the edge of a sheet
constexpr double kLeastTouch = 5.0;     // mm of a face, across its level line
constexpr double kSameEdge = 1e-3;      // mm: lengths that are one

bool has_room(const Interval& along, std::vector<Interval> blocked, double width) {
  double from = along.lo;
  for (const Interval& wall : joined(std::move(blocked), 0.0)) {
    if (std::min(wall.lo + kPenetration, along.hi) - from >= width) return true;
    from = std::max(from, wall.hi - kPenetration);
  }
  return along.hi - from >= width;
}

bool is_in_range(const GaugeEdge& edge, const BackGauge& gauge) {
  return edge.away >= gauge.from && edge.away <= gauge.to;
}

bool is_touched(const GaugeEdge& edge) { return !edge.flange || edge.touched >= kLeastTouch; }

double length(const GaugeEdge& edge) { return edge.along.hi - edge.along.lo; }

/// How high a finger that lies on the die touches the edge of the sheet; empty if it cannot.
std::optional<double> over_die(const BackGauge& gauge, double thickness) {
  double bottom = 0.0;
  for (const Vec2& corner : gauge.finger)
    bottom = std::min(bottom, corner.y());
  const double height = -thickness - bottom;
  const bool touches = height + front_of(gauge).lo <= -kLeastTouching * thickness;
  if (height <= 0.0 || height > gauge.highest || !touches) return std::nullopt;
  return height;
}

}  // namespace

/// A place of a finger or its nose.
struct GaugeStops::Place {
  GaugeEdge edge;
  bool by_nose = false;
  double width = 0.0, least = 0.0;  ///< of what touches; of that, what must
  std::optional<bool> has_room = {};
  /// Whether the tool leaves it room, by punch and by die.
  std::array<std::vector<std::optional<bool>>, 2> clear = {};

  const Obstacle& shape(ToolRoom& tools) const { return by_nose ? tools.nose() : tools.finger(); }
  Vec2 at() const { return {edge.away, edge.height}; }
};

GaugeStops::GaugeStops(StageCache& cache, const Setting& stroke, bool openings)
    : cache_(cache),
      stroke_(stroke),
      gauge_(cache.inputs().tools.machine.gauge),
      openings_(openings) {}
GaugeStops::~GaugeStops() = default;

/// Those at edges that the gauge reaches and that are long enough, the longest first; where the
/// finger could stand in the die also above it.
void GaugeStops::add(std::vector<GaugeEdge> edges, bool by_nose, double share) {
  const double width = by_nose ? gauge_->nose->width : gauge_->finger_width;
  std::erase_if(edges, [&](const GaugeEdge& edge) {
    return !is_in_range(edge, *gauge_) || !is_touched(edge) || length(edge) < share * width;
  });
  std::ranges::stable_sort(edges, [](const GaugeEdge& a, const GaugeEdge& b) {
    return length(a) > length(b) + kSameEdge;
  });
  const auto lifted = over_die(*gauge_, cache_.inputs().work.thickness);
  for (GaugeEdge& edge : edges) {
    places_.push_back({edge, by_nose, width, share * width});
    if (!lifted || edge.flange || by_nose) continue;
    edge.height = *lifted;
    places_.push_back({std::move(edge), by_nose, width, share * width});
  }
}

/// The next kind of places, in the order in which they are preferred.
bool GaugeStops::add_next() {
  if (!gauge_) return false;
  const auto edges = [&](bool in_openings) {  // apart, openings come last
    std::vector<GaugeEdge> all = edges_facing(cache_, stroke_);
    std::erase_if(all, [&](const GaugeEdge& edge) {
      return in_openings ? !edge.in_opening || !openings_ : edge.in_opening && openings_;
    });
    return all;
  };
  switch (kind_++) {
    case 0:
      add(edges(false), false, 1.0);
      return true;
    case 1:
      add(faces_facing(cache_, stroke_, *gauge_), false, 1.0);
      return true;
    case 2:
      add(edges(false), false, kLeastTouching);
      return true;
    case 3:
      add(faces_facing(cache_, stroke_, *gauge_), false, kLeastTouching);
      return true;
    case 4:
      if (gauge_->nose) add(edges(true), true, 1.0);
      return true;
    case 5:
      add(edges(true), false, kLeastTouching);
      return true;
    default:
      return false;
  }
}

/// Whether the parts leave it room over its width.
bool GaugeStops::has_room_at(Place& place) {
  if (place.has_room) return *place.has_room;
  const bool left = stroke_.direction > 0;
  const PressMotion lying = motion(cache_.inputs(), stroke_);
  const Obstacle here = moved(place.shape(cache_.tools()), place.at()), there = mirrored(here);
  const double over = place.width - place.least;
  const Interval room{place.edge.along.lo - over, place.edge.along.hi + over};
  std::vector<Interval> blocked;
  for (const PlacedPart* part : cache_.parts(stroke_)) {
    const auto walls = blocked_along(lying, *part, left ? here : there, left ? there : here, 0.0,
                                     room);
    blocked.insert(blocked.end(), walls.begin(), walls.end());
  }
  place.has_room = has_room(room, std::move(blocked), place.width);
  return *place.has_room;
}

/// Before the stroke the punch touches the upper skin and the die the lower one. Tools count as
/// long as the machine.
bool GaugeStops::is_clear_of(ToolKind kind, int tool, const Place& place) {
  const Obstacle& steel = cache_.tools().deeper(kind, tool, kPenetration);
  const Vec2 down(0.0, is_above(kind) ? 0.0 : -cache_.inputs().work.thickness);
  const Obstacle& shape = place.shape(cache_.tools());
  const Vec2 by = place.at() - down;
  if (steel.box.hi.x() < shape.box.lo.x() + by.x()) return true;
  return std::ranges::none_of(shape.pieces, [&](const Convex& piece) {
    const Convex here = moved(piece, by);
    return std::ranges::any_of(steel.pieces,
                               [&](const Convex& other) { return separation(here, other) <= 0.0; });
  });
}

/// What of the tools such a place is in.
std::optional<ToolKind> GaugeStops::tool_at(Place& place, int punch, int die) {
  const BrakeTools& tools = cache_.inputs().tools;
  for (const ToolKind row : {ToolKind::die, ToolKind::punch}) {
    const int tool = row == ToolKind::punch ? punch : die;
    auto& known = place.clear[row == ToolKind::punch ? 0 : 1];
    if (known.empty())
      known.resize(row == ToolKind::punch ? tools.punches.size() : tools.dies.size());
    auto& clear = known[tool];
    if (!clear) clear = is_clear_of(row, tool, place) && is_clear_of(beam_of(row), tool, place);
    if (!*clear) return row;
  }
  return std::nullopt;
}

std::optional<GaugeStop> GaugeStops::with(int punch, int die) {
  for (std::size_t i = 0;; ++i) {
    while (i == places_.size())
      if (!add_next()) return std::nullopt;
    Place& place = places_[i];
    if (tool_at(place, punch, die) || !has_room_at(place)) continue;
    const GaugeEdge& edge = place.edge;
    return GaugeStop{edge.away,   edge.in_pattern, edge.height,
                     edge.flange, edge.in_opening, place.by_nose};
  }
}

std::optional<GaugeStops::InTool> GaugeStops::in_tool(int punch, int die) {
  while (add_next()) {
  }
  for (Place& place : places_)
    if (const auto kind = tool_at(place, punch, die); kind && has_room_at(place))
      return InTool{place.edge.away, *kind};
  return std::nullopt;
}

std::optional<GaugeStop> gauge(StageCache& cache, const Setting& stroke) {
  return GaugeStops(cache, stroke).with(stroke.punch, stroke.die);
}

namespace {

/// A flange that fingers would touch, or touch more of, if they went higher or lower.
bool is_beyond_lift(const GaugeEdge& face, const BackGauge& gauge) {
  return !is_touched(face) && (face.height == gauge.lowest || face.height == gauge.highest);
}

/// Edges and faces on the gauge's side of the line.
std::vector<GaugeEdge> all_facing(StageCache& cache, const Setting& stroke,
                                  const BackGauge& gauge) {
  std::vector<GaugeEdge> all = edges_facing(cache, stroke);
  std::ranges::move(faces_facing(cache, stroke, gauge), std::back_inserter(all));
  return all;
}

/// Of faces that are touched too little: that the fingers' lift ends before one, or that there is
/// nothing else.
std::optional<Remark> untouched(const std::vector<GaugeEdge>& edges, const BackGauge& gauge) {
  const auto beyond = std::ranges::find_if(
      edges, [&](const GaugeEdge& edge) { return is_beyond_lift(edge, gauge); });
  if (beyond != edges.end())
    return remark_of(say::face_beyond_lift, {{"away", beyond->away, unit::mm},
                                             {"lowest", gauge.lowest, unit::mm},
                                             {"highest", gauge.highest, unit::mm}});
  if (std::ranges::none_of(edges, is_touched))
    return remark_of(say::face_too_low, {{"away", edges.front().away, unit::mm},
                                         {"touched", edges.front().touched, unit::mm},
                                         {"least", kLeastTouch, unit::mm}});
  return std::nullopt;
}

/// Whether the nose would do in an opening on either side, which nobody asked for.
bool nose_would_do(StageCache& cache, Setting stroke) {
  const auto& gauge = cache.inputs().tools.machine.gauge;
  if (!gauge || !gauge->nose || cache.inputs().options.gauge_openings) return false;
  const auto does = [&] {
    return GaugeStops(cache, stroke, true).with(stroke.punch, stroke.die).has_value();
  };
  if (does()) return true;
  stroke.direction = -stroke.direction;
  return does();
}

Remark what_is_untouched(StageCache& cache, const Setting& stroke) {
  const auto& machine = cache.inputs().tools.machine;
  if (!machine.gauge) return remark_of(say::no_back_gauge);
  const BackGauge& gauge = *machine.gauge;
  std::vector<GaugeEdge> edges = all_facing(cache, stroke, gauge);
  Setting told = stroke;
  if (edges.empty()) {  // the sheet lies either way
    told.direction = -stroke.direction;
    edges = all_facing(cache, told, gauge);
    if (brake_detail::gauge(cache, told)) return remark_of(say::edge_on_other_side);
  }
  if (edges.empty())
    return remark_of(has_edge_aside(cache, stroke) ? say::edge_leans : say::no_parallel_edge);
  const auto off = [&](const GaugeEdge& edge) {
    return std::max({gauge.from - edge.away, edge.away - gauge.to, 0.0});
  };
  const GaugeEdge nearest = *std::ranges::min_element(edges, {}, off);
  if (!is_in_range(nearest, gauge))
    return remark_of(nearest.flange ? say::face_out_of_range : say::edge_out_of_range,
                     {{"away", nearest.away, unit::mm},
                      {"from", gauge.from, unit::mm},
                      {"to", gauge.to, unit::mm}});
  std::erase_if(edges, [&](const GaugeEdge& edge) { return !is_in_range(edge, gauge); });
  if (const auto faces = untouched(edges, gauge)) return *faces;
  std::erase_if(edges, [](const GaugeEdge& edge) { return !is_touched(edge); });
  const double longest = length(*std::ranges::max_element(edges, {}, length));
  if (longest < kLeastTouching * gauge.finger_width)
    return remark_of(say::edge_too_short,
                     {{"longest", longest, unit::mm}, {"width", gauge.finger_width, unit::mm}});
  if (const auto in = GaugeStops(cache, told).in_tool(stroke.punch, stroke.die))
    return remark_of(say::finger_in_tool,
                     {{"away", in->away, unit::mm},
                      {"tool", text_of(cache.tools().name(in->kind, tool_of(in->kind, stroke)))}});
  return remark_of(say::finger_blocked);
}

}  // namespace

Remark why_ungauged(StageCache& cache, const Setting& stroke) {
  Remark why = what_is_untouched(cache, stroke);
  if (nose_would_do(cache, stroke)) say_after(why.told, "; ", tell(say::nose_would_touch, {}));
  return why;
}

}  // namespace planish::brake_detail
