#pragma once

#include <planish/process/child_process.hpp>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace planish::process {

/// Starts the process of a worker, and limits its memory.
using Starting = std::function<Result<std::unique_ptr<ChildProcess>>()>;

/// This program again, by `ChildProcess::program`. Without a folder it works in the one that the
/// program works in when the process is started.
Starting program_again(std::vector<std::string> arguments,
                       std::optional<std::filesystem::path> folder = std::nullopt);

/// What a task may take, and who hears of it meanwhile.
struct Asking {
  std::chrono::milliseconds time;
  Parent parent = {};
  /// Whether each note of the process begins `time` anew: it is the time of a step.
  bool by_step = false;
};

/// The task of a copy of this process, which knows what to do.
struct AsAgreed {};
inline Texts texts_of(const AsAgreed&) { return {}; }

/// The process of a `Worker`, whatever its tasks are.
class WorkerProcess {
 public:
  explicit WorkerProcess(Starting starting) : starting_(std::move(starting)) {}
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// Starts a process unless there is one. Errors: those of starting it.
  Result<void> begin();
  bool is_alive() const;
  /// How many tasks the process has answered.
  int done() const { return done_; }

  /// Ends the process at once; a task that it works on is lost. From any thread.
  void kill();
  /// The same, and waits until the system has cleared up after it.
  void end();

 protected:
  /// A process that answers may be asked again; one that does not is ended. Requires `begin`.
  tl::expected<Texts, ChildEnd> asked(const Texts& question, const Asking& asking);

 private:
  std::shared_ptr<ChildProcess> child() const;
  void replace(std::shared_ptr<ChildProcess> child);

  Starting starting_;
  mutable std::mutex mutex_;  ///< of `child_`, held for a moment only
  std::shared_ptr<ChildProcess> child_;
  int done_ = 0;
};

/// A process that does one task after another: it lasts from task to task, and is replaced by the
/// next `begin` once it has ended. `texts_of(Task)` says what is sent. One thread gives it tasks.
template <typename Task, typename Done>
class Worker : public WorkerProcess {
 public:
  /// Reads an answer; empty for texts that are none.
  using Reading = std::optional<Done> (*)(const Texts&);

  Worker(Starting starting, Reading reading)
      : WorkerProcess(std::move(starting)), reading_(reading) {}

  /// What came of the task, or how the process ended; it is gone then. Requires `begin`.
  tl::expected<Done, ChildEnd> work_on(const Task& task, const Asking& asking) {
    auto texts = asked(texts_of(task), asking);
    if (!texts) return tl::unexpected(std::move(texts.error()));
    if (auto done = reading_(*texts)) return std::move(*done);
    end();
    return tl::unexpected(ChildEnd{ChildEnd::Cause::crashed, kDamagedAnswer});
  }

 private:
  Reading reading_;
};

/// The other side of a `Worker`: reads each task, does it, and sends what `texts_of` makes of the
/// result; nothing for texts that are no task.
template <typename Task, typename Perform>
Answering answering(std::optional<Task> (*reading)(const Texts&), Perform perform) {
  return [reading, perform = std::move(perform)](const Texts& question, const Parent& parent) {
    const std::optional<Task> task = reading(question);
    return task ? texts_of(perform(*task, parent)) : Texts{};
  };
}

}  // namespace planish::process
