#pragma once

#include <planish/base/result.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/unfold.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace planish::job {

/// A body's name as part of a file name: ASCII letters, digits, '-', '_', '.' and letters of other
/// scripts stay, every run of anything else becomes one '_'; no '.' or '-' in front, no '.' or '_'
/// at the end; at most 100 bytes; "body" where nothing is left.
std::string safe_name(const std::string& name);

/// One stem a report, "<safe name>_t<thickness in mm>"; where two would be one file (also for file
/// systems that take capitals for small letters), the later ones end in "-2", "-3", …. Empty for a
/// report without pattern.
std::vector<std::string> stems(const std::vector<UnfoldReport>& reports);

}  // namespace planish::job
