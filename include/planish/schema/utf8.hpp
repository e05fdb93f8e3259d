#pragma once

#include <string_view>
#include <vector>

namespace planish::schema {

/// A code point of a text and its bytes; a byte that starts no code point stands alone, marked
/// invalid.
struct CodePoint {
  char32_t value = 0;
  std::string_view bytes;
  bool valid = false;
};

/// Overlong forms and surrogates are invalid. The views point into `text`.
std::vector<CodePoint> code_points(std::string_view text);

}  // namespace planish::schema
