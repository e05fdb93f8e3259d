#include "check.hpp"

#include "closing.hpp"
#include "plane_side.hpp"
#include "standing.hpp"

namespace planish::brake_detail {

/// What is quickly found out is asked first.
StrokeVerdict check(StageCache& cache, const LineSet& formed, const StrokeChoice& choice) {
  const Setting stroke = setting(cache.inputs(), formed, choice);
  const bool closes = cache.inputs().work.lines[stroke.line].closes.has_value();
  if (!closes)
    if (const auto side = too_short(cache, stroke)) return {false, side->because};
  const Standing rows = closes ? closing(cache, stroke) : standing(cache, stroke);
  return rows ? StrokeVerdict{} : StrokeVerdict{false, rows.error().because};
}

}  // namespace planish::brake_detail
