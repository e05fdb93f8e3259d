// Among plans of one cost that whose gauge holds the sheet square: strokes in a row, one of which
// is held askew, are turned to the gauge by their other side. Then that whose operator holds the
// larger part: a whole row is turned where less of the sheet then lies behind the tools. What must
// hold: each can still be made with its tools and is gauged as before, and the sheet is rotated no
// more often.
#include "preferred_sides.hpp"

#include "check.hpp"
#include "gauge.hpp"

#include <algorithm>

namespace planish::brake_detail {
namespace {

class Turning {
 public:
  Turning(StageCache& cache, std::vector<StrokeChoice> strokes)
      : cache_(cache), strokes_(std::move(strokes)) {
    LineSet formed = no_lines(cache.inputs().lines());
    for (const StrokeChoice& stroke : strokes_) {
      formed_.push_back(formed);
      formed = joined(formed, stroke.lines);
      askew_.push_back(is_askew(formed_.size() - 1, stroke));
    }
  }

  std::vector<StrokeChoice> run() {
    for (std::size_t s = 0; s < strokes_.size(); ++s)
      if (askew_[s]) turn_about(s);
    return std::move(strokes_);
  }

  std::vector<StrokeChoice> run_by_size() {
    for (std::size_t from = 0, to = 0; from < strokes_.size(); from = to) {
      to = from + 1;
      while (to < strokes_.size() && strokes_[to].direction == strokes_[from].direction)
        ++to;
      const std::vector<StrokeChoice> turned = turned_about(from, to);
      double here = 0.0, there = 0.0;
      for (std::size_t s = from; s < to; ++s) {
        here += behind(s, strokes_[s]);
        there += behind(s, turned[s]);
      }
      if (there < here - kSameReach) take(turned, from, to, std::ranges::count(askew_, true));
    }
    return std::move(strokes_);
  }

 private:
  static constexpr double kSameReach = 1e-3;  // mm

  /// How far the sheet goes behind the line that is pressed.
  double behind(std::size_t s, const StrokeChoice& choice) {
    const Setting stroke = setting(cache_.inputs(), formed_[s], choice);
    double reach = 0.0;
    for (const PlacedPart* part : cache_.parts(stroke))
      if (part->left == (stroke.direction > 0))
        for (const Vec2& corner : part->hull)
          reach = std::max(reach, corner.x());
    return reach;
  }

  bool is_askew(std::size_t s, const StrokeChoice& choice) {
    const Setting stroke = setting(cache_.inputs(), formed_[s], choice);
    if (!choice.gauged || cache_.inputs().work.lines[stroke.line].closes) return false;
    const auto stop = gauge(cache_, stroke);
    return stop && !stop->is_square();
  }

  /// The shortest row about a stroke that can be turned.
  void turn_about(std::size_t s) {
    for (std::size_t length = 1; length <= strokes_.size(); ++length)
      for (std::size_t from = s + 1 < length ? 0 : s + 1 - length;
           from <= s && from + length <= strokes_.size(); ++from)
        if (turn(from, from + length)) return;
  }

  bool turn(std::size_t from, std::size_t to) {
    return take(turned_about(from, to), from, to, std::ranges::count(askew_, true) - 1);
  }

  std::vector<StrokeChoice> turned_about(std::size_t from, std::size_t to) {
    std::vector<StrokeChoice> turned = strokes_;
    for (std::size_t s = from; s < to; ++s)
      turned[s].direction = direction_number(
          cache_.inputs(),
          -cache_.inputs().directions[static_cast<std::size_t>(turned[s].direction)]);
    return turned;
  }

  /// If it can be made and rotates the sheet no more often, with at most so many held askew.
  bool take(std::vector<StrokeChoice> turned, std::size_t from, std::size_t to,
            std::ptrdiff_t most_askew) {
    if (rotations(turned) > rotations(strokes_)) return false;
    std::vector<bool> askew = askew_;
    for (std::size_t s = from; s < to; ++s) {
      if (!can_be_made(cache_, formed_[s], turned[s])) return false;
      askew[s] = is_askew(s, turned[s]);
    }
    if (std::ranges::count(askew, true) > most_askew) return false;
    strokes_ = std::move(turned);
    askew_ = std::move(askew);
    return true;
  }

  static int rotations(const std::vector<StrokeChoice>& strokes) {
    int count = 0;
    for (std::size_t s = 1; s < strokes.size(); ++s)
      count += strokes[s].direction != strokes[s - 1].direction ? 1 : 0;
    return count;
  }

  StageCache& cache_;
  std::vector<StrokeChoice> strokes_;
  std::vector<LineSet> formed_;  ///< before each
  std::vector<bool> askew_;      ///< gauged, and not held square
};

}  // namespace

std::vector<StrokeChoice> with_square_gauges(StageCache& cache, std::vector<StrokeChoice> strokes) {
  return Turning(cache, std::move(strokes)).run();
}

std::vector<StrokeChoice> with_little_behind(StageCache& cache, std::vector<StrokeChoice> strokes) {
  return Turning(cache, std::move(strokes)).run_by_size();
}

}  // namespace planish::brake_detail
