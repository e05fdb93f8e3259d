// Rows of segments. The sums that segments add up to are listed once, each with its fewest
// segments (subset sums by rounded length); a row is the shortest sum that presses its stretch and
// has room, and where walls part the line the rest of the segments fill the next stretch. What
// must hold: every segment stands once (math.md#tool-segments).
#include "segments.hpp"

#include "tool_shape.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

namespace planish::brake_detail {
namespace {

constexpr std::size_t kMostSums = 200'000;
constexpr std::size_t kMostSegments = 64;

/// What a row must press, and where it may stand.
struct Stretch {
  Interval pressed;
  Interval room;
};

long long rounded(double length) { return std::llround(length / kSameLength); }

/// Stretches between what blocks, each with the pieces that lie there; empty if a piece cannot be
/// pressed.
std::vector<Stretch> stretches_of(const RowRequest& request) {
  constexpr double kFar = 1e9;  // mm
  std::vector<Interval> rooms;
  double from = -kFar;
  for (const Interval& blocked : request.blocked) {
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

double start_of_row(const Stretch& stretch, double length) {
  const auto& [pressed, room] = stretch;
  const double middle = 0.5 * (pressed.lo + pressed.hi - length);
  const double lo = std::max(room.lo, pressed.hi - length),
               hi = std::min(room.hi - length, pressed.lo);
  return std::clamp(middle, lo, std::max(lo, hi));
}

/// Fills the stretches from `rows.size()` on with what is left of the segments.
bool fill(const SegmentSums& left, const std::vector<Stretch>& stretches, SegmentSums::Chosen used,
          std::vector<ToolRow>& rows) {
  const Stretch& stretch = stretches[rows.size()];
  const double least = stretch.pressed.hi - stretch.pressed.lo - 0.5 * kSameLength,
               most = stretch.room.hi - stretch.room.lo + 0.5 * kSameLength;
  const auto& sums = left.sums();
  auto at = std::ranges::lower_bound(sums, least, {}, &SegmentSums::Sum::length);
  for (; at != sums.end() && at->length <= most; ++at) {
    rows.push_back({start_of_row(stretch, at->length), left.chosen(at->chosen)});
    if (rows.size() == stretches.size()) return true;
    const SegmentSums::Chosen taken = used | at->chosen;
    if (fill(SegmentSums(left.segments(), taken), stretches, taken, rows)) return true;
    rows.pop_back();
  }
  return false;
}

}  // namespace

Interval covered(const Interval& piece, double shortfall) {
  const double middle = 0.5 * (piece.lo + piece.hi);
  return {std::min(piece.lo + shortfall, middle), std::max(piece.hi - shortfall, middle)};
}

double ToolRow::length() const { return std::accumulate(segments.begin(), segments.end(), 0.0); }

SegmentSums::SegmentSums(const std::vector<double>& segments, Chosen used) : segments_(segments) {
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

std::vector<ToolRow> tool_rows(const SegmentSums& segments, const RowRequest& request) {
  const std::vector<Stretch> stretches = stretches_of(request);
  std::vector<ToolRow> rows;
  if (stretches.empty() || !fill(segments, stretches, 0, rows)) return {};
  const double length = rows.back().from + rows.back().length() - rows.front().from;
  if (length > request.longest + kSameLength) return {};
  return rows;
}

}  // namespace planish::brake_detail
