#include "messages.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

// Messages over a socket: a byte for the kind, the length, then texts, each after its own length.
// Neither side trusts the other: a kind that is none, a length beyond a gigabyte or texts that do
// not fill it are a damaged message, and memory is taken in pieces, as bytes come. While one side
// waits it looks at the time, asks whether to stop, and keeps the end of what the child says on
// standard error.

namespace planish::process {
namespace {

constexpr std::size_t kHeadBytes = 5;
constexpr std::uint32_t kLongestMessage = 1U << 30;  // bytes; no answer comes near it
constexpr std::size_t kKeptErrors = 1U << 16;        // bytes: a sanitizer's report
constexpr std::chrono::milliseconds kCancelPace(50);

using Sent = tl::expected<void, MessageFailure>;

/// Milliseconds left, rounded up, but not more than until one asks again whether to stop; −1 for
/// ever.
int milliseconds_of(const Waiting& waiting) {
  const int pace = waiting.cancelled ? static_cast<int>(kCancelPace.count()) : -1;
  if (!waiting.until) return pace;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(*waiting.until -
                                                                 std::chrono::steady_clock::now())
                        .count();
  const int whole = static_cast<int>(std::clamp<std::int64_t>(left, 0, 1 << 30));
  return pace < 0 ? whole : std::min(whole, pace);
}

bool is_late(const Waiting& waiting) {
  return waiting.until && std::chrono::steady_clock::now() >= *waiting.until;
}

/// Until the socket is ready for `event`.
Sent wait_for(int socket, short event, Waiting& waiting) {
  for (;;) {
    if (waiting.cancelled && waiting.cancelled()) return tl::unexpected(MessageFailure::cancelled);
    std::array<pollfd, 2> ready{pollfd{socket, event, 0}, pollfd{waiting.errors, POLLIN, 0}};
    const int events = ::poll(ready.data(), ready.size(), milliseconds_of(waiting));
    if (events < 0 && errno != EINTR) return tl::unexpected(MessageFailure::ended);
    if (events > 0 && ready[1].revents != 0) listen(waiting);
    // In time alone: who sends without end would never be late.
    if (is_late(waiting)) return tl::unexpected(MessageFailure::late);
    if (events > 0 && ready[0].revents != 0) return {};
  }
}

Sent send_bytes(int socket, const char* bytes, std::size_t count, Waiting& waiting) {
  while (count > 0) {
    if (auto ready = wait_for(socket, POLLOUT, waiting); !ready) return ready;
    const ssize_t sent = ::send(socket, bytes, count, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (sent <= 0) return tl::unexpected(MessageFailure::ended);
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return {};
}

Sent receive_bytes(int socket, char* bytes, std::size_t count, Waiting& waiting) {
  while (count > 0) {
    if (auto ready = wait_for(socket, POLLIN, waiting); !ready) return ready;
    const ssize_t got = ::recv(socket, bytes, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return tl::unexpected(MessageFailure::ended);
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
  return {};
}

/// In pieces: who sends a length need not send so much.
Sent receive_content(int socket, std::string& content, std::uint32_t length, Waiting& waiting) {
  constexpr std::uint32_t kPiece = 1U << 22;
  while (content.size() < length) {
    const std::size_t before = content.size();
    const std::size_t more = std::min<std::size_t>(kPiece, length - before);
    content.resize(before + more);
    if (auto got = receive_bytes(socket, content.data() + before, more, waiting); !got) return got;
  }
  return {};
}

void append_number(std::string& bytes, std::uint32_t number) {
  std::array<char, sizeof number> raw{};
  std::memcpy(raw.data(), &number, sizeof number);
  bytes.append(raw.data(), raw.size());
}

std::uint32_t number_at(const char* bytes) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

std::optional<Texts> texts_in(const std::string& content) {
  Texts texts;
  std::size_t at = 0;
  while (at < content.size()) {
    if (content.size() - at < sizeof(std::uint32_t)) return std::nullopt;
    const std::uint32_t length = number_at(content.data() + at);
    at += sizeof length;
    if (content.size() - at < length) return std::nullopt;
    texts.emplace_back(content, at, length);
    at += length;
  }
  return texts;
}

bool is_kind(char byte) {
  return byte >= static_cast<char>(MessageKind::question) &&
         byte <= static_cast<char>(MessageKind::failed);
}

}  // namespace

void listen(Waiting& waiting) {
  std::array<char, 4096> bytes{};
  const ssize_t got = waiting.errors < 0 ? 0 : ::read(waiting.errors, bytes.data(), bytes.size());
  if (got < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (got <= 0) {
    waiting.errors = -1;
    return;
  }
  waiting.heard.append(bytes.data(), static_cast<std::size_t>(got));
  if (waiting.heard.size() > kKeptErrors)
    waiting.heard.erase(0, waiting.heard.size() - kKeptErrors);
}

Sent send_message(int socket, const Message& message, Waiting& waiting) {
  std::uint64_t length = 0;
  for (const std::string& text : message.texts)
    length += sizeof(std::uint32_t) + text.size();
  if (length > kLongestMessage) return tl::unexpected(MessageFailure::garbled);
  // Short texts go together: each piece sent wakes the other side.
  constexpr std::size_t kTogether = 1U << 16;
  std::string bytes(1, static_cast<char>(message.kind));
  append_number(bytes, static_cast<std::uint32_t>(length));
  for (const std::string& text : message.texts) {
    append_number(bytes, static_cast<std::uint32_t>(text.size()));
    if (bytes.size() + text.size() <= kTogether) {
      bytes += text;
      continue;
    }
    if (auto sent = send_bytes(socket, bytes.data(), bytes.size(), waiting); !sent) return sent;
    if (auto sent = send_bytes(socket, text.data(), text.size(), waiting); !sent) return sent;
    bytes.clear();
  }
  return send_bytes(socket, bytes.data(), bytes.size(), waiting);
}

Sent send_message(int socket, const Message& message) {
  Waiting for_ever;
  return send_message(socket, message, for_ever);
}

tl::expected<Message, MessageFailure> receive_message(int socket, Waiting& waiting) {
  std::array<char, kHeadBytes> head{};
  if (const auto got = receive_bytes(socket, head.data(), kHeadBytes, waiting); !got)
    return tl::unexpected(got.error());
  const std::uint32_t length = number_at(head.data() + 1);
  if (!is_kind(head[0]) || length > kLongestMessage) return tl::unexpected(MessageFailure::garbled);
  std::string content;
  if (const auto got = receive_content(socket, content, length, waiting); !got)
    return tl::unexpected(got.error());
  auto texts = texts_in(content);
  if (!texts) return tl::unexpected(MessageFailure::garbled);
  return Message{static_cast<MessageKind>(head[0]), std::move(*texts)};
}

tl::expected<Message, MessageFailure> receive_message(int socket) {
  Waiting for_ever;
  return receive_message(socket, for_ever);
}

}  // namespace planish::process
