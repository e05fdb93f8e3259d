#include "check.hpp"

#include "closing.hpp"
#include "plane_side.hpp"

namespace planish::brake_detail {

/// What is quickly found out is asked first.
std::optional<Obstruction> obstruction_of(StageCache& cache, const Setting& stroke) {
  if (!cache.inputs().work.lines[stroke.line].closes)
    if (auto short_side = too_short(cache, stroke)) return short_side;
  Standing rows = press_rows(cache, stroke);
  if (rows) return std::nullopt;
  return std::move(rows.error());
}

StrokeVerdict check(StageCache& cache, const LineSet& formed, const StrokeChoice& choice) {
  const auto found = obstruction_of(cache, setting(cache.inputs(), formed, choice));
  return found ? StrokeVerdict{false, found->because} : StrokeVerdict{};
}

}  // namespace planish::brake_detail
