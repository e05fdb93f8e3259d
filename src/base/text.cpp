#include <planish/base/message.hpp>
#include <planish/base/text.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish {
namespace {

bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
char small(char c) { return is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  const auto continues = [&](std::size_t i) {
    return (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
  };
  while (most > 0 && continues(most))
    --most;
  return std::string(text.substr(0, most)) + "…";
}

std::string trimmed_number(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string counted(double count, std::string_view noun) {
  const std::size_t slash = noun.find('/');
  const std::string one(noun.substr(0, slash));
  const std::string many = slash == std::string_view::npos ? one + "s"
                                                           : std::string(noun.substr(slash + 1));
  return fmt::format("{} {}", number_text(count, 12), count == 1.0 ? one : many);
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

std::string lower_case(std::string_view text) {
  std::string letters(text);
  std::ranges::transform(letters, letters.begin(), small);
  return letters;
}

std::string capitalized(std::string text) {
  if (!text.empty() && is_small(text.front()))
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

std::string replaced(std::string_view text, std::initializer_list<Replacement> replacements) {
  std::string made;
  for (const char c : text) {
    const auto* const found = std::ranges::find(replacements, c, &Replacement::of);
    found == replacements.end() ? made += c : made += found->by;
  }
  return made;
}

std::string continued(std::string sentence) {
  const bool is_name = sentence.starts_with("Cairo") || sentence.starts_with("Planish");
  const bool is_word = sentence.size() > 1 && (is_small(sentence[1]) || sentence[1] == ' ');
  if (is_word && !is_name) sentence[0] = small(sentence[0]);
  return sentence;
}

}  // namespace planish
