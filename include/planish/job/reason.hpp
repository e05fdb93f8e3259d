#pragma once

#include <planish/base/result.hpp>

#include <string>

namespace planish::job {

/// An error as JSON text: `code`, `message`, `where`, `places`, `numbers`, and `remedy` where there
/// is one (formats.md#reason). Lengths are mm. One line, UTF-8 whatever the names hold.
std::string reason_text(const Error& error);

}  // namespace planish::job
