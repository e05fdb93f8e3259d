#include "run_envelope.hpp"

#include <algorithm>

// The extreme corner of any range of a chain in a direction (k, −1), asked for at every step of the
// search. Blocks of sizes 2ⁿ keep their convex hulls; a range is made of few whole blocks, and
// along a hull the height rises and falls once, so it is bisected. Short ranges are looked at
// corner by corner.

namespace planish::connect_detail {
namespace {

// Up to this many corners are checked one by one.
constexpr int kFew = 8;

double height(const Vec2& p, double k, double sign) { return sign * (k * p.x() - p.y()); }

}  // namespace

RunEnvelope::RunEnvelope(std::vector<Vec2> corners) : corners_(std::move(corners)) {
  add_levels(lower_, 1.0);
  add_levels(upper_, -1.0);
}

void RunEnvelope::add_levels(std::vector<Level>& levels, double sign) const {
  const int n = static_cast<int>(corners_.size());
  for (int size = kFew; size <= n; size *= 2) {
    Level level;
    level.starts.push_back(0);
    for (int begin = 0; begin + size <= n; begin += size) {
      const auto base = level.corners.size();
      for (int i = begin; i < begin + size; ++i) {
        const Vec2& p = corners_[i];
        while (level.corners.size() >= base + 2) {
          const Vec2& a = corners_[level.corners[level.corners.size() - 2]];
          const Vec2& b = corners_[level.corners.back()];
          const double turn = (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
          if (sign * turn > 0.0) break;
          level.corners.pop_back();
        }
        level.corners.push_back(i);
      }
      level.starts.push_back(static_cast<int>(level.corners.size()));
    }
    levels.push_back(std::move(level));
  }
}

const Vec2& RunEnvelope::extreme(const std::vector<Level>& levels, int first, int last, double k,
                                 double sign) const {
  const Vec2* best = &corners_[first];
  double most = height(*best, k, sign);
  const auto look = [&](int i) {
    const Vec2& p = corners_[i];
    const double h = height(p, k, sign);
    if (h > most) {
      most = h;
      best = &p;
    }
  };
  // Height along a hull rises and falls once.
  const auto look_in_hull = [&](const Level& level, int block) {
    int low = level.starts[block], high = level.starts[static_cast<std::size_t>(block) + 1] - 1;
    while (low < high) {
      const int middle = (low + high) / 2;
      const Vec2& a = corners_[level.corners[middle]];
      const Vec2& b = corners_[level.corners[static_cast<std::size_t>(middle) + 1]];
      if (height(b, k, sign) > height(a, k, sign))
        low = middle + 1;
      else
        high = middle;
    }
    look(level.corners[low]);
  };
  int i = first;
  while (i <= last) {
    int level = -1;
    int size = kFew;
    while (level + 1 < static_cast<int>(levels.size()) && i % size == 0 && i + size - 1 <= last) {
      ++level;
      size *= 2;
    }
    if (level < 0) {
      look(i++);
    } else {
      size /= 2;
      look_in_hull(levels[level], i / size);
      i += size;
    }
  }
  return *best;
}

}  // namespace planish::connect_detail
