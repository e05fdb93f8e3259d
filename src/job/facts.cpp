#include "facts.hpp"

#include <planish/base/text.hpp>

#include <fmt/format.h>

namespace planish::job {
std::string_view severity_name(Severity severity) {
  return word_of(severity, {"info", "warning", "error"});
}

std::string_view status_name(Status status) {
  return word_of(status, {"ok", "warning", "refused"});
}

bool sheet_known(const Report& report) { return report.summary.thickness > 0.0; }

bool flat_known(const Report& report) { return !report.flat.outer.loop.empty(); }

// `certify` measures the area first; NaN ("could not be measured") counts as known.
bool certificate_known(const Report& report) { return report.certificate.flat_area_half != 0.0; }

std::string note_of_surfaces(const UnfoldReport& report) {
  return fmt::format("The file also holds {}, not part of a solid: left out.",
                     counted(report.surface_bodies, "surface body/surface bodies"));
}

double or_nan(const std::optional<double>& value) { return value ? *value : std::nan(""); }

}  // namespace planish::job
