#pragma once

#include <string>
#include <string_view>

namespace planish::schema {

/// Text from a file, safe to show: control characters (line breaks, terminal escape sequences) and
/// bytes that are not UTF-8 become U+FFFD.
std::string printable(std::string_view text);

}  // namespace planish::schema
