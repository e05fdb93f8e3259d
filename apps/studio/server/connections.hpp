#pragma once

#include <httplib.h>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

namespace planish::studio {

/// A thread for each open connection, up to `kMost`: a connection on which nothing comes keeps its
/// own thread waiting, and no request of another. Threads stay for connections to come.
class ConnectionThreads : public httplib::TaskQueue {
 public:
  static constexpr std::size_t kMost = 512;
  ~ConnectionThreads() override { shutdown(); }
  void enqueue(std::function<void()> work) override;
  void shutdown() override;

 private:
  void run();
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> waiting_;
  std::vector<std::thread> threads_;
  std::size_t idle_ = 0;
  bool ended_ = false;
};

/// A server whose connections carry one request after the other, as long as each is read to its
/// end (the unread rest of a rejected one would be taken for the next). They end by themselves:
/// after `kIdle` without data, when headers take longer than `kHeaders`, a whole request longer
/// than `kRequest`, or after `kMostRequests`.
class ConnectionServer : public httplib::Server {
 public:
  static constexpr std::chrono::seconds kIdle{5}, kHeaders{10}, kRequest{120};
  static constexpr int kMostRequests = 10'000;

 private:
  bool process_and_close_socket(socket_t socket) override;
};

}  // namespace planish::studio
