// What a design asks of neighbours (math.md#strip-contact). Three strips lie evenly if the second
// difference of their places vanishes; a few ridges say so for all, and so couple strips by few
// columns, which keeps Newton's steps linear in the strips.
#include "coupling.hpp"

#include <algorithm>
#include <cstddef>

namespace planish::slit_detail {
namespace {

constexpr int kMostStations = 8;
constexpr double kThirtieth = 1.0 / 30.0;  // of a strip's length: the unit of places

StripPoint middle(int strip, int ridge) { return {strip, {{0, ridge, 0.5}, {1, ridge, 0.5}}}; }

struct Gap {
  Vec3 from_left = Vec3::Zero(), across = Vec3::Zero();
};
Gap gap_of(const FoldedStrip& left, const FoldedStrip& right) {
  const auto &a = left.ridges.back().folded, &b = right.ridges.back().folded;
  return {b[0] - a[1], (a[1] - a[0] + b[1] - b[0]).normalized()};
}

/// Strips that overlap are led apart across them.
Vec3 across_gap(const Gap& gap) {
  const bool is_open = gap.from_left.dot(gap.across) > 0.0;
  return is_open ? Vec3(gap.from_left.normalized()) : gap.across;
}

}  // namespace

std::vector<Bond> bonds_of(const std::vector<StripProblem>& strips, double weight) {
  std::vector<Bond> bonds;
  if (weight == 0.0 || strips.empty()) return bonds;
  double length = 0.0;
  for (const StripProblem& problem : strips)
    length += problem.base.unit() / static_cast<double>(strips.size());
  const int quads = strips.front().base.quads, stations = std::min(kMostStations, quads);
  const double unit = kThirtieth * length;
  for (int strip = 0; strip + 2 < std::ssize(strips); ++strip)
    for (int station = 1; station <= stations; ++station) {
      const int ridge = station * quads / stations;
      bonds.push_back({{middle(strip, ridge), middle(strip + 1, ridge), middle(strip + 2, ridge)},
                       weight / (unit * unit * stations)});
    }
  return bonds;
}

std::vector<Contact> kept_gap(int left, int right, const FoldedStrip& of_left,
                              const FoldedStrip& of_right, const std::array<double, 2>& gap) {
  const Gap now = gap_of(of_left, of_right);
  const Vec3 direction = across_gap(now);
  const int last = static_cast<int>(of_left.quads.size());
  const StripPoint here{right, {{0, last, 1.0}}}, there{left, {{1, last, 1.0}}};
  std::vector<Contact> kept{{here, there, -direction, -gap[1], 0.0, GapLimit::most}};
  // Across both: the way from corner to corner turns round where one slips over the other, and with
  // it what would be kept.
  if (gap[0] > 0.0) kept.push_back({here, there, now.across, gap[0], 0.0, GapLimit::least});
  return kept;
}

std::array<double, 2> on_the_way(const std::array<double, 2>& gap, double now, double share) {
  return {std::min(gap[0], now + share * (gap[0] - now)),
          std::max(gap[1], now + share * (gap[1] - now))};
}

double gap_missed(const std::vector<FoldedStrip>& strips, const std::array<double, 2>& gap) {
  double most = 0.0;
  for (std::size_t left = 0; left + 1 < strips.size(); ++left) {
    const double found = gap_between(strips[left], strips[left + 1]);
    most = std::max({most, gap[0] - found, found - gap[1]});
  }
  return most;
}

}  // namespace planish::slit_detail

namespace planish {

double gap_between(const FoldedStrip& left, const FoldedStrip& right) {
  const auto gap = slit_detail::gap_of(left, right);
  return slit_detail::across_gap(gap).dot(gap.from_left);
}

}  // namespace planish
