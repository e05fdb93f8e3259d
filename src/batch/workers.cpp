#include "workers.hpp"

#include "refusals.hpp"

#include <planish/batch/batch.hpp>
#include <planish/batch/codes.hpp>

#include <string>
#include <utility>

// A worker's process, and what becomes of a file that ends it. The body that began last is blamed:
// the file is tried again without it, and the reason becomes that body's report. If none had begun,
// the whole file is refused. A signal from outside may have nothing to do with the part, so it is
// tried once more first. Every try leaves out one more body, so this ends.

namespace planish::batch {
namespace {

using process::ChildEnd;

/// What a report says of a part whose worker was lost.
Error error_of_part(const ChildEnd& end, const std::string& input, const process::Limits& limits) {
  if (end.from_outside)
    return planish::error_of(refuse::ended_from_outside, {{"input", input}, {"reason", end.reason}},
                             input);
  Error error = process::error_of(end, input, limits);
  if (end.cause == ChildEnd::Cause::crashed) error.code = code::worker_died;
  if (end.cause == ChildEnd::Cause::out_of_time) error.code = code::time_limit;
  return error;
}

}  // namespace

BatchWorker::BatchWorker(const process::Limits& limits, const job::Catalogue& catalogue,
                         std::function<bool()> cancelled)
    : limits_(limits),
      catalogue_(catalogue),
      cancelled_(std::move(cancelled)),
      worker_(process::program_again({"batch-worker", std::to_string(limits.memory)}),
              file_done_in) {}

Result<std::vector<PartDone>> BatchWorker::work_on(FileTask task) {
  bool tried_again = false;
  for (;;) {
    if (const auto begun = worker_.begin(); !begun) return pass_on(begun);
    std::optional<int> body;  // begun last
    std::vector<PartDone> parts;
    const auto hear = [&](const process::Texts& note) {
      if (const auto begun = body_in(note)) body = begun;
      if (auto part = part_in(note)) parts.push_back(std::move(*part));
    };
    // Each body, and the reading of the file, has the time that the limits allow.
    const auto done = worker_.work_on(task,
                                      {.time = limits_.time,
                                       .parent = {{.report = {}, .cancelled = cancelled_}, hear},
                                       .by_step = true});
    if (done) return parts;
    const ChildEnd& end = done.error();
    // What ended it may have had nothing to do with the part.
    if (end.from_outside && !std::exchange(tried_again, true)) continue;
    const Error error = error_of_part(end, task.name, limits_);
    if (end.cause == ChildEnd::Cause::cancelled) return tl::unexpected(error);
    if (body && task.given_up.emplace(*body, error).second) continue;
    return std::vector{failed_part(task, catalogue_, error)};
  }
}

int run_batch_worker(const std::string& parent, std::uint64_t memory,
                     const job::Catalogue& catalogue) {
  const auto perform = [&](const FileTask& task, const process::Parent& asking) {
    work_on(task, catalogue,
            {.begins = [&](int body) { asking.note(beginning(body)); },
             .done = [&](PartDone part) { asking.note(texts_of(part)); },
             .progress = asking.progress});
    return FileDone();
  };
  return process::answer_parent(parent, process::answering<FileTask>(task_in, perform), {}, memory);
}

}  // namespace planish::batch
