#pragma once

#include "part_work.hpp"
#include "worker_talk.hpp"

#include <planish/process/worker.hpp>

#include <functional>

namespace planish::batch {

/// Does one task after another in a process of its own.
class BatchWorker {
 public:
  BatchWorker(const process::Limits& limits, const job::Catalogue& catalogue,
              std::function<bool()> cancelled);

  /// What became of the task, whatever became of the process. A body that ends the process is given
  /// up, and the others of its file are done. Errors: `cancelled`, `internal` (no process can be
  /// started).
  Result<std::vector<PartDone>> work_on(FileTask task);

 private:
  process::Limits limits_;
  const job::Catalogue& catalogue_;
  std::function<bool()> cancelled_;
  process::Worker<FileTask, FileDone> worker_;
};

}  // namespace planish::batch
