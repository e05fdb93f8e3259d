#include <planish/base/text.hpp>

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

}  // namespace planish
