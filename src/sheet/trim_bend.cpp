#include "trim_bend.hpp"

#include <utility>

namespace planish::sheet_detail {
namespace {

double total_length(const std::vector<Segment>& lines) {
  return sum_of(lines, [&](const Segment& line) { return (line.b - line.a).norm(); });
}

}  // namespace

void trim_bend(FlatBend& bend, const std::function<std::vector<Segment>(const Segment&)>& left_of) {
  const double whole = total_length(bend.lines);
  std::vector<Segment> lines, tangent_lines;
  std::vector<Angle> angles;
  for (std::size_t i = 0; i < bend.lines.size(); ++i)
    for (const Segment& part : left_of(bend.lines[i])) {
      lines.push_back(part);
      angles.push_back(i < bend.line_angles.size() ? bend.line_angles[i] : bend.angle);
    }
  for (const Segment& line : bend.tangent_lines)
    for (const Segment& part : left_of(line))
      tangent_lines.push_back(part);
  bend.lines = std::move(lines);
  bend.line_angles = std::move(angles);
  bend.tangent_lines = std::move(tangent_lines);
  if (whole > 0.0) bend.length *= total_length(bend.lines) / whole;
}

}  // namespace planish::sheet_detail
