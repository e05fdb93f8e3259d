// Strips between slits that are curves (math.md#curved-slits). The sides of the sheet are slits
// too, as far as strips go; sorted by where they begin, each strip lies between two that follow.
// Chains that do not cross keep their order, so that every strip has a left and a right edge.
#include "refusals.hpp"
#include "value_checks.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/geometry/plane.hpp>
#include <planish/slit/slit_curves.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace planish {
namespace {

using namespace slit_detail;
using Chain = std::vector<Vec2>;

/// An edge of strips, and the slit that it is; none of a side of the sheet.
struct Edge {
  Chain chain;
  std::optional<std::size_t> slit;
  std::string field() const {
    return slit ? "/slits/" + std::to_string(*slit) : std::string("/outline");
  }
};

bool is_at(double a, double b, const SlitSheet& sheet) {
  return std::abs(a - b) <= tolerance::kWrittenDigits * sheet.far_line();
}

/// Without corners that are twice in turn.
Chain without_repeats(Chain chain) {
  const auto end = std::unique(chain.begin(), chain.end());
  chain.erase(end, chain.end());
  return chain;
}

Result<Edge> slit_edge(const SlitSheet& sheet, Chain chain, std::size_t number) {
  chain = without_repeats(std::move(chain));
  const std::string where = "/slits/" + std::to_string(number);
  const Fact slit("slit", static_cast<int>(number) + 1), field("field", place::pointer(where));
  if (chain.size() < 2) return fail(refuse::slit_without_length, {slit, field});
  if (chain.front().x() > chain.back().x()) std::ranges::reverse(chain);
  const double end = sheet.far_line();
  if (is_at(chain.back().x(), end, sheet)) chain.back().x() = end;
  for (const Vec2& corner : chain)
    if (const bool is_last = &corner == &chain.back();
        !(corner.x() > 0.0 && (corner.x() < end || (is_last && corner.x() == end))))
      return fail(refuse::slit_off_sheet,
                  {slit, {"at", corner.x(), unit::mm}, {"end", end, unit::mm}, field});
  if (!(chain.front().x() < chain.back().x()))
    return fail(refuse::slit_across, {slit, {"at", chain.back().x(), unit::mm}, field});
  return Edge{std::move(chain), number};
}

/// A side of the sheet from the panel's free edge to where strips end, without the panel.
std::optional<Chain> beside_strips(const SlitSheet& sheet, const Chain& side) {
  const double across = side.front().y();
  Chain chain;
  Vec2 before = side.front();
  for (const Vec2& corner : side) {
    const bool at_height = is_at(corner.x(), sheet.panel_height, sheet);
    const bool straight_on = is_at(corner.y(), across, sheet);
    if (at_height || corner.x() < sheet.panel_height) {
      if (!chain.empty() || !straight_on) return std::nullopt;
    } else {
      if (chain.empty()) {
        if (!is_at(before.x(), sheet.panel_height, sheet) && !straight_on) return std::nullopt;
        chain.emplace_back(sheet.panel_height, across);
      }
      chain.push_back(corner);
    }
    before = corner;
  }
  if (chain.empty()) return std::nullopt;
  chain.back().x() = sheet.far_line();
  return chain;
}

/// The left and the right side of an outline.
std::optional<std::array<Chain, 2>> sides_of_outline(const SlitSheet& sheet, Chain ring) {
  ring = without_repeats(std::move(ring));
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  double twice = 0.0;
  for (const Segment& side : sides_of(ring))
    twice += cross(side.a, side.b);
  if (twice < 0.0) std::ranges::reverse(ring);
  const auto first = std::ranges::find_if(ring, [&](const Vec2& corner) {
    return is_at(corner.x(), 0.0, sheet) && is_at(corner.y(), 0.0, sheet);
  });
  if (first == ring.end() || ring.size() < 4) return std::nullopt;
  std::ranges::rotate(ring, first);
  ring.front() = Vec2::Zero();
  const auto ends = [&](const Vec2& corner) { return is_at(corner.x(), sheet.far_line(), sheet); };
  const auto top = std::ranges::find_if(ring, ends);
  if (top == ring.end() || !is_at(ring.back().x(), 0.0, sheet)) return std::nullopt;
  const auto last = std::find_if(ring.rbegin(), ring.rend(), ends).base();
  if (!std::all_of(top, last, ends)) return std::nullopt;
  ring.back().x() = 0.0;
  auto left = beside_strips(sheet, Chain(ring.begin(), top + 1)),
       right = beside_strips(sheet, Chain(std::make_reverse_iterator(ring.end()),
                                          std::make_reverse_iterator(last - 1)));
  if (!left || !right) return std::nullopt;
  return std::array{std::move(*left), std::move(*right)};
}

bool cross_each_other(const Chain& a, const Chain& b) {
  Box2 around;
  for (const Vec2& corner : b)
    around.add(corner);
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    const Segment one{a[i], a[i + 1]};
    Box2 box;
    box.add(one.a);
    box.add(one.b);
    if ((box.lo.array() > around.hi.array()).any() || (box.hi.array() < around.lo.array()).any())
      continue;
    for (std::size_t j = 0; j + 1 < b.size(); ++j)
      if (distance(one, Segment{b[j], b[j + 1]}) == 0.0) return true;
  }
  return false;
}

/// Both banks of a strip lie apart and in order.
Result<void> check_between(const Edge& left, const Edge& right) {
  const Fact field("field", place::pointer((right.slit ? right : left).field()));
  const auto name = [](const Edge& edge) {
    return edge.slit ? "slit " + std::to_string(*edge.slit + 1) : std::string("the outline");
  };
  const Fact one("one", name(left)), other("other", name(right));
  if (left.chain.back().x() <= right.chain.front().x() ||
      right.chain.back().x() <= left.chain.front().x())
    return fail(refuse::slits_in_line, {one, other, field});
  if (!(left.chain.front().y() < right.chain.front().y() &&
        left.chain.back().y() < right.chain.back().y()))
    return fail(refuse::strip_without_width, {one, other, field});
  if (cross_each_other(left.chain, right.chain))
    return fail(refuse::slits_cross, {one, other, field});
  return {};
}

bool is_line_along(const Chain& chain) {
  return std::ranges::all_of(chain, [&](const Vec2& p) { return p.y() == chain.front().y(); });
}

/// The edge up to where the slit on the other side of a strip ends: beyond, the strip is part of
/// the plane that joins it there, whose sides are straight.
Result<void> end_at(Edge& edge, double along, double far_line) {
  Chain& chain = edge.chain;
  const double across = chain.back().y();
  if (chain.back().x() <= along) return {};
  while (chain.size() > 2 && chain[chain.size() - 2].x() >= along)
    chain.pop_back();
  const Vec2 from = chain[chain.size() - 2], to = chain.back();
  chain.back() = from + (along - from.x()) / (to.x() - from.x()) * (to - from);
  chain.back().x() = along;
  const bool is_straight = std::abs(chain.back().y() - across) <=
                           tolerance::kWrittenDigits * far_line;
  if (!is_straight || chain[chain.size() - 2].x() >= along)
    return fail(refuse::side_not_straight,
                {{"side", edge.slit ? "Slit " + std::to_string(*edge.slit + 1)
                                    : std::string("The outline")},
                 {"from", along, unit::mm},
                 {"end", far_line, unit::mm},
                 {"field", place::pointer(edge.field())}});
  chain.back().y() = across;
  return {};
}

Result<SlitStrip> strip_of(const SlitSheet& sheet, Edge left, Edge right) {
  SlitStrip strip;
  const bool left_early = left.chain.back().x() < sheet.far_line(),
             right_early = right.chain.back().x() < sheet.far_line();
  if (left_early) strip.left_end = left.chain.back().x();
  if (right_early) strip.right_end = right.chain.back().x();
  if (left_early != right_early)
    if (auto ended = left_early ? end_at(right, *strip.left_end, sheet.far_line())
                                : end_at(left, *strip.right_end, sheet.far_line());
        !ended)
      return pass_on(ended);
  strip.width = right.chain.front().y() - left.chain.front().y();
  for (const auto& [edge, start] :
       {std::pair{&left, &strip.left_start}, std::pair{&right, &strip.right_start}})
    if (edge->chain.front().x() != sheet.panel_height) *start = edge->chain.front().x();
  const auto edge_of = [](const Edge& edge) {
    return is_line_along(edge.chain) ? Chain() : edge.chain;
  };
  strip.edges = {edge_of(left), edge_of(right)};
  return strip;
}

}  // namespace

std::vector<Vec2> chain_on(const BezierCurve& curve, double chord) {
  // |c″| is at most degree · (degree − 1) times the largest second difference of poles.
  const std::vector<Vec2>& poles = curve.poles;
  double second = 0.0;
  for (std::size_t i = 0; i + 2 < poles.size(); ++i)
    second = std::max(second, (poles[i] - 2.0 * poles[i + 1] + poles[i + 2]).norm());
  const auto degree = static_cast<double>(poles.size() - 1);
  constexpr double kMost = 10'000.0;
  const double lines = std::ceil(std::sqrt(degree * (degree - 1.0) * second / (8.0 * chord)));
  const int count = static_cast<int>(std::clamp(lines, 1.0, kMost));
  std::vector<Vec2> chain{poles.front()};
  for (int i = 1; i < count; ++i)
    chain.push_back(bezier_at(curve, static_cast<double>(i) / count).point);
  chain.push_back(poles.back());
  return chain;
}

Result<std::vector<SlitStrip>> strips_between(const SlitSheet& sheet, const CurvedSlits& curves) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < curves.slits.size(); ++i) {
    auto edge = slit_edge(sheet, curves.slits[i], i);
    if (!edge) return pass_on(edge);
    edges.push_back(std::move(*edge));
  }
  std::ranges::sort(edges, {}, [](const Edge& edge) { return edge.chain.front().y(); });
  const double from = sheet.panel_height, to = sheet.far_line();
  std::array<Chain, 2> sides{Chain{{from, 0.0}, {to, 0.0}},
                             Chain{{from, curves.width}, {to, curves.width}}};
  if (!curves.outline.empty()) {
    auto given = sides_of_outline(sheet, curves.outline);
    if (!given)
      return fail(refuse::outline_without_panel, {{"height", sheet.panel_height, unit::mm},
                                                  {"end", to, unit::mm},
                                                  {"field", field("/outline")}});
    sides = std::move(*given);
  }
  edges.insert(edges.begin(), Edge{std::move(sides[0]), {}});
  edges.push_back({std::move(sides[1]), {}});
  std::vector<SlitStrip> strips;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if (auto sound = check_between(edges[i], edges[i + 1]); !sound) return pass_on(sound);
    auto strip = strip_of(sheet, edges[i], edges[i + 1]);
    if (!strip) return pass_on(strip);
    strips.push_back(std::move(*strip));
  }
  return strips;
}

}  // namespace planish
