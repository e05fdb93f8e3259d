#pragma once

#include "api.hpp"

#include <functional>
#include <memory>

namespace planish::studio {

/// HTTP on 127.0.0.1. What is asked is answered by an `Api`; here are only headers, limits and
/// threads.
class HttpServer {
 public:
  HttpServer();
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// Takes a port; 0: any that is free. Error: `bad_option` (it cannot be had).
  Result<int> bind(int port);
  /// Answers on threads of its own, from now to the end of the process.
  void serve(Api& api);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace planish::studio
