#pragma once

#include <planish/base/result.hpp>

#include <string>

namespace planish::studio {

/// A task of a worker: `open` (argument: the file's name; body: its bytes), `draft`, `result`,
/// `plan` and `files` (argument: the format; body: a request as docs/studio-api.md has it).
struct Task {
  std::string verb;
  std::string argument;
  std::string body;
};

/// An HTTP status with its content.
struct Answer {
  int status = 200;
  std::string type;  ///< of the content
  std::string body;
};

constexpr auto kJsonType = "application/json";

/// `{"code", "message", "where"}` with this status. Bytes that are not UTF-8 become U+FFFD.
Answer failure(int status, const std::string& code, const std::string& message,
               const std::string& where = {});

/// The same for an error of the program: 409 for `cancelled`, 500 for `internal`, else 422.
Answer failure(const Error& error);
/// The same with another status of HTTP.
Answer failure(int status, const Error& error);

}  // namespace planish::studio
