#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace planish {

/// Text from an input as a message quotes it: at most `most` bytes, cut between characters of UTF-8
/// and then followed by "…".
std::string shortened(std::string_view text, std::size_t most = 60);

}  // namespace planish
