#include "presses.hpp"

#include "refusals.hpp"

#include <planish/base/tolerance.hpp>

#include <algorithm>
#include <cmath>

// Where curved patches are pressed (transition.md#the-net). A count or a largest angle divides the
// turn evenly, a chord the longer border; 90° by 10° are 9 lines despite rounding. A patch that a
// seam divides shares its lines so that the parts add up to the count.

namespace planish::transition_detail {
namespace {

/// How many lines a part of a patch is pressed on; nothing where it is rolled.
double wanted_presses(const RuledPatch& patch, double from, double to, const Pressing& pressing) {
  constexpr double kExactly = tolerance::kComputed;  // 90° by 10° are 9 lines
  const auto lines = [](double amount) { return std::max(1.0, std::ceil(amount - kExactly)); };
  if (const auto* count = std::get_if<PressCount>(&pressing)) {
    if (from == 0.0 && to == 1.0) return count->count;
    // Parts divided by a seam share the lines.
    const double whole = patch.turn(0.0, 1.0);
    const auto up_to = [&](double at) {
      return std::round(count->count * patch.turn(0.0, at) / whole);
    };
    return std::max(1.0, up_to(to) - up_to(from));
  }
  if (const auto* angle = std::get_if<PressAngle>(&pressing))
    return lines(patch.turn(from, to) / angle->largest.radians());
  if (const auto* chord = std::get_if<PressChord>(&pressing))
    return lines(std::max(patch.border_length(0, from, to), patch.border_length(1, from, to)) /
                 chord->largest);
  return 0.0;
}

}  // namespace

Result<void> check_presses(const Ring& ring, const std::vector<std::vector<PatchPart>>& pieces,
                           const Pressing& pressing) {
  constexpr double kMostLines = 2000.0;  // of a bend
  for (const auto& parts : pieces)
    for (const PatchPart& part : parts) {
      const RuledPatch& patch = ring.patch(part.patch);
      if (patch.plane()) continue;
      if (const double lines = wanted_presses(patch, part.from, part.to, pressing);
          lines > kMostLines)
        return fail(refuse::too_many_press_lines, {{"lines", lines, unit::none},
                                                   {"most", kMostLines, unit::none},
                                                   {"field", place::pointer("/press_lines")}});
    }
  return {};
}

std::vector<RuledPatch::Press> presses_of(const RuledPatch& patch, double from, double to,
                                          const Pressing& pressing) {
  const int count = static_cast<int>(wanted_presses(patch, from, to, pressing));
  if (count == 0) return {};
  if (!std::holds_alternative<PressChord>(pressing)) return patch.evenly_turned(from, to, count);
  return patch.evenly_along(
      patch.border_length(1, from, to) > patch.border_length(0, from, to) ? 1 : 0, from, to, count);
}

}  // namespace planish::transition_detail
