#pragma once

#include "api.hpp"
#include "presence.hpp"

#include <memory>

namespace planish::studio {

/// HTTP on 127.0.0.1. An `Api` answers the requests; this class only handles headers, limits and
/// threads.
class HttpServer {
 public:
  HttpServer();
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// Takes a port; 0: any free one. Error: `bad_option` (the port is not available).
  Result<int> bind(int port);
  /// Answers on threads of its own, from now to the end of the process. With `presence`, which must
  /// live as long, it keeps track of the pages that are open.
  void serve(Api& api, Presence* presence = nullptr);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace planish::studio
