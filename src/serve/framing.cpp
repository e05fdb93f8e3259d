#include "framing.hpp"

#include <planish/base/text.hpp>

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <utility>

// Messages from bytes: a line each, or behind headers with their length, as the first bytes tell.
// What is too long is read to its end and dropped, so the next message is found and memory stays
// bounded. Reading wakes at a pace to see whether to stop; a closed output is noticed without
// writing to it.

namespace planish::serve {
namespace {

constexpr int kPace = 100;  // ms

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r") == std::string_view::npos;
}

bool is_header(std::string_view line) { return lower_case(line.substr(0, 8)) == "content-"; }

/// The number in "Content-Length: 12".
std::optional<std::size_t> length_in(std::string_view line) {
  constexpr std::string_view kName = "content-length:";
  if (lower_case(line.substr(0, kName.size())) != kName) return std::nullopt;
  line.remove_prefix(kName.size());
  const auto first = line.find_first_not_of(" \t");
  if (first == std::string_view::npos) return std::nullopt;
  line.remove_prefix(first);
  std::size_t length = 0;
  const auto read = std::from_chars(line.data(), line.data() + line.size(), length);
  const std::string_view rest(read.ptr, static_cast<std::size_t>(line.end() - read.ptr));
  if (read.ec != std::errc() || !is_blank(rest)) return std::nullopt;
  return length;
}

}  // namespace

bool MessageReader::read_more() {
  constexpr std::size_t kPiece = 1U << 16;
  while (!ended_ && !stopped_()) {
    pollfd ready{input_, POLLIN, 0};
    const int events = ::poll(&ready, 1, kPace);
    if (events == 0 || (events < 0 && errno == EINTR)) continue;
    const std::size_t before = bytes_.size();
    bytes_.resize(before + kPiece);
    const ssize_t got = ::read(input_, bytes_.data() + before, kPiece);
    bytes_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got > 0) return true;
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    ended_ = true;
  }
  ended_ = true;
  return false;
}

std::optional<std::string> MessageReader::next_line() {
  std::size_t searched = 0;
  std::string begun;  // of a line that is too long
  for (;;) {
    const std::size_t end = bytes_.find('\n', searched);
    if (end != std::string::npos) {
      std::string line = begun.empty() ? bytes_.substr(0, end) : std::move(begun);
      bytes_.erase(0, end + 1);
      return line;
    }
    searched = bytes_.size();
    if (searched > longest_) {
      if (begun.empty()) begun = std::move(bytes_);
      bytes_.clear();
      searched = 0;
    }
    if (read_more()) continue;
    if (bytes_.empty() && begun.empty()) return std::nullopt;
    // The last line may do without an end.
    return begun.empty() ? std::exchange(bytes_, {}) : std::move(begun);
  }
}

Incoming MessageReader::behind_headers(const std::string& first) {
  std::optional<std::size_t> length;
  for (auto line = std::optional(first); line && !is_blank(*line); line = next_line())
    if (const auto told = length_in(*line)) length = told;
  if (!length) return {ended_ ? Incoming::Kind::end_of_input : Incoming::Kind::no_length};
  const bool too_long = *length > longest_;
  std::size_t left = *length;
  if (too_long) {
    while (left > bytes_.size()) {
      left -= bytes_.size();
      bytes_.clear();
      if (!read_more()) return {};
    }
    bytes_.erase(0, left);
    return {Incoming::Kind::too_long};
  }
  while (bytes_.size() < left)
    if (!read_more()) return {};
  Incoming message{Incoming::Kind::message, bytes_.substr(0, left)};
  bytes_.erase(0, left);
  return message;
}

Incoming MessageReader::next() {
  for (;;) {
    auto line = next_line();
    if (!line || stopped_()) return {};
    if (is_blank(*line)) continue;
    if (!framing_) framing_ = is_header(*line) ? Framing::headers : Framing::lines;
    if (*framing_ == Framing::headers) return behind_headers(*line);
    if (line->size() > longest_) return {Incoming::Kind::too_long};
    return {Incoming::Kind::message, std::move(*line)};
  }
}

void MessageWriter::use(Framing framing) {
  const std::lock_guard lock(mutex_);
  framing_ = framing;
}

void MessageWriter::send(std::string_view message) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  const std::string head = framing_ == Framing::headers
                               ? fmt::format("Content-Length: {}\r\n\r\n", message.size())
                               : "";
  const char* const end = framing_ == Framing::headers ? "" : "\n";
  closed_ = !write_all(head) || !write_all(message) || !write_all(end);
}

bool MessageWriter::write_all(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(output_, bytes.data(), bytes.size());
    if (written > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
      continue;
    }
    if (errno != EINTR && errno != EAGAIN) return false;
    pollfd ready{output_, POLLOUT, 0};
    ::poll(&ready, 1, kPace);
  }
  return true;
}

bool MessageWriter::is_closed() {
  // A pipe or socket whose other end is closed tells so unasked.
  pollfd state{output_, 0, 0};
  if (::poll(&state, 1, 0) > 0 && (state.revents & (POLLERR | POLLHUP | POLLNVAL)) != 0)
    return true;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  return lock && closed_;
}

}  // namespace planish::serve
