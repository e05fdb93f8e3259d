#pragma once

#include <string>
#include <string_view>

namespace planish::job {

/// Text from a file as it may be shown: control characters (line breaks, escape sequences that
/// command a terminal) and bytes that are not UTF-8 become U+FFFD.
std::string printable(std::string_view text);

}  // namespace planish::job
