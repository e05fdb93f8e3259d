#include "crew.hpp"

#include "refusals.hpp"

#include <planish/process/worker.hpp>

#include <exception>
#include <string>
#include <utility>

// Threads that each keep a process and take the next ticket. A process that ran out of memory may
// have filled it with earlier requests, so the ticket is tried again in a fresh one; if that too
// fails, or it failed for any other reason, that is the answer. A new process is started before the
// next ticket needs it.

namespace planish::serve {
namespace {

using process::ChildEnd;

using ServeWorker = process::Worker<WorkTask, Result<WorkDone>>;

Result<WorkDone> work_on(ServeWorker& worker, process::Limits limits, const Ticket& ticket,
                         const std::atomic<bool>& ends) {
  limits.time = ticket.time;
  for (;;) {
    if (const auto begun = worker.begin(); !begun) return pass_on(begun);
    const bool fresh = worker.done() == 0;
    std::string input = "the input";
    const process::Parent parent{
        .progress = {.report = ticket.progress,
                     .cancelled = [&] { return ticket.cancelled.load() || ends.load(); }},
        .note = [&](const process::Texts& note) { input = note.empty() ? input : note.front(); }};
    auto done = worker.work_on(ticket.task, {.time = limits.time, .parent = parent});
    if (done) return std::move(*done);
    const ChildEnd& end = done.error();
    const bool full = end.cause == ChildEnd::Cause::out_of_memory && !end.from_outside;
    if (!full || fresh) return tl::unexpected(error_of(end, input, limits));
  }
}

/// Memory may be short here too.
Result<WorkDone> tried(ServeWorker& worker, const process::Limits& limits, const Ticket& ticket,
                       const std::atomic<bool>& ends) {
  try {
    return work_on(worker, limits, ticket, ends);
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
  ServeWorker worker(process::program_again({"serve-worker", std::to_string(limits_.memory)}),
                     done_in);
  // A process is there before it is needed, where one will be.
  if (at_once) (void)worker.begin();
  while (const auto ticket = next()) {
    ticket->done(ticket->cancelled ? fail(refuse::stopped)
                                   : tried(worker, limits_, *ticket, ends_));
    if (!ends_) (void)worker.begin();
    const std::lock_guard lock(mutex_);
    --open_;
  }
}

}  // namespace planish::serve
