#include "base64.hpp"

#include <algorithm>
#include <cstdint>

namespace planish::serve {

std::string base64(std::string_view bytes) {
  constexpr std::string_view
      kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::size_t kBytes = 3, kOut = 4;
  std::string text;
  text.reserve((bytes.size() + kBytes - 1) / kBytes * kOut);
  for (std::size_t i = 0; i < bytes.size(); i += kBytes) {
    const std::size_t count = std::min(kBytes, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < kBytes; ++k)
      bits = bits << 8U | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < kOut; ++k)
      text += k <= count ? kLetters[bits >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

}  // namespace planish::serve
