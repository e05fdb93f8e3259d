#include "facts.hpp"

#include <cmath>

namespace planish::job {
std::string_view severity_name(Severity severity) {
  constexpr std::string_view kWords[] = {"info", "warning", "error"};
  return kWords[static_cast<int>(severity)];
}

std::string_view status_name(Status status) {
  constexpr std::string_view kWords[] = {"ok", "warning", "refused"};
  return kWords[static_cast<int>(status)];
}

bool sheet_known(const Report& report) { return report.summary.thickness > 0.0; }

bool flat_known(const Report& report) { return !report.flat.outer.loop.empty(); }

// `certify` measures the area first; NaN ("could not be measured") counts as known.
bool certificate_known(const Report& report) { return report.certificate.flat_area_half != 0.0; }

double or_nan(const std::optional<double>& value) { return value ? *value : std::nan(""); }

}  // namespace planish::job
