#pragma once

#include "access.hpp"
#include "document_store.hpp"

#include <memory>

namespace planish::studio {

/// WebSockets on a port of its own of 127.0.0.1, over which drafts are asked for: what a browser
/// takes for an HTTP request, some 4 ms, is as much as a draft takes.
class DraftSocket {
 public:
  DraftSocket();
  ~DraftSocket();
  DraftSocket(const DraftSocket&) = delete;
  DraftSocket& operator=(const DraftSocket&) = delete;

  /// Takes any port that is free. Error: `internal` (there is none).
  Result<int> bind();
  /// Answers on threads of its own, from now to the end of the process.
  void serve(const Access& access, DocumentStore& store);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace planish::studio
