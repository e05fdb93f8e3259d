#include "mutation.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace planish::fuzz {
namespace {

constexpr auto kDigits = "0123456789.eE+-";
constexpr auto kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ_abcdefghijklmnopqrstuvwxyz";

constexpr std::array<std::string_view, 16> kNumbers{"0",          "-1",
                                                    "1e308",      "-1e308",
                                                    "1e-308",     "1e999",
                                                    "NaN",        "-0.0",
                                                    "2147483648", "-2147483649",
                                                    "1e17",       "1E+10",
                                                    "0.5",        "3.141592653589793",
                                                    "1e-9",       "99999999999999999999999999"};

constexpr std::array<std::string_view, 18> kTokens{
    "$",        "*",  "()", "(", ")", "[",   "]",    "{",
    "}",        "\"", "'",  ",", ";", ".T.", "null", "\\X2\\D800\\X0\\",
    "\xff\xfe", "/*"};

}  // namespace

std::string Mutator::damaged(std::string text, const std::string& other) {
  const std::size_t kinds = 1 + below(3);
  for (std::size_t i = 0; i < kinds && !text.empty(); ++i)
    switch (below(12)) {
      case 0:
        flip_bytes(text);
        break;
      case 1:
      case 2:
        replace_number(text);
        break;
      case 3:
      case 4:
        replace_reference(text);
        break;
      case 5:
        delete_line(text);
        break;
      case 6:
        cut_off(text);
        break;
      case 7:
        repeat_span(text);
        break;
      case 8:
        delete_span(text);
        break;
      case 9:
        insert_token(text);
        break;
      case 10:
        replace_word(text, other);
        break;
      default:
        splice(text, other);
        break;
    }
  return text;
}

Mutator::Span Mutator::span_in(const std::string& text, std::size_t longest) {
  if (text.empty()) return {0, 0};
  const std::size_t at = below(text.size());
  return {at, 1 + below(std::min(longest, text.size() - at))};
}

std::vector<Mutator::Span> Mutator::runs(const std::string& text, const char* set) {
  constexpr std::size_t kMost = 1000;
  std::vector<Span> found;
  std::size_t at = text.empty() ? 0 : below(text.size());
  for (; found.size() < kMost;) {
    at = text.find_first_of(set, at);
    if (at == std::string::npos) break;
    const std::size_t end = std::min(text.find_first_not_of(set, at), text.size());
    found.push_back({at, end - at});
    at = end;
  }
  return found;
}

void Mutator::flip_bytes(std::string& text) {
  for (std::size_t n = 1 + below(8); n > 0; --n)
    text[below(text.size())] = static_cast<char>(below(256));
}

void Mutator::replace_number(std::string& text) {
  const auto numbers = runs(text, kDigits);
  if (numbers.empty()) return;
  const Span one = numbers[below(numbers.size())];
  if (below(4) == 0)
    text.insert(one.at, "-");
  else
    text.replace(one.at, one.length, kNumbers[below(kNumbers.size())]);
}

/// #12 becomes #99; in files without references one number becomes another of the file.
void Mutator::replace_reference(std::string& text) {
  const auto numbers = runs(text, "#0123456789");
  if (numbers.size() < 2) return;
  const Span one = numbers[below(numbers.size())], other = numbers[below(numbers.size())];
  text.replace(one.at, one.length, text.substr(other.at, other.length));
}

void Mutator::delete_line(std::string& text) {
  const std::size_t at = below(text.size());
  const std::size_t from = text.rfind('\n', at);
  const std::size_t to = std::min(text.find('\n', at), text.size());
  const std::size_t first = from == std::string::npos || from == at ? at : from;
  text.erase(first, to - first);
}

/// At the end, or within, so that the last lines stay.
void Mutator::cut_off(std::string& text) {
  constexpr std::size_t kTail = 40;
  const std::size_t at = below(text.size());
  if (below(2) == 0 || text.size() - at <= kTail)
    text.resize(at);
  else
    text.erase(at, text.size() - kTail - at);
}

void Mutator::repeat_span(std::string& text) {
  constexpr std::size_t kLongest = 2000, kMostTimes = 20;
  const Span span = span_in(text, kLongest);
  const std::string piece = text.substr(span.at, span.length);
  std::string many;
  for (std::size_t n = 1 + below(below(5) == 0 ? kMostTimes : 2); n > 0; --n)
    many += piece;
  text.insert(below(text.size()), many);
}

void Mutator::delete_span(std::string& text) {
  constexpr std::size_t kLongest = 200;
  const Span span = span_in(text, kLongest);
  text.erase(span.at, span.length);
}

void Mutator::insert_token(std::string& text) {
  constexpr std::size_t kDeep = 50000;
  const std::size_t at = below(text.size());
  if (below(20) == 0)
    text.insert(at, std::string(1 + below(kDeep), below(2) == 0 ? '[' : '('));
  else
    text.insert(at, kTokens[below(kTokens.size())]);
}

/// A keyword, key or type takes the place of another.
void Mutator::replace_word(std::string& text, const std::string& other) {
  const auto words = runs(text, kLetters), others = runs(other, kLetters);
  if (words.empty() || others.empty()) return;
  const Span one = words[below(words.size())], with = others[below(others.size())];
  text.replace(one.at, one.length, other, with.at, with.length);
}

void Mutator::splice(std::string& text, const std::string& other) {
  constexpr std::size_t kLongest = 4000;
  const Span there = span_in(other, kLongest), here = span_in(text, kLongest);
  text.replace(here.at, below(2) == 0 ? here.length : 0, other, there.at, there.length);
}

}  // namespace planish::fuzz
