#pragma once

#include <string_view>
#include <vector>

namespace planish::job {

/// One code point of a text and its bytes; a byte that starts none is one of its own, not valid.
struct CodePoint {
  char32_t value = 0;
  std::string_view bytes;
  bool valid = false;
};

/// Overlong forms and surrogates count as not valid. The views point into `text`.
std::vector<CodePoint> code_points(std::string_view text);

}  // namespace planish::job
