#include "facts.hpp"

#include <planish/geometry/region.hpp>

#include <algorithm>

namespace planish::job {
namespace {

double length_of(const Segment& segment) { return (segment.b - segment.a).norm(); }

}  // namespace

std::string_view kind_name(BendKind kind) {
  switch (kind) {
    case BendKind::cylinder:
      return "cylinder";
    case BendKind::cone:
      return "cone";
    case BendKind::general:
      return "general";
    case BendKind::sharp:
      break;
  }
  return "sharp";
}

std::string_view direction_name(BendDirection direction) {
  return direction == BendDirection::up ? "up" : "down";
}

std::string_view severity_name(Severity severity) {
  switch (severity) {
    case Severity::info:
      return "info";
    case Severity::warning:
      return "warning";
    case Severity::error:
      break;
  }
  return "error";
}

std::string_view status_name(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::warning:
      return "warning";
    case Status::refused:
      break;
  }
  return "refused";
}

double outer_cutting_length(const FlatPattern& flat) { return length(flat.outer.loop); }

double inner_cutting_length(const FlatPattern& flat) {
  double sum = 0.0;
  for (const Contour& opening : flat.openings)
    sum += length(opening.loop);
  for (const Segment& slit : flat.slits)
    sum += length_of(slit);
  return sum;
}

std::optional<Segment> longest_line(const FlatBend& bend) {
  const auto longest = std::max_element(
      bend.lines.begin(), bend.lines.end(),
      [](const Segment& a, const Segment& b) { return length_of(a) < length_of(b); });
  if (longest == bend.lines.end()) return std::nullopt;
  return *longest;
}

bool sheet_known(const Report& report) { return report.summary.thickness > 0.0; }

bool flat_known(const Report& report) { return !report.flat.outer.loop.empty(); }

// `certify` measures the area first; NaN ("could not be measured") counts as known.
bool certificate_known(const Report& report) { return report.certificate.flat_area_half != 0.0; }

double or_nan(const std::optional<double>& value) { return value ? *value : std::nan(""); }

}  // namespace planish::job
