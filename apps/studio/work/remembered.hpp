#pragma once

#include "asked.hpp"

#include <optional>
#include <string>
#include <utility>

namespace planish::studio {

/// The last whole report with the request it answers: files are mostly asked for after the result
/// of the same request.
template <typename Report>
class Remembered {
 public:
  /// The report of `request` (its text), made by `make` where it is not the last one.
  template <typename Make>
  Result<Report> get(const std::string& request, const Make& make) {
    if (last_ && last_->first == request) return last_->second;
    Result<Report> report = make();
    if (report) last_ = {request, *report};
    return report;
  }

 private:
  std::optional<std::pair<std::string, Report>> last_;
};

}  // namespace planish::studio
