#include "connections.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace planish::studio {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// A socket that is read until a deadline.
class TimedStream : public httplib::Stream {
 public:
  /// `stopped`: whether the server is to end, when it waits no longer.
  TimedStream(socket_t socket, std::function<bool()> stopped)
      : socket_(socket), stopped_(std::move(stopped)) {}

  void allow(Clock::duration time) { deadline_ = Clock::now() + time; }
  /// Bytes read so far.
  std::size_t count() const { return count_; }

  bool is_readable() const override { return at_ < filled_ || waits_for(POLLIN); }
  bool is_writable() const override { return waits_for(POLLOUT); }
  ssize_t read(char* to, std::size_t size) override;
  ssize_t write(const char* from, std::size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override { here(ip, port); }
  void get_local_ip_and_port(std::string& ip, int& port) const override { here(ip, port); }
  socket_t socket() const override { return socket_; }

 private:
  /// Both ends are on this machine; nothing asks for the port.
  static void here(std::string& ip, int& port) {
    ip = "127.0.0.1";
    port = 0;
  }
  bool waits_for(short event) const;

  socket_t socket_;
  std::function<bool()> stopped_;
  Clock::time_point deadline_ = Clock::time_point::max();
  std::array<char, 4096> buffer_{};  // headers are read by the byte
  std::size_t at_ = 0, filled_ = 0, count_ = 0;
};

bool TimedStream::waits_for(short event) const {
  constexpr milliseconds kLook{100};  // how soon a server that ends is noticed
  auto end = Clock::now() + ConnectionServer::kIdle;
  if (event == POLLIN) end = std::min(end, deadline_);  // work may take longer than the request
  while (!stopped_()) {
    const auto left = std::chrono::ceil<milliseconds>(end - Clock::now());
    if (left.count() <= 0) return false;
    pollfd waited{socket_, event, 0};
    const int ready = ::poll(&waited, 1, static_cast<int>(std::min(left, kLook).count()));
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) return false;
  }
  return false;
}

ssize_t TimedStream::read(char* to, std::size_t size) {
  if (at_ == filled_) {
    if (!waits_for(POLLIN)) return -1;
    const ssize_t got = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
    if (got <= 0) return got;
    at_ = 0;
    filled_ = static_cast<std::size_t>(got);
  }
  const std::size_t count = std::min(size, filled_ - at_);
  std::copy_n(buffer_.data() + at_, count, to);
  at_ += count;
  count_ += count;
  return static_cast<ssize_t>(count);
}

ssize_t TimedStream::write(const char* from, std::size_t size) {
  return waits_for(POLLOUT) ? ::send(socket_, from, size, MSG_NOSIGNAL) : -1;
}

/// Nothing where the request does not say it by one plain number.
std::optional<std::size_t> size_of_body(const httplib::Request& request) {
  constexpr auto kLength = "Content-Length";
  if (request.has_header("Transfer-Encoding")) return std::nullopt;
  const auto lengths = request.get_header_value_count(kLength);
  if (lengths == 0) return 0;
  const std::string text = request.get_header_value(kLength);
  std::size_t size = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), size);
  if (lengths > 1 || read.ec != std::errc() || read.ptr != text.data() + text.size())
    return std::nullopt;
  return size;
}

}  // namespace

void ConnectionThreads::enqueue(std::function<void()> work) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(work));
  if (idle_ < waiting_.size() && threads_.size() < kMost) threads_.emplace_back([this] { run(); });
  changed_.notify_one();
}

void ConnectionThreads::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    ++idle_;
    changed_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
    --idle_;
    if (waiting_.empty()) return;
    const auto work = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    work();
    lock.lock();
  }
}

void ConnectionThreads::shutdown() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_)
    if (thread.joinable()) thread.join();
}

bool ConnectionServer::process_and_close_socket(socket_t socket) {
  TimedStream stream(socket, [this] { return svr_sock_ == INVALID_SOCKET; });
  bool done = true, goes_on = true;
  for (int left = kMostRequests; goes_on && left > 0; --left) {
    stream.allow(kHeaders);
    if (!stream.is_readable()) break;
    stream.allow(kHeaders);
    std::optional<std::size_t> end;  // of the request, in the bytes of the connection
    bool closed = false;
    done = process_request(stream, left == 1, closed, [&](httplib::Request& request) {
      stream.allow(kRequest);
      if (const auto body = size_of_body(request)) end = stream.count() + *body;
    });
    goes_on = done && !closed && end == stream.count();
  }
  ::shutdown(socket, SHUT_RDWR);
  ::close(socket);
  return done;
}

}  // namespace planish::studio
