#include "workers.hpp"

#include <cstdlib>
#include <filesystem>

namespace planish::batch {
namespace {

using job::ChildEnd;

/// What a report says of a part whose worker was lost.
Error error_of_part(const ChildEnd& end, const std::string& input, const job::Limits& limits) {
  Error error = job::error_of(end, input, limits);
  if (end.cause == ChildEnd::Cause::crashed) error.code = ErrorCode::worker_died;
  if (end.cause == ChildEnd::Cause::out_of_time) error.code = ErrorCode::time_limit;
  return error;
}

}  // namespace

tl::expected<job::Texts, ChildEnd> Worker::ask(const FileTask& task, std::optional<int>& body) {
  job::Parent parent;
  parent.progress.cancelled = cancelled_;
  parent.note = [&](const job::Texts& note) {
    body = note.empty() ? std::nullopt : std::optional(std::atoi(note.front().c_str()));
  };
  auto answer = child_->ask(texts_of(task), limits_.time, parent);
  if (!answer) child_.reset();
  return answer;
}

Result<std::vector<PartDone>> Worker::work_on(FileTask task) {
  for (;;) {
    if (!child_ || !child_->is_alive()) {
      auto child = job::ChildProcess::program({"batch-worker", std::to_string(limits_.memory)},
                                              std::filesystem::current_path());
      if (!child) return tl::unexpected(child.error());
      child_ = std::move(*child);
    }
    std::optional<int> body;
    auto answer = ask(task, body);
    std::optional<std::vector<PartDone>> parts;
    if (answer) parts = parts_in(*answer);
    if (parts) return std::move(*parts);
    const ChildEnd end = answer ? ChildEnd{ChildEnd::Cause::crashed, job::kDamagedAnswer}
                                : answer.error();
    child_.reset();
    const Error error = error_of_part(end, task.name, limits_);
    if (end.cause == ChildEnd::Cause::cancelled) return tl::unexpected(error);
    // A body that ends the process, or takes all the time, is left out of the next try.
    if (body && task.given_up.emplace(*body, error).second) continue;
    return std::vector{failed_part(task, catalogue_, error)};
  }
}

}  // namespace planish::batch
