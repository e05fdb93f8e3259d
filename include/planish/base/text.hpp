#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace planish {

/// Text from an input as a message quotes it: at most `most` bytes, cut between characters of UTF-8
/// and then followed by "…".
std::string shortened(std::string_view text, std::size_t most = 60);

/// Fixed decimals without trailing zeros or a trailing point.
std::string trimmed_number(double value, int decimals);

/// "1 bend", "2 bends".
std::string counted(int n, std::string_view singular);

/// A sentence as it goes on after a colon: it begins small, unless with a name ("STEP", "Cairo",
/// "K-factor").
std::string continued(std::string sentence);

}  // namespace planish
