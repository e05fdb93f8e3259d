#include "points_artifact.hpp"

#include <planish/geometry/curve.hpp>

#include <fmt/format.h>

namespace planish::job {
namespace {

constexpr double kChord = 0.01;  // mm

Result<std::string> write_points(const Made& made, int piece, const Request&) {
  std::string csv = "x,y\n";
  for (const Vec2& p : sampled(made.piece(piece).flat.outer.loop, kChord))
    csv += fmt::format("{},{}\n", p.x(), p.y());
  return csv;
}

}  // namespace

Artifact points_artifact() {
  return {"points",
          Role::flat,
          Source::pattern,
          ".csv",
          ".csv",
          "text/csv",
          "CSV, points of the outer contour",
          write_points};
}

}  // namespace planish::job
