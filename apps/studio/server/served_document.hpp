#pragma once

#include "../worker/worker.hpp"
#include "turns.hpp"

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace planish::studio {

using Moment = std::chrono::steady_clock::time_point;

/// Progress of a task: a stage's name and the share done, 0 to 1.
struct Stage {
  std::string name;
  double share = 0.0;
};

/// Who brought a document: the page, or the command line.
enum class Origin { page, command_line };

struct DocumentLabel {
  std::string id, name;
  Origin origin = Origin::page;
};

/// A document as the server keeps it: its file and attachments in a folder, and the worker that
/// computes it, which may end at any time and is then replaced. Runs one task at a time; the others
/// wait. Thread-safe.
class ServedDocument {
 public:
  /// Creates `folder` and writes the file into it. A task that takes longer than `limit` is
  /// abandoned. Error: `cannot_write`.
  static Result<std::shared_ptr<ServedDocument>> make(std::filesystem::path folder,
                                                      DocumentLabel label,
                                                      std::chrono::seconds limit,
                                                      const std::string& bytes);
  ServedDocument(const ServedDocument&) = delete;
  ServedDocument& operator=(const ServedDocument&) = delete;
  ~ServedDocument();

  /// Has a worker read the file, once; later calls repeat its answer.
  Answer open(Turns& turns);
  /// The answer to reading it, if known, and whether it cannot be read.
  std::optional<Answer> known() const;
  bool is_unreadable() const;
  /// Has the worker do a task, after reading the file if it has not yet. 409 with `cancelled`,
  /// `worker_ended`, `worker_timeout`.
  Answer work(const Task& task, Turns& turns);
  /// Abandons the running task: its worker ends.
  void cancel();
  /// Abandons also all waiting and future tasks.
  void close();
  /// Progress of the running task, `{"stage", "share"}`, or `null`.
  Answer progress() const;
  /// Adds a file (plain name), or replaces the one of that name. 422 for too many.
  Answer attach(const std::string& name, const std::string& bytes);

  bool is_idle_since(Moment moment) const;
  Moment last_used() const;

 private:
  ServedDocument(std::filesystem::path folder, DocumentLabel label, std::chrono::seconds limit)
      : folder_(std::move(folder)),
        label_(std::move(label)),
        limit_(limit),
        worker_(studio_worker(attachments()), answer_of) {}

  void begin();
  void end();
  Answer computed(const Task& task, Turns& turns);
  Answer asked(const Task& task);
  Answer read();
  Answer labelled(Answer answer) const;
  bool is_cancelled() const;
  Answer worker_lost(process::ChildEnd::Cause cause);
  std::filesystem::path file() const { return folder_ / "document"; }
  std::filesystem::path attachments() const { return folder_ / "attachments"; }

  const std::filesystem::path folder_;
  const DocumentLabel label_;
  const std::chrono::seconds limit_;  ///< of one task
  DocumentWorker worker_;
  std::mutex turn_;  ///< held throughout a task

  mutable std::mutex state_;  ///< of all below, held for a moment only
  Stage stage_;
  std::optional<Answer> known_;
  int waiting_ = 0;
  bool computing_ = false, cancelled_ = false, closed_ = false;
  Moment last_used_ = std::chrono::steady_clock::now();
};

}  // namespace planish::studio
