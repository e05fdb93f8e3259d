#include "lasting_thread.hpp"

#include <csignal>
#include <thread>

namespace planish::process {

LastingThread& LastingThread::of_process() {
  static auto* const one = new LastingThread();  // never ended, and so never destroyed
  return *one;
}

LastingThread::LastingThread() {
  std::thread([this] { work_on(); }).detach();
}

int LastingThread::run(std::function<int()> work) {
  std::packaged_task<int()> task(std::move(work));
  std::future<int> result = task.get_future();
  {
    const std::lock_guard lock(mutex_);
    tasks_.push(std::move(task));
  }
  changed_.notify_one();
  return result.get();
}

void LastingThread::work_on() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);  // signals are for others
  for (;;) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !tasks_.empty(); });
    std::packaged_task<int()> task = std::move(tasks_.front());
    tasks_.pop();
    lock.unlock();
    task();
  }
}

}  // namespace planish::process
