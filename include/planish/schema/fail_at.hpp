#pragma once

#include <planish/base/result.hpp>

#include <string>
#include <utility>

namespace planish::schema {

/// The error of a field of a request or of another JSON document: its pointer is the place, and so
/// is `where`.
inline Error error_at(const ErrorCode& code, std::string message, std::string pointer) {
  return {code, std::move(message), pointer, {place::pointer(pointer)}};
}
inline tl::unexpected<Error> fail_at(const ErrorCode& code, std::string message,
                                     std::string pointer) {
  return fail(error_at(code, std::move(message), std::move(pointer)));
}

}  // namespace planish::schema
