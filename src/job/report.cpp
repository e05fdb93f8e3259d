#include <planish/job/report.hpp>

#include <algorithm>

namespace planish::job {

bool Report::has_warnings() const {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.severity != Severity::info; });
}

Status Report::status() const {
  if (refusal) return Status::refused;
  return has_warnings() ? Status::warning : Status::ok;
}

}  // namespace planish::job
