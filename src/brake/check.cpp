// Whether a stroke can be made. Punch and die are asked one by one, as what the one hits does not
// depend on the other: of ten punches and ten dies that is twenty questions instead of a hundred
// (math.md#stroke-clearance).
#include "check.hpp"

#include "closing.hpp"
#include "gauge.hpp"
#include "plane_side.hpp"
#include "standing.hpp"

namespace planish::brake_detail {

namespace {

/// What one tool lacks or hits; of the die first what is quickly found out.
const std::optional<Obstruction>& in_the_way(StageCache& cache, const Setting& stroke,
                                             ToolKind row) {
  return cache.in_the_way(stroke, row, [&]() -> std::optional<Obstruction> {
    if (row == ToolKind::die)
      if (auto short_side = too_short(cache, stroke)) return short_side;
    StandingRow made = standing_row(cache, stroke, row);
    if (made) return std::nullopt;
    return std::move(made.error());
  });
}

}  // namespace

std::optional<Obstruction> obstruction_of(StageCache& cache, const Setting& stroke) {
  if (cache.inputs().work.lines[stroke.line].closes) {
    Standing rows = press_rows(cache, stroke);
    if (rows) return std::nullopt;
    return std::move(rows.error());
  }
  // With a punch that is known not to stand no die needs to be asked.
  if (const auto* punch = cache.known_in_the_way(stroke, ToolKind::punch)) return *punch;
  if (const auto& die = in_the_way(cache, stroke, ToolKind::die)) return die;
  return in_the_way(cache, stroke, ToolKind::punch);
}

StrokeVerdict check(StageCache& cache, const LineSet& formed, const StrokeChoice& choice) {
  const auto found = obstruction_of(cache, setting(cache.inputs(), formed, choice));
  return found ? StrokeVerdict{false, found->because} : StrokeVerdict{};
}

bool can_be_made(StageCache& cache, const LineSet& formed, const StrokeChoice& choice) {
  const Setting stroke = setting(cache.inputs(), formed, choice);
  const bool keeps_gauge = cache.inputs().work.lines[stroke.line].closes ||
                           is_gauged(cache, stroke) == choice.gauged;
  return keeps_gauge && check(cache, formed, choice).feasible;
}

}  // namespace planish::brake_detail
