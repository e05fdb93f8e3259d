#include "drawn_edges.hpp"

#include <algorithm>
#include <cmath>

// The edges that a drawing has already brought to the bend. Edges on one tangent line whose ends
// lie opposite each other are drawn for each other; of several groups of them the widest is used,
// and a recess between groups stays open. The measure is in mm and not of the extent: drawings are
// off by what their files and chords are off, whatever the size of the part.

namespace planish::connect_detail {
namespace {

// Edges this near a line (mm), and ends this near each other, are drawn so: real parts are not
// quite straight, and curves are polygons within as much (`PlatesOfOptions::chord`).
constexpr double kAsDrawn = 0.01;
// An edge takes part in a bend that uses more than this share of it, or whose share it is.
constexpr double kTakesPart = 0.1;

/// Consecutive edges of a run, by position: first … last.
struct Group {
  int first = 0, last = 0;
};

/// The edges chosen of one plate, and which of them lie on the tangent line.
struct Drawn {
  std::vector<Vec2> corners;
  std::vector<int> edges;
  std::vector<Group> groups;  ///< on the line, as far as they follow each other

  double left(const Group& g) const { return corners.at(g.first).x(); }
  double right(const Group& g) const { return corners.at(g.last + 1).x(); }
  Group whole() const { return {0, static_cast<int>(edges.size()) - 1}; }
  bool all() const {
    return groups.size() == 1 && groups[0].first == 0 && groups[0].last == whole().last;
  }
  std::vector<int> of(const Group& g) const {
    return {edges.begin() + g.first, edges.begin() + g.last + 1};
  }
};
using Both = std::array<Drawn, 2>;
using GroupPair = std::array<Group, 2>;

Both drawn_of(const PairChoice& choice) {
  const EdgeChoice& best = choice.search.best;
  const auto corners = choice.corners(best);
  const auto edges = choice.edges(best);
  Both both;
  for (std::size_t i = 0; i < 2; ++i) {
    Drawn& side = both[i] = {corners[i], edges[i], {}};
    const auto on_line = [&](int corner) {
      const Vec2& p = side.corners[corner];
      return std::abs(p.y() - best.line.at(p.x())) <= kAsDrawn;
    };
    for (int j = 0; j <= side.whole().last; ++j) {
      if (!on_line(j) || !on_line(j + 1)) continue;
      if (!side.groups.empty() && side.groups.back().last == j - 1)
        side.groups.back().last = j;
      else
        side.groups.push_back({j, j});
    }
  }
  return both;
}

bool opposite(double a, double b) { return std::abs(a - b) <= kAsDrawn; }

/// Groups of the line and their parts, whose ends lie opposite each other: the widest.
std::optional<GroupPair> widest_match(const Both& both) {
  std::optional<GroupPair> widest;
  double width = 0.0;
  const auto consider = [&](const GroupPair& pair) {
    const double here = both[0].right(pair[0]) - both[0].left(pair[0]);
    if (here <= width) return;
    width = here;
    widest = pair;
  };
  const auto match_right = [&](const Group& a, const Group& b, int first_a, int first_b) {
    for (int i = first_a, j = first_b; i <= a.last && j <= b.last;) {
      const double right_a = both[0].right({first_a, i}), right_b = both[1].right({first_b, j});
      if (opposite(right_a, right_b)) consider({Group{first_a, i}, Group{first_b, j}});
      if (right_a < right_b)
        ++i;
      else
        ++j;
    }
  };
  for (const Group& a : both[0].groups)
    for (const Group& b : both[1].groups)
      for (int i = a.first, j = b.first; i <= a.last && j <= b.last;) {
        const double left_a = both[0].left({i, i}), left_b = both[1].left({j, j});
        if (opposite(left_a, left_b)) match_right(a, b, i, j);
        if (left_a < left_b)
          ++i;
        else
          ++j;
      }
  return widest;
}

/// The edges of a group that take part in a bend from x = low to high.
std::optional<Group> within(const Drawn& side, const Group& group, double low, double high) {
  std::optional<Group> part;
  for (int j = group.first; j <= group.last; ++j) {
    const double left = side.left({j, j}), right = side.right({j, j});
    const double common = std::min(right, high) - std::max(left, low);
    if (common <= kTakesPart * std::min(right - left, high - low)) continue;
    if (!part) part = Group{j, j};
    part->last = j;
  }
  return part;
}

/// The edges of the two groups that have most width in common.
std::optional<GroupPair> widest_overlap(const Both& both) {
  std::optional<GroupPair> widest;
  double width = 0.0;
  for (const Group& a : both[0].groups)
    for (const Group& b : both[1].groups) {
      const double low = std::max(both[0].left(a), both[1].left(b));
      const double high = std::min(both[0].right(a), both[1].right(b));
      if (high - low <= width) continue;
      const auto first = within(both[0], a, low, high), second = within(both[1], b, low, high);
      if (!first || !second) continue;
      width = high - low;
      widest = GroupPair{*first, *second};
    }
  return widest;
}

}  // namespace

std::optional<std::array<std::vector<int>, 2>> drawn_edges(const PairChoice& choice) {
  const Both both = drawn_of(choice);
  const bool interrupted = both[0].groups.size() > 1 || both[1].groups.size() > 1;
  if (!interrupted && !(both[0].all() && both[1].all())) return std::nullopt;
  const Group a = both[0].whole(), b = both[1].whole();
  if (!interrupted && opposite(both[0].left(a), both[1].left(b)) &&
      opposite(both[0].right(a), both[1].right(b)))
    return std::nullopt;
  std::optional<GroupPair> pair = widest_match(both);
  if (!pair && interrupted) pair = widest_overlap(both);
  if (!pair) return std::nullopt;
  return std::array{both[0].of((*pair)[0]), both[1].of((*pair)[1])};
}

}  // namespace planish::connect_detail
