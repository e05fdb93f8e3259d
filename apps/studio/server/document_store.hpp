#pragma once

#include "served_document.hpp"
#include "temp_folder.hpp"

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace planish::studio {

/// The open documents, at most 8. To make room for another, closes one that cannot be read, or the
/// least recently used if idle for a minute; otherwise refuses (429). At most two compute at once.
/// Thread-safe.
class DocumentStore {
 public:
  /// `limit`: the time for one task of a worker.
  DocumentStore(std::filesystem::path folder, std::chrono::seconds limit)
      : folder_(std::move(folder)), limit_(limit) {}

  /// Keeps a file under a new id, unread.
  Answer take(const std::string& name, const std::string& bytes, Origin origin);
  /// Has it read, and answers what is known of it before anything is computed.
  Answer open(const std::string& id);
  /// The documents that could be read.
  Answer list() const;
  Answer close(const std::string& id);
  Answer attach(const std::string& id, const std::string& name, const std::string& bytes);
  Answer work(const std::string& id, const Task& task);
  Answer progress(const std::string& id) const;
  Answer cancel(const std::string& id);
  /// Ends all workers; what they compute ends with 409. No document is accepted from now on.
  void close_all();

 private:
  std::shared_ptr<ServedDocument> find(const std::string& id) const;
  bool make_room();
  std::optional<int> new_number();

  std::filesystem::path folder_;
  std::chrono::seconds limit_;
  Turns turns_{2};
  mutable std::mutex mutex_;
  std::map<int, std::shared_ptr<ServedDocument>> documents_;  ///< by number: "d7" is 7
  std::condition_variable taken_;
  int taking_ = 0, last_ = 0;
  bool closed_ = false;
};

}  // namespace planish::studio
