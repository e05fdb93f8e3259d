#include <planish/schema/printable.hpp>
#include <planish/schema/utf8.hpp>

#include <array>

// Text as code points; a byte that begins none stands for itself, marked as invalid, so that
// nothing is lost and nothing is misread. Encodings longer than need be, surrogates and numbers
// beyond Unicode are invalid, as the standard says (RFC 3629).

namespace planish::schema {
namespace {

struct Lead {
  int length;  // bytes in all; 0: starts no code point
  char32_t bits;
};

Lead lead_of(unsigned char byte) {
  if (byte < 0x80) return {1, byte};
  if (byte >= 0xC0 && byte < 0xE0) return {2, byte & 0x1Fu};
  if (byte >= 0xE0 && byte < 0xF0) return {3, byte & 0x0Fu};
  if (byte >= 0xF0 && byte < 0xF8) return {4, byte & 0x07u};
  return {0, 0};
}

bool is_scalar(char32_t value, int length) {
  constexpr std::array<char32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000};  // by length
  return value >= smallest[length] && value <= 0x10FFFF && (value < 0xD800 || value > 0xDFFF);
}

CodePoint first_of(std::string_view text) {
  const CodePoint broken{0, text.substr(0, 1), false};
  const Lead lead = lead_of(static_cast<unsigned char>(text.front()));
  if (lead.length == 0 || text.size() < static_cast<std::size_t>(lead.length)) return broken;
  char32_t value = lead.bits;
  for (int i = 1; i < lead.length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0u) != 0x80u) return broken;
    value = (value << 6) | (byte & 0x3Fu);
  }
  if (!is_scalar(value, lead.length)) return broken;
  return {value, text.substr(0, lead.length), true};
}

}  // namespace

std::vector<CodePoint> code_points(std::string_view text) {
  std::vector<CodePoint> points;
  while (!text.empty()) {
    points.push_back(first_of(text));
    text.remove_prefix(points.back().bytes.size());
  }
  return points;
}

std::string printable(std::string_view text) {
  std::string shown;
  for (const CodePoint& c : code_points(text)) {
    const bool control = c.value < 0x20 || (c.value >= 0x7F && c.value < 0xA0);
    shown += c.valid && !control ? c.bytes : std::string_view("\uFFFD");
  }
  return shown;
}

std::string printable_name(std::string_view text, std::size_t most) {
  const std::string whole = printable(text);
  const std::vector<CodePoint> points = code_points(whole);
  if (points.size() <= most || most == 0) return whole;
  const std::size_t last = (most - 1) / 3, first = most - 1 - last;
  const auto at = [&](std::size_t i) {
    return i < points.size() ? static_cast<std::size_t>(points[i].bytes.data() - whole.data())
                             : whole.size();
  };
  return whole.substr(0, at(first)) + "…" + whole.substr(at(points.size() - last));
}

}  // namespace planish::schema
