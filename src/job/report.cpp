#include <planish/job/report.hpp>

#include <algorithm>

namespace planish::job {

bool Report::has_warnings() const {
  return std::ranges::any_of(
      findings, [](const Finding& finding) { return finding.severity != Severity::info; });
}

Status Report::status() const {
  if (refusal) return Status::refused;
  return has_warnings() ? Status::warning : Status::ok;
}

}  // namespace planish::job
