#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace planish::schema {

/// Text from a file, safe to show: control characters (line breaks, terminal escape sequences) and
/// bytes that are not UTF-8 become U+FFFD.
std::string printable(std::string_view text);

/// The same on one line of a terminal: of more than `most` characters the middle is left out, for
/// "…", because names often differ at their ends only.
inline constexpr std::size_t kNameShown = 48;
std::string printable_name(std::string_view text, std::size_t most = kNameShown);

}  // namespace planish::schema
