#include "segments.hpp"

#include "tool_shape.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>

namespace planish::brake_detail {
namespace {

constexpr double kSameLength = 1e-3;  // mm: sums of segments that are one length
constexpr std::size_t kMostSums = 200'000;

/// What a row must press, and where it may stand.
struct Stretch {
  Interval pressed;
  Interval room;
};

/// For each length that segments add up to, one way to do it: as few segments as possible, by
/// their positions.
using Sums = std::map<long long, std::vector<int>>;

long long rounded(double length) { return std::llround(length / kSameLength); }

Sums sums_of(const std::vector<double>& segments, const std::vector<bool>& used) {
  Sums sums{{0, {}}};
  for (int i = 0; i < std::ssize(segments); ++i) {
    if (used[i] || sums.size() > kMostSums) continue;
    Sums longer;
    for (const auto& [length, taken] : sums) {
      std::vector<int> more = taken;
      more.push_back(i);
      longer.emplace(length + rounded(segments[i]), std::move(more));
    }
    for (auto& [length, taken] : longer) {
      const auto [at, added] = sums.try_emplace(length, taken);
      if (!added && taken.size() < at->second.size()) at->second = std::move(taken);
    }
  }
  sums.erase(0);
  return sums;
}

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
    const double middle = 0.5 * (piece.lo + piece.hi);
    const Interval pressed{std::min(piece.lo + request.shortfall, middle),
                           std::max(piece.hi - request.shortfall, middle)};
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

bool fill(const std::vector<double>& segments, const std::vector<Stretch>& stretches,
          std::vector<bool>& used, std::vector<ToolRow>& rows) {
  if (rows.size() == stretches.size()) return true;
  const auto& [pressed, room] = stretches[rows.size()];
  const Sums sums = sums_of(segments, used);
  const long long least = rounded(pressed.hi - pressed.lo), most = rounded(room.hi - room.lo);
  for (auto at = sums.lower_bound(std::max(least, 1LL)); at != sums.end(); ++at) {
    if (at->first > most) return false;
    ToolRow row;
    for (const int i : at->second) {
      used[i] = true;
      row.segments.push_back(segments[i]);
    }
    row.from = start_of_row(stretches[rows.size()], row.length());
    rows.push_back(std::move(row));
    if (fill(segments, stretches, used, rows)) return true;
    rows.pop_back();
    for (const int i : at->second)
      used[i] = false;
  }
  return false;
}

}  // namespace

double ToolRow::length() const {
  return std::accumulate(segments.begin(), segments.end(), 0.0);
}

std::vector<ToolRow> tool_rows(const std::vector<double>& segments, const RowRequest& request) {
  const std::vector<Stretch> stretches = stretches_of(request);
  if (stretches.empty()) return {};
  std::vector<bool> used(segments.size());
  std::vector<ToolRow> rows;
  if (!fill(segments, stretches, used, rows)) return {};
  const double length = rows.back().from + rows.back().length() - rows.front().from;
  if (length > request.longest + kSameLength) return {};
  return rows;
}

}  // namespace planish::brake_detail
