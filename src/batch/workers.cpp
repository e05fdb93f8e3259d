#include "workers.hpp"

#include "refusals.hpp"
#include "worker_talk.hpp"

#include <planish/batch/batch.hpp>
#include <planish/batch/codes.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <utility>

namespace planish::batch {
namespace {

using process::ChildEnd;

const process::Texts kDone{"done"};

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

std::optional<ChildEnd> Worker::ask(const FileTask& task, Heard& heard) {
  using Clock = std::chrono::steady_clock;
  Clock::time_point until = Clock::now() + limits_.time;
  process::Parent parent;
  parent.note = [&](const process::Texts& note) {
    until = Clock::now() + limits_.time;
    if (const auto body = body_in(note)) heard.body = body;
    if (auto part = part_in(note)) heard.parts.push_back(std::move(*part));
  };
  const auto late = [&] { return Clock::now() > until; };
  parent.progress.cancelled = [&] { return cancelled_() || late(); };
  const auto answer = child_->ask(texts_of(task), std::chrono::hours(24 * 365), parent);
  if (answer && *answer == kDone) return std::nullopt;
  if (answer) return ChildEnd{ChildEnd::Cause::crashed, process::kDamagedAnswer};
  ChildEnd end = answer.error();
  if (end.cause == ChildEnd::Cause::cancelled && !cancelled_())
    end.cause = ChildEnd::Cause::out_of_time;
  return end;
}

Result<void> Worker::begin() {
  if (child_ && child_->is_alive()) return {};
  auto child = process::ChildProcess::program({"batch-worker", std::to_string(limits_.memory)},
                                              std::filesystem::current_path());
  if (!child) return pass_on(child);
  child_ = std::move(*child);
  return {};
}

Result<std::vector<PartDone>> Worker::work_on(FileTask task) {
  bool tried_again = false;
  for (;;) {
    if (const auto begun = begin(); !begun) return pass_on(begun);
    Heard heard;
    const auto end = ask(task, heard);
    if (!end) return std::move(heard.parts);
    child_.reset();
    // What ended it may have had nothing to do with the part.
    if (end->from_outside && !std::exchange(tried_again, true)) continue;
    const Error error = error_of_part(*end, task.name, limits_);
    if (end->cause == ChildEnd::Cause::cancelled) return tl::unexpected(error);
    // A body that ends the process, or takes all the time, is left out of the next try.
    if (heard.body && task.given_up.emplace(*heard.body, error).second) continue;
    return std::vector{failed_part(task, catalogue_, error)};
  }
}

int run_batch_worker(const std::string& parent, std::uint64_t memory,
                     const job::Catalogue& catalogue) {
  const auto answering = [&](const process::Texts& question, const process::Parent& asking) {
    const auto task = task_in(question);
    if (!task) return process::Texts{};
    work_on(*task, catalogue,
            {.begins = [&](int body) { asking.note(beginning(body)); },
             .done = [&](PartDone part) { asking.note(texts_of(part)); },
             .progress = asking.progress});
    return kDone;
  };
  return process::answer_parent(parent, answering, {}, memory);
}

}  // namespace planish::batch
