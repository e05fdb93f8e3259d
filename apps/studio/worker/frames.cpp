#include "frames.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>

namespace planish::studio {
namespace {

constexpr std::size_t kHead = 5;
constexpr std::uint32_t kLongest = 1U << 30;  // bytes; far more than any answer

/// Milliseconds left, rounded up; −1: no limit.
int patience(std::optional<Moment> until) {
  if (!until) return -1;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(*until -
                                                                 std::chrono::steady_clock::now())
                        .count();
  return left > 0 ? static_cast<int>(left) : 0;
}

using Done = tl::expected<void, FrameFailure>;

/// Waits until the socket is ready for `event`.
Done wait_for(int socket, short event, std::optional<Moment> until) {
  for (;;) {
    pollfd ready{socket, event, 0};
    const int events = ::poll(&ready, 1, patience(until));
    if (events < 0 && errno == EINTR) continue;
    if (events > 0) return {};
    return tl::unexpected(events < 0 ? FrameFailure::ended : FrameFailure::late);
  }
}

Done send_bytes(int socket, const char* bytes, std::size_t count, std::optional<Moment> until) {
  while (count > 0) {
    if (auto ready = wait_for(socket, POLLOUT, until); !ready) return ready;
    const ssize_t sent = ::send(socket, bytes, count, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (sent <= 0) return tl::unexpected(FrameFailure::ended);
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return {};
}

Done receive_bytes(int socket, char* bytes, std::size_t count, std::optional<Moment> until) {
  while (count > 0) {
    if (auto ready = wait_for(socket, POLLIN, until); !ready) return ready;
    const ssize_t got = ::recv(socket, bytes, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return tl::unexpected(FrameFailure::ended);
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
  return {};
}

/// Two lines, followed by content of any bytes.
std::string with_lines(std::string_view first, std::string_view second, std::string_view content) {
  std::string text;
  text.reserve(first.size() + second.size() + content.size() + 2);
  text.append(first).append("\n").append(second).append("\n").append(content);
  return text;
}

struct Lines {
  std::string first, second, content;
};

std::optional<Lines> lines_of(const std::string& text) {
  const std::size_t one = text.find('\n');
  if (one == std::string::npos) return std::nullopt;
  const std::size_t two = text.find('\n', one + 1);
  if (two == std::string::npos) return std::nullopt;
  return Lines{text.substr(0, one), text.substr(one + 1, two - one - 1), text.substr(two + 1)};
}

}  // namespace

tl::expected<void, FrameFailure> send_frame(int socket, const Frame& frame,
                                            std::optional<Moment> until) {
  std::array<char, kHead> head{};
  const auto length = static_cast<std::uint32_t>(frame.content.size());
  head[0] = static_cast<char>(frame.kind);
  std::memcpy(head.data() + 1, &length, sizeof length);
  if (auto sent = send_bytes(socket, head.data(), kHead, until); !sent) return sent;
  return send_bytes(socket, frame.content.data(), frame.content.size(), until);
}

tl::expected<Frame, FrameFailure> receive_frame(int socket, std::optional<Moment> until) {
  std::array<char, kHead> head{};
  if (const auto got = receive_bytes(socket, head.data(), kHead, until); !got)
    return tl::unexpected(got.error());
  std::uint32_t length = 0;
  std::memcpy(&length, head.data() + 1, sizeof length);
  if (length > kLongest) return tl::unexpected(FrameFailure::ended);
  Frame frame{static_cast<FrameKind>(head[0]), std::string(length, '\0')};
  if (const auto got = receive_bytes(socket, frame.content.data(), length, until); !got)
    return tl::unexpected(got.error());
  return frame;
}

Frame task_frame(const Task& task) {
  return {FrameKind::task, with_lines(task.verb, task.argument, task.body)};
}

Frame progress_frame(const Stage& stage) {
  return {FrameKind::progress, with_lines(fmt::format("{}", stage.share), "", stage.name)};
}

Frame answer_frame(const Answer& answer) {
  return {FrameKind::answer,
          with_lines(fmt::format("{}", answer.status), answer.type, answer.body)};
}

std::optional<Task> task_of(const Frame& frame) {
  auto lines = lines_of(frame.content);
  if (frame.kind != FrameKind::task || !lines) return std::nullopt;
  return Task{std::move(lines->first), std::move(lines->second), std::move(lines->content)};
}

std::optional<Stage> stage_of(const Frame& frame) {
  auto lines = lines_of(frame.content);
  if (frame.kind != FrameKind::progress || !lines) return std::nullopt;
  double share = 0.0;
  const std::string& text = lines->first;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), share);
  if (read.ec != std::errc()) return std::nullopt;
  return Stage{std::move(lines->content), share};
}

std::optional<Answer> answer_of(const Frame& frame) {
  auto lines = lines_of(frame.content);
  if (frame.kind != FrameKind::answer || !lines) return std::nullopt;
  int status = 0;
  const std::string& text = lines->first;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), status);
  if (read.ec != std::errc() || status < 200 || status > 599) return std::nullopt;
  return Answer{status, std::move(lines->second), std::move(lines->content)};
}

}  // namespace planish::studio
