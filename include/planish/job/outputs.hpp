#pragma once

#include <planish/io/flat_writers.hpp>
#include <planish/job/unfold.hpp>

#include <string>
#include <vector>

namespace planish::job {

/// A body's name as part of a file name: ASCII letters, digits, '-', '_', '.' and letters of other
/// scripts stay, every run of anything else becomes one '_'; no leading '.' or '-', no trailing '.'
/// or '_'; at most 100 bytes; "body" if nothing is left.
std::string safe_name(const std::string& name);

/// One stem per body, "<safe name>_t<thickness in mm>"; where two would name the same file
/// (ignoring case, as some file systems do), the later ones end in "-2", "-3", …. Empty for a body
/// without a pattern.
std::vector<std::string> stems(const std::vector<Outcome<UnfoldReport>>& bodies);

}  // namespace planish::job
