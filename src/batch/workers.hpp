#pragma once

#include "part_work.hpp"

#include <functional>
#include <memory>

namespace planish::batch {

/// A process that does one task after another, and is replaced when it is lost or has grown.
class Worker {
 public:
  Worker(const process::Limits& limits, const job::Catalogue& catalogue,
         std::function<bool()> cancelled)
      : limits_(limits), catalogue_(catalogue), cancelled_(std::move(cancelled)) {}

  /// What became of the task, whatever became of the process. A body that ends the process is given
  /// up, and the others of its file are done. Errors: `cancelled`, `internal` (no process can be
  /// started).
  Result<std::vector<PartDone>> work_on(FileTask task);

 private:
  /// What came of a task before its end.
  struct Heard {
    std::optional<int> body;  ///< begun last
    std::vector<PartDone> parts;
  };
  Result<void> begin();
  /// How it ended if it did not end well. Each body, and the reading of the file, has the time that
  /// the limits allow.
  std::optional<process::ChildEnd> ask(const FileTask& task, Heard& heard);

  process::Limits limits_;
  const job::Catalogue& catalogue_;
  std::function<bool()> cancelled_;
  std::unique_ptr<process::ChildProcess> child_;
};

}  // namespace planish::batch
