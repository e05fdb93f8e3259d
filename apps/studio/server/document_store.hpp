#pragma once

#include "served_document.hpp"
#include "temp_folder.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace planish::studio {

/// The documents that are open, at most 8: beyond that the one longest unused is closed if nobody
/// has used it for a minute, else none is opened (429). At most two of them compute at once.
/// Thread-safe.
class DocumentStore {
 public:
  explicit DocumentStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  Answer open(const std::string& name, const std::string& bytes);
  Answer list() const;
  Answer close(const std::string& id);
  Answer attach(const std::string& id, const std::string& name, const std::string& bytes);
  Answer work(const std::string& id, const Task& task);
  Answer progress(const std::string& id) const;
  Answer cancel(const std::string& id);
  /// Ends all workers; what they compute ends with 409.
  void close_all();

 private:
  struct Row {
    std::shared_ptr<ServedDocument> document;
    std::string answer;  ///< to the request that opened it
  };

  std::shared_ptr<ServedDocument> find(const std::string& id) const;
  bool make_room();
  Answer opened(const std::string& id, const std::string& name, const std::string& bytes);

  std::filesystem::path folder_;
  Turns turns_{2};
  mutable std::mutex mutex_;
  std::map<int, Row> rows_;  ///< by number: "d7" is 7
  int opening_ = 0, last_ = 0;
};

}  // namespace planish::studio
