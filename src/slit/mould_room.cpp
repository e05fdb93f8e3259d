#include "mould_room.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

// Where a strip lies over another, its rib would come up through that one: it is cut off beside it,
// as far from the other's edge as ribs are from their own. A strip is straight across, so what is
// left of a rib carries it as exactly as the whole. What is to be cut off is measured as a share of
// the width, on the facet as seen from above; the side that leaves more is kept. A rib has one
// width at a ridge, the smaller of both quads', so it tapers from quad to quad, and ends where too
// little is left: there the strip lies on the other one or hangs free.

namespace planish::slit_detail {
namespace {

constexpr std::array<double, 2> kAll{1.0, 1.0};

double rest_of(const std::array<double, 2>& left) { return 1.0 - left[0] - left[1]; }

/// A quad of the skin towards the mould, seen from above: the ridge on its near side and on its far
/// one, each from left to right.
struct Across {
  Vec2 near_left, near_right, far_left, far_right;

  /// Where between left (0) and right (1) a point lies: on the line from `near` to `far` at this
  /// share of both, the zero of a polynomial of degree 2, by Newton's method from the middle.
  double share(const Vec2& p) const {
    const Vec2 near = near_right - near_left, far = far_right - far_left,
               along = far_left - near_left;
    double s = 0.5;
    constexpr int kSteps = 20;
    for (int i = 0; i < kSteps; ++i) {
      const Vec2 from = p - near_left - s * near, line = along + s * (far - near);
      const double value = planish::cross(from, line),
                   slope = planish::cross(from, Vec2(far - near)) - planish::cross(near, line);
      if (slope == 0.0) break;
      s -= value / slope;
    }
    return std::clamp(s, 0.0, 1.0);
  }
};

Across seen_across(const WholeStrip& strip, int quad, const Frame& plan, double offset) {
  const auto near = skin_ridge(strip, quad, offset), far = skin_ridge(strip, quad + 1, offset);
  return {plan.local2(near[0]), plan.local2(near[1]), plan.local2(far[0]), plan.local2(far[1])};
}

WholeStrip* part_of(std::vector<WholeStrip>& parts, int quad) {
  for (WholeStrip& part : parts)
    if (quad >= part.first && quad - part.first < std::ssize(part.towards_mould)) return &part;
  return nullptr;
}

/// The widest part of the width that none of these parts of it takes.
std::array<double, 2> around_widest_gap(std::vector<std::array<double, 2>> taken) {
  std::ranges::sort(taken);
  taken.push_back({1.0, 1.0});
  double from = 0.0;
  std::array<double, 2> left = kAll;
  for (const auto& [low, high] : taken) {
    if (low - from > rest_of(left)) left = {from, 1.0 - low};
    from = std::max(from, high);
  }
  return left;
}

/// Leaves quads without a rib that would be too narrow; of two that leave room on different sides,
/// and so at the ridge between them, the narrower. The narrowest goes first, with all that are as
/// narrow, so that a mirrored strip has mirrored ribs.
void drop_narrow(WholeStrip& strip) {
  auto& left = strip.left_to_others;
  for (auto& quad : left)
    if (rest_of(quad) < kNarrowestRib) quad = kAll;
  for (;;) {
    std::vector<std::size_t> narrow;
    for (std::size_t i = 0; i + 1 < left.size(); ++i)
      if (left[i] != kAll && left[i + 1] != kAll &&
          1.0 - std::max(left[i][0], left[i + 1][0]) - std::max(left[i][1], left[i + 1][1]) <
              kNarrowestRib)
        narrow.insert(narrow.end(), {i, i + 1});
    if (narrow.empty()) return;
    double least = 1.0;
    for (const std::size_t i : narrow)
      least = std::min(least, rest_of(left[i]));
    constexpr double kAlike = 1e-6;
    for (const std::size_t i : narrow)
      if (rest_of(left[i]) <= least + kAlike) left[i] = kAll;
  }
}

}  // namespace

bool has_rib(const WholeStrip& strip, int quad) {
  return strip.left_to_others.empty() || strip.left_to_others[quad] != kAll;
}

std::array<double, 2> left_at(const WholeStrip& strip, int first, int last, int at) {
  std::array<double, 2> left{0.0, 0.0};
  if (strip.left_to_others.empty()) return left;
  for (int quad = std::max(first, at - 1); quad <= std::min(last, at); ++quad)
    for (std::size_t side = 0; side < 2; ++side)
      left[side] = std::max(left[side], strip.left_to_others[quad][side]);
  return left;
}

void make_room(std::vector<std::vector<WholeStrip>>& strips, const std::vector<RibThrough>& through,
               const Frame& plan, double offset, double clearance) {
  std::map<std::pair<WholeStrip*, int>, std::vector<std::array<double, 2>>> taken;
  for (const RibThrough& one : through) {
    WholeStrip* const strip = part_of(strips[one.rib.strip], one.rib.quad);
    if (!strip) continue;
    const int quad = one.rib.quad - strip->first;
    const Across across = seen_across(*strip, quad, plan, offset);
    const double width = std::min((across.near_right - across.near_left).norm(),
                                  (across.far_right - across.far_left).norm());
    double low = 1.0, high = 0.0;
    for (const Vec2& p : one.around) {
      const double share = across.share(p);
      low = std::min(low, share), high = std::max(high, share);
    }
    taken[{strip, quad}].push_back({low - clearance / width, high + clearance / width});
  }
  for (auto& [where, parts] : taken) {
    auto& left = where.first->left_to_others;
    left.resize(where.first->towards_mould.size(), {0.0, 0.0});
    auto& own = left[where.second];
    parts.insert(parts.end(), {{0.0, own[0]}, {1.0 - own[1], 1.0}});
    own = around_widest_gap(std::move(parts));
  }
  for (auto& parts : strips)
    for (WholeStrip& strip : parts)
      drop_narrow(strip);
}

}  // namespace planish::slit_detail
