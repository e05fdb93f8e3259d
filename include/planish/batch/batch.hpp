#pragma once

#include <planish/base/progress.hpp>
#include <planish/batch/inputs.hpp>
#include <planish/process/child_process.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace planish::batch {

/// One of `of` shares of a batch, counted from 1.
struct Shard {
  int number = 1, of = 1;
};

struct BatchOptions {
  std::vector<std::string> formats = {"dxf"};  ///< artifacts, and "json": the report
  std::string options = "{}";                  ///< JSON object, as in requests
  int workers = 1;
  process::Limits limits;  ///< `time` of each body, `memory` of each worker
  Shard shard;             ///< an input falls to the share that the hash of its content says
};

/// How far a batch is.
struct BatchProgress {
  std::size_t done = 0, all = 0;  ///< inputs; `done` includes those of an earlier run
  std::size_t refused = 0;        ///< parts, of this run
  std::size_t resumed = 0;        ///< inputs that an earlier run had done
  double seconds = 0.0;           ///< of this run
};

/// Parts that were refused for the same reason.
struct RefusedFor {
  std::string code, message;
  std::string first;  ///< one of them
  std::size_t count = 1;
};
/// Counts one more part.
void count_refused(std::vector<RefusedFor>& all, const RefusedFor& one);

struct BatchResult {
  std::size_t inputs = 0;   ///< of this shard
  std::size_t resumed = 0;  ///< inputs that an earlier run had done
  std::size_t left = 0;     ///< inputs of earlier runs that are asked for no more; their files stay
  std::size_t parts = 0, ok = 0, warnings = 0, refused = 0;
  std::size_t distinct = 0;             ///< parts made, identical ones counted once
  std::vector<RefusedFor> refused_for;  ///< in the order of the parts
  PassedOver passed_over;
  std::vector<std::string> notes;  ///< rows of `materials` that no part is meant by (not of shards)
  std::filesystem::path out;       ///< the folder that was written
};

/// What ends work that was cancelled, and that goes on where it was when it is asked for again.
Error interruption();

/// A worker of a batch: answers what it is asked until nobody asks any more; its exit status.
int run_batch_worker(const std::string& parent, std::uint64_t memory,
                     const job::Catalogue& catalogue);

/// Works through the inputs with processes of their own, each doing many, and writes below `out`
/// (formats.md#batch), or for one shard of several below `out`/shard-i-of-n: a folder for each
/// part, `parts.jsonl`, `summary.csv`, `summary.json` and `index.html`. An input whose worker ends
/// or takes too long costs that input; the others go on. What an earlier run did with the same
/// content, options and version of the program is kept. The result does not depend on the number of
/// workers or on what was done before. Requires a program that calls `run_batch_worker` for the
/// arguments "batch-worker MEMORY PARENT". Errors: those of the options, also where no part can be
/// made with them, before any work; `cannot_read`, `cannot_write`, `cancelled` (what is done is
/// kept), `internal` (no process can be started).
Result<BatchResult> run_batch(const Inputs& inputs, const std::filesystem::path& out,
                              const BatchOptions& options, const job::Catalogue& catalogue,
                              const std::function<void(const BatchProgress&)>& report,
                              const std::function<bool()>& cancelled);

/// Makes one result of those of all shards of a batch: what a run without shards writes, to the
/// byte. `folders` are those of the shards, or hold them. Files of parts are links to those of the
/// shards where the file system allows it. Errors: `cannot_read` (no results of a batch, shards
/// that are missing, unfinished or of different batches), `cannot_write`, `cancelled`.
Result<BatchResult> merge_batches(const std::vector<std::filesystem::path>& folders,
                                  const std::filesystem::path& out,
                                  const std::function<void(const BatchProgress&)>& report,
                                  const std::function<bool()>& cancelled);

}  // namespace planish::batch
