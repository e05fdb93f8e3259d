// Rows of segments. The sums that segments add up to are listed once, each with its fewest
// segments (subset sums by rounded length); a row is the shortest sum that presses its stretch and
// has room, and where walls part the line the rest of the segments fill the next stretch. What
// must hold: every segment stands once, and where a row ends in an ear only its foot is beside what
// the body would hit (math.md#tool-segments).
#include "segments.hpp"

#include "tool_shape.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <tuple>

namespace planish::brake_detail {
namespace {

constexpr std::size_t kMostSums = 200'000;
constexpr std::size_t kMostSegments = 64;
constexpr double kFar = 1e9;           // mm
constexpr double kClearOfWalls = 5.0;  // mm: nobody sets tools nearer if there is room

/// What a row must press, and where it may stand.
struct Stretch {
  Interval pressed;
  Interval room;
};

long long rounded(double length) { return std::llround(length / kSameLength); }

/// Where the ends of a row with these ears may not be: at a wall beside the outer ends it is the
/// body that keeps away, not the foot.
std::vector<Interval> blocked_with(const RowRequest& request, const RowEars& ears) {
  if (!ears.any()) return request.blocked;
  const Interval &first = request.pieces.front(), &last = request.pieces.back();
  std::vector<Interval> blocked = request.blocked_foot;
  for (Interval wall : request.blocked) {
    const bool before = wall.lo + wall.hi < first.lo + last.hi;
    if (before && ears.lo > 0.0 && wall.lo < first.hi - kPenetration) {
      wall.hi -= ears.reach;
      wall.lo = std::min(wall.lo, wall.hi);
    } else if (!before && ears.hi > 0.0 && wall.hi > last.lo + kPenetration) {
      wall.lo += ears.reach;
      wall.hi = std::max(wall.lo, wall.hi);
    }
    blocked.push_back(wall);
  }
  return joined(std::move(blocked), 0.0);
}

/// Stretches between what blocks, each with the pieces that lie there; empty if a piece cannot be
/// pressed.
std::vector<Stretch> stretches_of(const RowRequest& request, const RowEars& ears) {
  std::vector<Interval> rooms;
  double from = -kFar;
  for (const Interval& blocked : blocked_with(request, ears)) {
    // A tool may stand in a wall as deep as anything may.
    rooms.push_back({from, blocked.lo + kPenetration});
    from = blocked.hi - kPenetration;
  }
  rooms.push_back({from, kFar});
  std::vector<Stretch> stretches;
  size_t room = 0;
  for (const Interval& piece : request.pieces) {
    const Interval pressed = covered(piece, request.shortfall);
    while (room < rooms.size() && rooms[room].hi < pressed.hi)
      ++room;
    if (room == rooms.size() || rooms[room].lo > pressed.lo) return {};
    const bool goes_on = !stretches.empty() && stretches.back().room.lo == rooms[room].lo;
    if (goes_on)
      stretches.back().pressed.hi = pressed.hi;
    else
      stretches.push_back({pressed, rooms[room]});
  }
  return stretches;
}

/// In the middle of what is pressed, as far as it stays clear of what blocks; with less room than
/// that, as far from there as it can. To a whole millimetre where that goes: rows are laid by a
/// rule.
double start_of_row(const Stretch& stretch, double length) {
  const auto& [pressed, room] = stretch;
  const double least = pressed.hi - length, most = pressed.lo;  // so that it is pressed
  Interval range{std::max(room.lo + kClearOfWalls, least),
                 std::min(room.hi - kClearOfWalls - length, most)};
  double start = 0.5 * (pressed.lo + pressed.hi - length);
  if (range.lo > range.hi) {
    range = {std::max(room.lo, least), std::min(room.hi - length, most)};
    start = 0.5 * (room.lo + room.hi - length);
  }
  start = std::clamp(start, range.lo, std::max(range.lo, range.hi));
  const double whole = std::round(start);
  return whole >= range.lo && whole <= range.hi ? whole : start;
}

/// Fills stretches with segments, the outer ends with ears.
class Filling {
 public:
  Filling(std::vector<Stretch> stretches, const RowEars& ears)
      : stretches_(std::move(stretches)), ears_(ears) {}

  std::vector<ToolRow> rows(const SegmentSums& segments) {
    fill(segments);
    return std::move(rows_);
  }

 private:
  /// Fills those from `rows_.size()` on with what is left of the segments.
  bool fill(const SegmentSums& left) {
    const Stretch& stretch = stretches_[rows_.size()];
    const RowEars ears = ears_here();
    const double least = stretch.pressed.hi - stretch.pressed.lo - 0.5 * kSameLength - ears.lo -
                         ears.hi;
    const double most = stretch.room.hi - stretch.room.lo + 0.5 * kSameLength - ears.lo - ears.hi;
    if (ears.any() && least <= 0.0 && most >= 0.0 && goes_on(left, {}, ears)) return true;
    const auto& sums = left.sums();
    auto at = std::ranges::lower_bound(sums, least, {}, &SegmentSums::Sum::length);
    for (; at != sums.end() && at->length <= most; ++at)
      if (goes_on(left, *at, ears)) return true;
    return false;
  }

  /// Takes a sum of segments for the next stretch, then fills the others.
  bool goes_on(const SegmentSums& left, const SegmentSums::Sum& sum, const RowEars& ears) {
    std::vector<double> segments = left.chosen(sum.chosen);
    if (ears.lo > 0.0) segments.insert(segments.begin(), ears.lo);
    if (ears.hi > 0.0) segments.push_back(ears.hi);
    const double length = ears.lo + sum.length + ears.hi;
    rows_.push_back({start_of_row(stretches_[rows_.size()], length), std::move(segments), ears});
    if (rows_.size() == stretches_.size()) return true;
    if (fill(SegmentSums(left.segments(), left.used() | sum.chosen))) return true;
    rows_.pop_back();
    return false;
  }

  RowEars ears_here() const {
    const bool first = rows_.empty(), last = rows_.size() + 1 == stretches_.size();
    return {first ? ears_.lo : 0.0, last ? ears_.hi : 0.0, ears_.reach};
  }

  std::vector<Stretch> stretches_;
  RowEars ears_;
  std::vector<ToolRow> rows_;
};

/// Whether the ears can be taken from below what is above their feet: once the segments between
/// are out they are pushed together.
bool come_free(const std::vector<ToolRow>& rows, const RowRequest& request) {
  const double middle = request.pieces.front().lo + request.pieces.back().hi;
  Interval free{-kFar, kFar};
  for (const Interval& wall : request.blocked)
    if (wall.lo + wall.hi < middle)
      free.lo = std::max(free.lo, wall.hi);
    else
      free.hi = std::min(free.hi, wall.lo);
  const RowEars first = rows.front().ears, last = rows.back().ears;
  double caught = 0.0;
  if (first.lo > 0.0 && free.lo > rows.front().from + kPenetration) caught += first.lo;
  if (last.hi > 0.0 && free.hi < extent(rows.back()).hi - kPenetration) caught += last.hi;
  return caught == 0.0 || free.hi - free.lo >= caught - kSameLength;
}

/// The same, seen from the other side.
RowRequest turned(RowRequest request) {
  for (std::vector<Interval>* along : {&request.pieces, &request.blocked, &request.blocked_foot}) {
    std::ranges::reverse(*along);
    for (Interval& one : *along)
      one = {-one.hi, -one.lo};
  }
  request.ears = request.ears.turned();
  request.from_last = !request.from_last;
  return request;
}

/// None first, then as few as there can be.
std::vector<RowEars> choices_of(const RowEars& ears) {
  const auto& [lo, hi, reach] = ears;
  std::vector<RowEars> choices{{}};
  if (lo > 0.0) choices.push_back({lo, 0.0, reach});
  if (hi > 0.0) choices.push_back({0.0, hi, reach});
  if (lo > 0.0 && hi > 0.0) choices.push_back(ears);
  return choices;
}

/// By which rows are preferred: with few ears, unless the shortest are wanted, then how long they
/// are together, and of how many segments.
std::tuple<int, long long, std::size_t> size_of(const std::vector<ToolRow>& rows, bool shortest) {
  int ears = 0;
  double length = 0.0;
  std::size_t count = 0;
  for (const ToolRow& row : rows) {
    ears += row.ears.count();
    length += row.length();
    count += row.segments.size();
  }
  return {shortest ? 0 : ears, rounded(length), count};
}

}  // namespace

Interval covered(const Interval& piece, double shortfall) {
  const double middle = 0.5 * (piece.lo + piece.hi);
  return {std::min(piece.lo + shortfall, middle), std::max(piece.hi - shortfall, middle)};
}

std::vector<double> ToolRow::plain() const {
  return {segments.begin() + (ears.lo > 0.0 ? 1 : 0), segments.end() - (ears.hi > 0.0 ? 1 : 0)};
}

ToolRow turned(ToolRow row) {
  std::ranges::reverse(row.segments);
  row.ears = row.ears.turned();
  return row;
}

SegmentRow row_of(const ToolRow& row, double from) {
  const auto& [lo, hi, reach] = row.ears;
  return {from, row.segments, lo > 0.0 ? reach : 0.0, hi > 0.0 ? reach : 0.0};
}

Interval extent(const ToolRow& row) { return {row.from, row.from + row.length()}; }

Interval stood_back(const Interval& feet, const RowEars& ears) {
  return {ears.lo > 0.0 ? feet.lo + ears.reach : feet.lo,
          ears.hi > 0.0 ? feet.hi - ears.reach : feet.hi};
}

Interval body(const ToolRow& row) { return stood_back(extent(row), row.ears); }

double ToolRow::length() const { return std::accumulate(segments.begin(), segments.end(), 0.0); }

SegmentSums::SegmentSums(const std::vector<double>& segments, Chosen used)
    : segments_(segments), used_(used) {
  std::ranges::stable_sort(segments_, std::greater<>());
  segments_.resize(std::min(segments_.size(), kMostSegments));
  std::map<long long, Chosen> ways{{0, 0}};  // by rounded length
  for (size_t i = 0; i < segments_.size() && ways.size() < kMostSums; ++i) {
    if (used >> i & 1U) continue;
    const std::map<long long, Chosen> shorter = ways;
    for (const auto& [length, chosen] : shorter) {
      const Chosen more = chosen | Chosen{1} << i;
      const auto [at, added] = ways.try_emplace(length + rounded(segments_[i]), more);
      if (!added && std::popcount(more) < std::popcount(at->second)) at->second = more;
    }
  }
  for (const auto& [length, chosen] : ways)
    if (chosen != 0) sums_.push_back({static_cast<double>(length) * kSameLength, chosen});
}

std::vector<double> SegmentSums::chosen(Chosen chosen) const {
  std::vector<double> lengths;
  for (size_t i = 0; i < segments_.size(); ++i)
    if (chosen >> i & 1U) lengths.push_back(segments_[i]);
  return lengths;
}

bool has_room(const RowRequest& request) {
  return std::ranges::any_of(choices_of(request.ears), [&](const RowEars& ears) {
    const std::vector<Stretch> stretches = stretches_of(request, ears);
    if (stretches.empty()) return false;
    const Interval &first = stretches.front().room, &last = stretches.back().room;
    return first.hi - first.lo >= ears.lo + (stretches.size() == 1 ? ears.hi : 0.0) &&
           last.hi - last.lo >= ears.hi;
  });
}

std::vector<ToolRow> tool_rows(const SegmentSums& segments, const RowRequest& request) {
  if (request.from_last) {
    std::vector<ToolRow> rows = tool_rows(segments, turned(request));
    std::ranges::reverse(rows);
    for (ToolRow& row : rows) {
      row.from = -extent(row).hi;
      row = turned(std::move(row));
    }
    return rows;
  }
  std::vector<ToolRow> best;
  for (const RowEars& ears : choices_of(request.ears)) {
    std::vector<Stretch> stretches = stretches_of(request, ears);
    if (stretches.empty()) continue;
    std::vector<ToolRow> rows = Filling(std::move(stretches), ears).rows(segments);
    if (rows.empty() || !come_free(rows, request)) continue;
    if (extent(rows.back()).hi - rows.front().from > request.longest + kSameLength) continue;
    if (best.empty() || size_of(rows, request.shortest) < size_of(best, request.shortest))
      best = std::move(rows);
  }
  return best;
}

}  // namespace planish::brake_detail

namespace planish {

double end_of(const SegmentRow& row) {
  return std::accumulate(row.segments.begin(), row.segments.end(), row.from);
}

std::string text_of(const SegmentRow& row, const std::function<std::string(double)>& length) {
  std::string text;
  for (std::size_t i = 0; i < row.segments.size(); ++i) {
    const bool left = i == 0 && row.left_ear > 0.0,
               right = i + 1 == row.segments.size() && row.right_ear > 0.0;
    text += i == 0 ? "" : " + ";
    text += left ? "left ear " : right ? "right ear " : "";
    text += length(row.segments[i]);
  }
  return text;
}

}  // namespace planish
