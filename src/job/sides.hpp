#pragma once

#include <planish/base/result.hpp>
#include <planish/job/unfold.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/sheet.hpp>

namespace planish::job {

/// Options for `flatten`, from the words and face numbers of a request. Errors: `no_such_face` (the
/// message lists the valid ones), `bad_option` for an unknown word.
Result<FlattenOptions> flatten_options(const Sheet& sheet, const Request& request);

}  // namespace planish::job
