#include <planish/process/worker.hpp>

// A process kept from task to task. One that failed is not asked again: the next task starts
// another. With a time for each step, every note of the child begins it anew; the wait is then
// ended by cancelling, which is told as lateness unless somebody did cancel. Another thread may
// kill it at any time, so a task holds the child that it asked.

namespace planish::process {

Starting program_again(std::vector<std::string> arguments,
                       std::optional<std::filesystem::path> folder) {
  return [arguments = std::move(arguments), folder = std::move(folder)] {
    return ChildProcess::program(arguments, folder ? *folder : std::filesystem::current_path());
  };
}

Result<void> WorkerProcess::begin() {
  if (is_alive()) return {};
  auto started = starting_();
  if (!started) return pass_on(started);
  replace(std::move(*started));
  done_ = 0;
  return {};
}

bool WorkerProcess::is_alive() const {
  const auto now = child();
  return now && now->is_alive();
}

void WorkerProcess::kill() {
  const std::lock_guard lock(mutex_);
  if (child_) child_->kill();
}

void WorkerProcess::end() { replace(nullptr); }

tl::expected<Texts, ChildEnd> WorkerProcess::asked(const Texts& question, const Asking& asking) {
  using Clock = std::chrono::steady_clock;
  using Cause = ChildEnd::Cause;
  const auto asked_child = child();
  // Somebody may have ended it since it began.
  if (!asked_child) return tl::unexpected(ChildEnd{Cause::crashed, "it was ended"});
  Clock::time_point until = Clock::now() + asking.time;
  Parent parent = asking.parent;
  const auto is_cancelled = [&] {
    const auto& cancelled = asking.parent.progress.cancelled;
    return cancelled && cancelled();
  };
  if (asking.by_step) {
    parent.note = [&](const Texts& note) {
      until = Clock::now() + asking.time;
      if (asking.parent.note) asking.parent.note(note);
    };
    parent.progress.cancelled = [&] { return is_cancelled() || Clock::now() > until; };
  }
  constexpr std::chrono::hours kAnyTime(24 * 365);
  auto answer = asked_child->ask(question, asking.by_step ? kAnyTime : asking.time, parent);
  if (answer) {
    ++done_;
    return answer;
  }
  end();
  ChildEnd& how = answer.error();
  if (asking.by_step && how.cause == Cause::cancelled && !is_cancelled())
    how.cause = Cause::out_of_time;
  return answer;
}

std::shared_ptr<ChildProcess> WorkerProcess::child() const {
  const std::lock_guard lock(mutex_);
  return child_;
}

void WorkerProcess::replace(std::shared_ptr<ChildProcess> child) {
  {
    const std::lock_guard lock(mutex_);
    child_.swap(child);
  }
  // The previous process is waited for without holding the lock.
}

}  // namespace planish::process
