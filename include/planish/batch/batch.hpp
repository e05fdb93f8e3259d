#pragma once

#include <planish/base/progress.hpp>
#include <planish/batch/inputs.hpp>
#include <planish/job/child_process.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace planish::batch {

/// One of `of` machines that share a batch, counted from 1.
struct Shard {
  int number = 1, of = 1;
};

struct BatchOptions {
  std::vector<std::string> formats = {"dxf"};  ///< artifacts, and "json": the report
  std::string options = "{}";                  ///< JSON object, as in requests
  int workers = 1;
  job::Limits limits;  ///< of each input
  Shard shard;
};

/// How far a batch is.
struct BatchProgress {
  std::size_t done = 0, all = 0;  ///< inputs; `done` includes those of an earlier run
  std::size_t refused = 0;        ///< parts
  std::size_t resumed = 0;        ///< inputs that an earlier run had done
  double seconds = 0.0;           ///< of this run
};

struct BatchResult {
  std::size_t inputs = 0, resumed = 0;
  std::size_t parts = 0, ok = 0, warnings = 0, refused = 0;
};

/// A worker of a batch: answers what it is asked until nobody asks any more; its exit status.
int run_batch_worker(const std::string& parent, std::uint64_t memory,
                     const job::Catalogue& catalogue);

/// Works through the inputs with processes of their own, each doing many, and writes below `out`
/// (formats.md#batch): a folder for each part, `parts.jsonl`, `summary.csv`, `summary.json` and
/// `index.html`. An input whose worker ends or takes too long costs that input; the others go on.
/// What an earlier run did with the same content, options and version of the program is kept. The
/// result does not depend on the number of workers. Requires a program that calls
/// `run_batch_worker` for the arguments "batch-worker MEMORY PARENT". Errors: `cannot_read`,
/// `cannot_write`, `cancelled` (what is done is kept), `internal` (no process can be started).
Result<BatchResult> run_batch(const std::vector<Input>& inputs, const std::filesystem::path& out,
                              const BatchOptions& options, const job::Catalogue& catalogue,
                              const std::function<void(const BatchProgress&)>& report,
                              const std::function<bool()>& cancelled);

}  // namespace planish::batch
