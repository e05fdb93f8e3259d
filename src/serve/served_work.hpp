#pragma once

#include <planish/io/flat_writers.hpp>
#include <planish/job/artifact.hpp>
#include <planish/process/child_process.hpp>

#include <string>
#include <utility>
#include <vector>

namespace planish::serve {

/// A request as a worker gets it: the text of a request to `job::run`, and the files to write, each
/// with the artifact that goes there.
struct WorkTask {
  std::string request;
  std::vector<std::pair<std::string, std::string>> writes;  ///< artifact, path
};

/// What came of it.
struct WorkDone {
  std::string result;   ///< of the method, as JSON on one line
  std::string summary;  ///< in some lines for people
  bool refused = false;
  std::vector<OutputFile> files;  ///< to be written
};

/// In the worker. Errors: those of `job::run`; `bad_option` or `cannot_write` at "/write/dxf".
Result<WorkDone> work_on(const WorkTask& task, const job::Catalogue& catalogue,
                         const process::Parent& parent);

// What is sent. Reading gives nothing for other texts.
process::Texts texts_of(const WorkTask& task);
std::optional<WorkTask> task_in(const process::Texts& texts);
process::Texts texts_of(const Result<WorkDone>& done);
std::optional<Result<WorkDone>> done_in(const process::Texts& texts);

}  // namespace planish::serve
