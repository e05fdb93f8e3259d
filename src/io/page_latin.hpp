#pragma once

#include <string>

namespace planish::io_detail {

/// UTF-8 as Latin-1; "?" for what is outside it.
std::string latin_text(const std::string& text);

}  // namespace planish::io_detail
