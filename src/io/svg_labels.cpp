#include "svg_labels.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/box_tree.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/geometry/region.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <ranges>

// Where texts go. Each has a list of places, the best first, and takes the one that meets the
// fewest labels and lines; its rank decides between equals, and the letters become smaller only
// where every place meets something. Labels of points share one size: the largest at which all find
// room, or with which most do. Boxes are clipped in their own axes, and found by a tree of boxes.

namespace planish::io_detail {
namespace {

using std::numbers::pi;

constexpr double kBoxHeight = 1.05;   // of a line of text, in heights of the font
constexpr double kClearance = 0.8;    // from a line to the middle of the text beside it
constexpr double kWidestStrip = 2.5;  // text goes inside a bend zone wider than this
constexpr double kSmallest = 0.55;    // letters may shrink to this share to fit

Vec2 half_size(const PlacedLabel& label) {
  return 0.5 * Vec2(text_width(label.text, label.font), kBoxHeight * label.font);
}

/// Whether the segment enters the label's box (clipping in the box's own axes).
bool meets(const PlacedLabel& label, const Segment& segment) {
  const Eigen::Rotation2Dd back(-label.angle);
  const Vec2 a = back * (segment.a - label.center);
  const Vec2 d = back * (segment.b - label.center) - a;
  const Vec2 half = half_size(label);
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0.0) {
      if (std::abs(a[axis]) > half[axis]) return false;
      continue;
    }
    const double t0 = (-half[axis] - a[axis]) / d[axis];
    const double t1 = (half[axis] - a[axis]) / d[axis];
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return enter < leave;
}

bool meets(const PlacedLabel& label, const PlacedLabel& other) {
  const std::vector<Vec2> c = corners(other);
  // The middle line too: a box wholly inside the other has no side that crosses it.
  return meets(label, Segment{c[0], c[1]}) || meets(label, Segment{c[1], c[2]}) ||
         meets(label, Segment{c[2], c[3]}) || meets(label, Segment{c[3], c[0]}) ||
         meets(label, Segment{c[0], c[2]});
}

/// The lines that labels keep off.
class Lines {
 public:
  explicit Lines(const std::vector<Segment>& lines) : lines_(lines), tree_(boxes(lines)) {}

  /// How many of them enter the label's box.
  std::size_t met_by(const PlacedLabel& label) const {
    std::size_t met = 0;
    tree_.visit(box_of(corners(label)),
                [&](std::size_t i) { met += meets(label, lines_[i]) ? 1 : 0; });
    return met;
  }

 private:
  static std::vector<Box2> boxes(const std::vector<Segment>& lines) {
    return mapped(lines, [&](const Segment& line) { return bounds(line); });
  }

  const std::vector<Segment>& lines_;
  BoxTree2 tree_;
};

/// The labels that have a place.
class Placed {
 public:
  void add(PlacedLabel label) {
    boxes_.push_back(box_of(corners(label)));
    labels_.push_back(std::move(label));
  }

  /// How many of them the label would cover.
  std::size_t met_by(const PlacedLabel& label) const {
    const Box2 box = box_of(corners(label));
    std::size_t met = 0;
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      met += boxes_[i].overlaps(box) && meets(label, labels_[i]) ? 1 : 0;
    return met;
  }

  const std::vector<PlacedLabel>& labels() const { return labels_; }

 private:
  std::vector<PlacedLabel> labels_;
  std::vector<Box2> boxes_;
};

double cost(const PlacedLabel& label, const Placed& placed, const Lines& lines) {
  return 50.0 * static_cast<double>(placed.met_by(label)) +
         10.0 * std::min(static_cast<double>(lines.met_by(label)), 4.0);
}

/// Direction of the line, such that text along it reads from below or from the right.
double reading_angle(const Segment& line) {
  const Vec2 d = line.b - line.a;
  double angle = std::atan2(d.y(), d.x());
  // Upright lines drawn either way are labelled the same, despite rounding.
  constexpr double kUpright = 0.5 * pi + tolerance::kAside;
  if (angle > kUpright) angle -= pi;
  if (angle <= kUpright - pi) angle += pi;
  return angle;
}

std::vector<PlacedLabel> along(const LabelRequest& request, double font) {
  const double length = (request.line.b - request.line.a).norm();
  const double room = 1.0 - text_width(request.text, font) / length;
  const double angle = reading_angle(request.line);
  const double strip = request.clearance < kWidestStrip * font ? request.clearance : 0.0;
  const Vec2 up = Eigen::Rotation2Dd(angle) * Vec2(0.0, strip + kClearance * font);
  std::vector<PlacedLabel> places;
  if (room < 0.0) return places;
  for (const double share : {0.0, -0.4, 0.4, -0.8, 0.8}) {
    const double t = 0.5 + 0.5 * share * room;
    const Vec2 at = request.line.a + t * (request.line.b - request.line.a);
    places.push_back({request.text, at + up, angle, font, {}});
    places.push_back({request.text, at - up, angle, font, {}});
  }
  return places;
}

/// Level text on all sides of a line too short to write along.
std::vector<PlacedLabel> beside(const LabelRequest& request, double font) {
  const Vec2 middle = 0.5 * (request.line.a + request.line.b);
  const Vec2 half = 0.5 * Vec2(text_width(request.text, font), kBoxHeight * font);
  const Vec2 reach = 0.5 * (request.line.b - request.line.a).cwiseAbs() + half +
                     Vec2(0.5 * font, 0.4 * font);
  std::vector<PlacedLabel> places;
  for (const double away : {1.0, 1.5, 2.2}) {
    for (const Vec2& side : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1), Vec2(1, 1),
                             Vec2(1, -1), Vec2(-1, 1), Vec2(-1, -1)}) {
      const Vec2 center = middle + away * side.cwiseProduct(reach);
      const Vec2 near = center + (middle - center).cwiseMax(-half).cwiseMin(half);
      places.push_back({request.text, center, 0.0, font, Segment{middle, near}});
    }
  }
  return places;
}

/// The places around a point, as near as the text may come in each direction, and a little farther.
std::vector<PlacedLabel> round_point(const PointRequest& request, double font) {
  constexpr int kDirections = 32;
  const Vec2 half = 0.5 * Vec2(text_width(request.text, font), kBoxHeight * font);
  std::vector<PlacedLabel> places;
  for (int i = 0; i < kDirections; ++i) {
    const double turn = 2.0 * pi * i / kDirections;
    const Vec2 direction(std::cos(turn), std::sin(turn));
    const double reach = half.cwiseQuotient(direction.cwiseAbs().cwiseMax(tolerance::kComputed))
                             .minCoeff();
    places.push_back({request.text, request.at + (reach + 0.3 * font) * direction, 0.0, font, {}});
  }
  return places;
}

/// All labels, in one size, for which there is a place.
std::vector<PlacedLabel> beside_points(const std::vector<PointRequest>& requests,
                                       const std::vector<std::vector<Vec2>>& rings,
                                       const Lines& lines, double font) {
  Placed placed;
  for (const PointRequest& request : requests) {
    auto places = round_point(request, font);
    const auto within = [&](const PlacedLabel& label) { return inside(rings, label.center); };
    std::ranges::stable_partition(places, std::not_fn(within));
    const auto place = std::ranges::find_if(places, [&](const PlacedLabel& label) {
      return lines.met_by(label) == 0 && placed.met_by(label) == 0;
    });
    if (place != places.end()) placed.add(*place);
  }
  return placed.labels();
}

PlacedLabel place(const LabelRequest& request, const Placed& placed, const Lines& lines,
                  double font) {
  std::vector<PlacedLabel> places;
  for (double size = font; size > kSmallest * font; size *= 0.85) {
    std::ranges::copy(along(request, size), std::back_inserter(places));
  }
  std::ranges::copy(beside(request, font), std::back_inserter(places));
  std::ranges::copy(beside(request, 0.7 * font), std::back_inserter(places));
  // Earlier places are better: a small cost by rank decides between equals.
  double best_cost = std::numeric_limits<double>::infinity();
  PlacedLabel best;
  for (std::size_t rank = 0; rank < places.size() && best_cost > static_cast<double>(rank) * 0.1;
       ++rank) {
    const double c = cost(places[rank], placed, lines) + 0.1 * static_cast<double>(rank);
    if (c >= best_cost) continue;
    best_cost = c;
    best = places[rank];
  }
  return best;
}

}  // namespace

double text_width(const std::string& text, double font) {
  const auto letters = std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return 0.58 * font * static_cast<double>(letters);
}

std::vector<Vec2> corners(const PlacedLabel& label) {
  const Vec2 half = half_size(label);
  const Eigen::Rotation2Dd turn(label.angle);
  std::vector<Vec2> result;
  for (const Vec2& sign : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
    result.emplace_back(label.center + turn * sign.cwiseProduct(half));
  }
  return result;
}

std::vector<PlacedLabel> place_labels(const std::vector<LabelRequest>& requests,
                                      const std::vector<Segment>& obstacles, double font,
                                      const std::vector<PlacedLabel>& there) {
  const Lines lines(obstacles);
  Placed placed;
  std::ranges::for_each(there, [&](const PlacedLabel& label) { placed.add(label); });
  for (const LabelRequest& request : requests)
    placed.add(place(request, placed, lines, font));
  const auto made = placed.labels().begin() + static_cast<std::ptrdiff_t>(there.size());
  return {made, placed.labels().end()};
}

std::vector<PlacedLabel> place_point_labels(const std::vector<PointRequest>& requests,
                                            const std::vector<std::vector<Vec2>>& rings,
                                            const std::vector<Segment>& obstacles, double font) {
  const Lines lines(obstacles);
  std::vector<PlacedLabel> best;
  for (double size = font; size > kSmallest * font && best.size() < requests.size(); size *= 0.85) {
    auto placed = beside_points(requests, rings, lines, size);
    if (placed.size() > best.size()) best = std::move(placed);
  }
  return best;
}

}  // namespace planish::io_detail
