#pragma once

#include <planish/job/unfold.hpp>

#include <optional>
#include <string_view>

namespace planish::job {

std::string_view severity_name(Severity severity);

/// A report may be incomplete (see Report).
bool sheet_known(const Report& report);
bool flat_known(const Report& report);
bool certificate_known(const Report& report);

/// What a file holds beside its bodies, as a sentence.
std::string note_of_surfaces(const UnfoldReport& report);

/// NaN if not known, which fails comparisons and becomes null in JSON.
double or_nan(const std::optional<double>& value);

}  // namespace planish::job
