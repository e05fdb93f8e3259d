#include "page_latin.hpp"

#include <planish/io/page.hpp>

#include <array>

namespace planish {
namespace {

constexpr unsigned char kFirst = 32, kLast = 126;
constexpr double kThousand = 1000.0;

// Adobe's metrics of the standard fonts, for the characters from 32 to 126; of the others the width
// of a small letter, which accented ones have.
constexpr std::array<short, 95> kRegular{
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
constexpr std::array<short, 95> kBold{
    278, 333, 474, 556, 556, 889, 722, 238, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 333, 333, 584, 584, 584, 611, 975, 722, 722, 722, 722, 667,
    611, 778, 722, 278, 556, 722, 611, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667,
    667, 611, 333, 278, 333, 584, 556, 333, 556, 611, 556, 611, 556, 333, 611, 611, 278, 278, 556,
    278, 889, 611, 611, 611, 611, 389, 556, 333, 611, 556, 778, 556, 556, 500, 389, 280, 389, 584};
constexpr double kOther = 556.0, kDegreeSign = 400.0;

bool goes_on(unsigned char byte) { return (byte & 0xC0) == 0x80; }

}  // namespace

namespace io_detail {

std::string latin_text(const std::string& text) {
  std::string latin;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x80) {
      latin += text[i];
    } else if ((byte == 0xC2 || byte == 0xC3) && i + 1 < text.size()) {
      latin += static_cast<char>((byte & 0x03) << 6 | (text[++i] & 0x3F));
    } else {
      while (i + 1 < text.size() && goes_on(static_cast<unsigned char>(text[i + 1])))
        ++i;
      latin += '?';
    }
  }
  return latin;
}

}  // namespace io_detail

double text_width(const std::string& text, double size, bool bold) {
  double width = 0.0;
  for (const char c : io_detail::latin_text(text)) {
    const auto code = static_cast<unsigned char>(c);
    const auto& table = bold ? kBold : kRegular;
    width += code >= kFirst && code <= kLast ? table[code - kFirst]
             : code == 0xB0                  ? kDegreeSign
                                             : kOther;
  }
  return width * size / kThousand;
}

}  // namespace planish
