#include "crew.hpp"

#include "refusals.hpp"

#include <planish/base/packed_error.hpp>

#include <exception>
#include <filesystem>
#include <utility>

namespace planish::serve {
namespace {

using process::ChildEnd;

/// A process, and how much it has done.
class ServeWorker {
 public:
  explicit ServeWorker(const process::Limits& limits) : limits_(limits) {}

  Result<void> begin() {
    if (child_ && child_->is_alive()) return {};
    auto child = process::ChildProcess::program({"serve-worker", std::to_string(limits_.memory)},
                                                std::filesystem::current_path());
    if (!child) return pass_on(child);
    child_ = std::move(*child);
    done_ = 0;
    return {};
  }

  Result<WorkDone> work_on(const Ticket& ticket, const std::atomic<bool>& ends) {
    for (;;) {
      if (const auto begun = begin(); !begun) return pass_on(begun);
      process::Limits limits = limits_;
      limits.time = ticket.time;
      std::string input = "the input";
      const process::Parent parent{
          .progress = {.report = ticket.progress,
                       .cancelled = [&] { return ticket.cancelled.load() || ends.load(); }},
          .note = [&](const process::Texts& note) { input = note.empty() ? input : note.front(); }};
      const auto answer = child_->ask(texts_of(ticket.task), limits.time, parent);
      if (!answer) {
        child_.reset();
        // It may be what earlier requests left behind that fills its memory.
        const bool full = answer.error().cause == ChildEnd::Cause::out_of_memory &&
                          !answer.error().from_outside;
        if (full && std::exchange(done_, 0) > 0) continue;
        return tl::unexpected(error_of(answer.error(), input, limits));
      }
      ++done_;
      if (auto error = unpacked(*answer)) return tl::unexpected(std::move(*error));
      if (auto done = done_in(*answer)) return std::move(*done);
      child_.reset();
      return tl::unexpected(
          error_of({ChildEnd::Cause::crashed, process::kDamagedAnswer}, input, limits));
    }
  }

 private:
  process::Limits limits_;
  std::unique_ptr<process::ChildProcess> child_;
  int done_ = 0;
};

/// Memory may be short here too.
Result<WorkDone> tried(ServeWorker& worker, const Ticket& ticket, const std::atomic<bool>& ends) {
  try {
    return worker.work_on(ticket, ends);
  } catch (const std::exception& defect) {
    return fail(refuse::worker_defect, {{"reason", defect.what()}});
  }
}

}  // namespace

Crew::Crew(int jobs, const process::Limits& limits) : limits_(limits) {
  for (int i = 0; i < jobs; ++i)
    threads_.emplace_back([this, i] { work(i == 0); });
}

Crew::~Crew() {
  {
    const std::lock_guard lock(mutex_);  // nobody is about to wait
    ends_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_)
    thread.join();
}

void Crew::add(std::shared_ptr<Ticket> ticket) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(ticket));
    ++open_;
  }
  changed_.notify_one();
}

std::size_t Crew::open() const {
  const std::lock_guard lock(mutex_);
  return open_;
}

std::shared_ptr<Ticket> Crew::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
  if (ends_) return nullptr;
  auto ticket = std::move(waiting_.front());
  waiting_.pop_front();
  return ticket;
}

void Crew::work(bool at_once) {
  ServeWorker worker(limits_);
  // A process is there before it is needed, where one will be.
  if (at_once) (void)worker.begin();
  while (const auto ticket = next()) {
    ticket->done(ticket->cancelled ? fail(refuse::stopped) : tried(worker, *ticket, ends_));
    if (!ends_) (void)worker.begin();
    const std::lock_guard lock(mutex_);
    --open_;
  }
}

}  // namespace planish::serve
