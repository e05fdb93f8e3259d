#include <planish/brake/bend_numbers.hpp>

#include <algorithm>
#include <utility>

namespace planish {
namespace {

/// As a transition's press lines.
void draw_bumps(FlatPattern& flat, const Plan& plan) {
  for (FlatBend& bend : flat.bends) {
    const auto large = std::ranges::find(plan.large, bend.bend, &LargeBend::bend);
    if (large == plan.large.end() || large->forming != Forming::bumps) continue;
    const std::vector<Segment> middle = std::exchange(bend.lines, {});
    bend.line_angles.clear();
    for (int bump = 0; bump < large->bumps; ++bump)
      for (const Segment& line : middle) {
        const Vec2 along = (line.b - line.a).normalized();
        const double aside = (bump + 0.5 - 0.5 * large->bumps) * large->pitch;
        const Vec2 by = aside * Vec2(-along.y(), along.x());
        bend.lines.push_back({line.a + by, line.b + by});
        bend.line_angles.push_back(large->angle);
      }
  }
}

}  // namespace

void number_bends(FlatPattern& flat, const Plan& plan) {
  if (has_order(plan)) draw_bumps(flat, plan);
  for (FlatBend& bend : flat.bends)
    for (std::size_t s = plan.strokes.size(); s > 0; --s)
      if (std::ranges::count(plan.strokes[s - 1].bends, bend.bend) > 0)
        bend.stroke = static_cast<int>(s);
}

}  // namespace planish
