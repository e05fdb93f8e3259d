#pragma once

#include "../work/answer.hpp"
#include "access.hpp"
#include "document_store.hpp"
#include "kept_files.hpp"

#include <string>

namespace planish::studio {

/// The parts of an HTTP request that matter here.
struct ApiRequest {
  std::string method;
  std::string path;  ///< decoded, "/api/documents/d1/draft"
  std::string name;  ///< from the query
  Caller caller;
};

constexpr std::size_t kLargestBody = std::size_t{64} << 20;

/// Everything in docs/studio-api.md, and the page itself. Thread-safe.
class Api {
 public:
  Api(Access access, DocumentStore& store, KeptFiles& kept)
      : access_(std::move(access)), store_(store), kept_(kept) {}

  /// 403 for callers without access, before their body is read; empty for all others.
  std::optional<Answer> turned_away(const ApiRequest& request) const;
  Answer answer(const ApiRequest& request, std::string body);

 private:
  Access access_;
  DocumentStore& store_;
  KeptFiles& kept_;
};

/// `kind` and `title` of every example, by name.
Answer example_list();

}  // namespace planish::studio
