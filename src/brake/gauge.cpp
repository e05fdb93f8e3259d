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

/// Of a line: what a finger is off by is at most tripled at its ends.
constexpr double kSquare = 1.0 / 3.0;
constexpr double kSameEdge = 1e-3;  // mm: lengths that are one

/// Where along a range a finger finds room between what blocks it, the outermost places of it.
std::vector<Interval> free_places(const Interval& along, std::vector<Interval> blocked,
                                  double width) {
  std::vector<Interval> free;
  double from = along.lo;
  const auto add = [&](double to) {
    if (to - from >= width) free.push_back({from, to});
  };
  for (const Interval& wall : joined(std::move(blocked), 0.0)) {
    add(std::min(wall.lo + kPenetration, along.hi));
    from = std::max(from, wall.hi - kPenetration);
  }
  add(along.hi);
  return free;
}

double length(const Interval& interval) { return interval.hi - interval.lo; }

/// How high a finger that lies on the die touches the edge of the sheet; empty if it cannot.
std::optional<double> over_die(const BackGauge& gauge, double thickness) {
  double bottom = 0.0;
  for (const Vec2& corner : gauge.finger)
    bottom = std::min(bottom, corner.y());
  const double height = -thickness - bottom;
  const bool touches = height + front_of(gauge).lo <= -GaugeStops::kLeastTouching * thickness;
  if (height <= 0.0 || height > gauge.highest || !touches) return std::nullopt;
  return height;
}

}  // namespace

/// A place of a finger or its nose.
struct GaugeStops::Place {
  GaugeEdge edge;
  bool by_nose = false;
  double width = 0.0, least = 0.0;                 ///< of what touches; of that, what must
  std::optional<std::vector<Interval>> free = {};  ///< room for one finger or more
  /// Whether the tool leaves it room, by punch and by die.
  std::array<std::vector<std::optional<bool>>, 2> clear = {};

  const Obstacle& shape(ToolRoom& tools) const { return by_nose ? tools.nose() : tools.finger(); }
  Vec2 at() const { return {edge.away, edge.height}; }
};

bool GaugeStops::stand_side_by_side(const Place& a, const Place& b) {
  return a.by_nose == b.by_nose && a.edge.in_opening == b.edge.in_opening &&
         (a.at() - b.at()).norm() < kSameEdge;
}

double least_touch(StageCache& cache, const Setting& stroke) {
  constexpr double kLeastOfEdge = 5.0;  // mm
  const auto pieces = pressed_pieces(cache, stroke);
  const double square = kSquare * (pieces.back().hi - pieces.front().lo);
  return std::min(GaugeStops::kLeastTouching * cache.inputs().tools.machine.gauge->finger_width,
                  std::max(kLeastOfEdge, square));
}

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
  const double least = share < 1.0 ? least_touch(cache_, stroke_) : width;
  std::erase_if(edges, [&](const GaugeEdge& edge) {
    return !is_in_range(edge, *gauge_) || !is_touched(edge) || edge.length() < least;
  });
  std::ranges::stable_sort(edges, [](const GaugeEdge& a, const GaugeEdge& b) {
    return a.length() > b.length() + kSameEdge;
  });
  const auto lifted = over_die(*gauge_, cache_.inputs().work.thickness);
  for (GaugeEdge& edge : edges) {
    places_.push_back({edge, by_nose, width, least});
    if (!lifted || edge.is_formed() || by_nose) continue;
    edge.height = *lifted;
    places_.push_back({std::move(edge), by_nose, width, least});
  }
}

/// The next kind of places, in the order in which they are preferred.
bool GaugeStops::add_next() {
  if (!gauge_) return false;
  const auto edges = [&](bool in_openings, double width = 0.0) {
    std::vector<GaugeEdge> all = edges_facing(cache_, stroke_, kLeastTouching * width);
    std::erase_if(all, [&](const GaugeEdge& edge) { return edge.in_opening != in_openings; });
    return all;
  };
  switch (kind_++) {
    case 0:
      add(edges(false, gauge_->finger_width), false, 1.0);
      return true;
    case 1:
      add(formed_facing(cache_, stroke_, *gauge_), false, 1.0);
      return true;
    case 2:
      add(edges(false, gauge_->finger_width), false, kLeastTouching);
      return true;
    case 3:
      add(formed_facing(cache_, stroke_, *gauge_), false, kLeastTouching);
      return true;
    case kFirstInOpenings:
      if (!openings_) return false;
      if (gauge_->nose) add(edges(true), true, 1.0);
      return true;
    case kFirstInOpenings + 1:
      add(edges(true), false, kLeastTouching);
      return true;
    default:
      return false;
  }
}

/// Where the parts leave a finger room over its width.
const std::vector<Interval>& GaugeStops::room_at(Place& place) {
  if (place.free) return *place.free;
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
  place.free = free_places(room, std::move(blocked), place.width);
  return *place.free;
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

bool GaugeStops::touch(int punch, int die) {
  for (std::size_t i = 0;; ++i) {
    while (i == places_.size())
      if (!add_next()) return false;
    if (!tool_at(places_[i], punch, die) && !room_at(places_[i]).empty()) return true;
  }
}

/// From the first finger's end to the last one's, as far as they touch, where fingers stand side by
/// side at one distance and height.
double GaugeStops::held(const Place& at, int punch, int die) {
  std::vector<Interval> free;
  Interval touched{kEverywhere.hi, kEverywhere.lo};
  for (Place& place : places_) {
    if (!stand_side_by_side(place, at) || tool_at(place, punch, die)) continue;
    for (const Interval& one : room_at(place)) {
      free.push_back(one);
      touched = {std::min(touched.lo, std::max(one.lo, place.edge.along.lo)),
                 std::max(touched.hi, std::min(one.hi, place.edge.along.hi))};
    }
  }
  free = joined(std::move(free), 0.0);
  const bool two = free.size() > 1 || length(free.front()) >= 2.0 * at.width;
  return two ? length(touched) : std::min(at.width, length(touched));
}

std::optional<GaugeStop> GaugeStops::best(int punch, int die) {
  const auto pieces = pressed_pieces(cache_, stroke_);
  const double line = pieces.back().hi - pieces.front().lo;
  std::optional<GaugeStop> best;
  for (const bool in_openings : {false, true}) {
    while (kind_ < (in_openings ? kKinds : kFirstInOpenings) && add_next()) {
    }
    for (Place& place : places_) {
      const GaugeEdge& edge = place.edge;
      if (edge.in_opening != in_openings || tool_at(place, punch, die) || room_at(place).empty())
        continue;
      const double held = this->held(place, punch, die);
      if (best && held <= best->touched + kSameEdge) continue;
      best = GaugeStop{edge.away,       edge.in_pattern, edge.height, edge.flange, edge.fold,
                       edge.in_opening, place.by_nose,   held,        line};
      if (best->is_square()) return best;
    }
    if (best) return best;
  }
  return best;
}

std::optional<GaugeStops::InTool> GaugeStops::in_tool(int punch, int die) {
  while (add_next()) {
  }
  for (Place& place : places_)
    if (const auto kind = tool_at(place, punch, die); kind && !room_at(place).empty())
      return InTool{place.edge.away, *kind};
  return std::nullopt;
}

std::optional<GaugeStop> gauge(StageCache& cache, const Setting& stroke) {
  return GaugeStops(cache, stroke).best(stroke.punch, stroke.die);
}

bool is_gauged(StageCache& cache, const Setting& stroke) {
  return GaugeStops(cache, stroke).touch(stroke.punch, stroke.die);
}

}  // namespace planish::brake_detail

namespace planish {

bool GaugeStop::is_square() const { return touched >= brake_detail::kSquare * line; }

}  // namespace planish
