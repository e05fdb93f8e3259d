#include <planish/base/text.hpp>

#include <fmt/format.h>

namespace planish {

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
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string counted(int n, std::string_view singular) {
  return fmt::format("{} {}{}", n, singular, n == 1 ? "" : "s");
}

std::string continued(std::string sentence) {
  const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
  const bool is_name = sentence.starts_with("Cairo") || sentence.starts_with("Planish");
  const bool is_word = sentence.size() > 1 && (is_small(sentence[1]) || sentence[1] == ' ');
  if (is_word && !is_name && sentence[0] >= 'A' && sentence[0] <= 'Z')
    sentence[0] = static_cast<char>(sentence[0] - 'A' + 'a');
  return sentence;
}

}  // namespace planish
