#pragma once

#include <planish/base/assert.hpp>

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>

namespace planish {

/// Text from an input as a message quotes it: at most `most` bytes, cut between characters of UTF-8
/// and then followed by "…".
std::string shortened(std::string_view text, std::size_t most = 60);

/// Fixed decimals without trailing zeros or a trailing point.
std::string trimmed_number(double value, int decimals);

/// A whole number and its noun: "1 bend", "2 bends"; of "body/bodies" the plural is irregular.
std::string counted(double count, std::string_view noun);
template <std::integral Count>
std::string counted(Count count, std::string_view noun) {
  return counted(static_cast<double>(count), noun);
}

/// Without the mark (U+FEFF) that some editors write before text in UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

/// With ASCII letters in lower case; other bytes stay.
std::string lower_case(std::string_view text);

/// With a capital in front, if it begins with a letter of ASCII.
std::string capitalized(std::string text);

/// The text with some of its characters written otherwise: `replaced(text, {{'<', "&lt;"}})`.
struct Replacement {
  char of;
  std::string_view by;
};
std::string replaced(std::string_view text, std::initializer_list<Replacement> replacements);

/// The word of an enumerator, of a list in the order of the enumeration.
template <typename Enum>
constexpr std::string_view word_of(Enum one, std::initializer_list<std::string_view> words) {
  PLANISH_ASSERT(static_cast<std::size_t>(one) < words.size());
  return words.begin()[static_cast<std::size_t>(one)];
}

/// A sentence as it goes on after a colon: it begins small, unless with a name ("STEP", "Cairo",
/// "K-factor").
std::string continued(std::string sentence);

}  // namespace planish
