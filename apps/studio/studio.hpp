#pragma once

#include <planish/base/result.hpp>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace planish::studio {

struct StudioOptions {
  std::optional<std::filesystem::path> file;  ///< opened as the first document
  int port = 0;                               ///< 0: any free one
  std::chrono::seconds time_limit{120};       ///< for one task of a worker
  bool open_browser = true;
  std::optional<std::chrono::seconds> end_after;  ///< without a page that is open
};

/// Serves the page on 127.0.0.1 until SIGINT or SIGTERM, or until no page has been open for
/// `end_after`, then ends the process; prints its address, and opens a browser. Must be called
/// before there are other threads. Errors: `cannot_read` and others for the file, `bad_option` (the
/// port is taken).
Result<void> run_studio(const StudioOptions& options);

/// Works for the server whose process number is `server`, on descriptor 3, until that is closed.
int run_worker(const std::string& server);

}  // namespace planish::studio
