#pragma once

#include "document.hpp"

#include <planish/job/report.hpp>

namespace planish::studio {

constexpr auto kDxfType = "image/vnd.dxf";
constexpr auto kSvgType = "image/svg+xml";
constexpr auto kStepType = "model/step";
constexpr auto kStlType = "model/stl";

/// Files that every kind has: `dxf`, `svg` and `flat.step` of the pattern, `spec`. Empty for other
/// formats. Errors: those of the writers; the report's refusal for files of the pattern.
std::optional<Result<MadeFile>> common_file(const job::Report& report, const Asked& asked,
                                            const std::string& format, const SvgOptions& svg = {});

/// A text, or the reason why there is none, as a file.
Result<MadeFile> as_file(Result<std::string> text, const char* type);

/// What a refused report says in place of a file.
Result<void> not_refused(const job::Report& report);

Error no_such_format(const std::string& format);

/// `bad_option` where there is no spec.
Result<void> has_spec(const Asked& asked);

}  // namespace planish::studio
