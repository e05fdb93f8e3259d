#pragma once

#include <planish/process/child_process.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace planish::process {

/// What goes over the socket pair between process and child. A message is its kind (one byte), the
/// length of its content (four bytes, of this machine's order) and its texts, each behind its
/// length.
enum class MessageKind : std::uint8_t { question = 1, stage = 2, note = 3, answer = 4, failed = 5 };

struct Message {
  MessageKind kind = MessageKind::question;
  Texts texts;
};

using Moment = std::chrono::steady_clock::time_point;

enum class MessageFailure { ended, garbled, late, cancelled };

/// How long somebody waits at a socket, and what is listened to meanwhile.
struct Waiting {
  std::optional<Moment> until = std::nullopt;
  std::function<bool()> cancelled = nullptr;
  int errors = -1;         ///< descriptor that is read meanwhile; −1: none
  std::string heard = {};  ///< the end of what it said
};

/// Reads what `waiting.errors` holds now.
void listen(Waiting& waiting);

/// `ended`: nobody listens any more; `late`: not all of it was taken before `waiting.until`;
/// `garbled`: it is longer than a message may be.
tl::expected<void, MessageFailure> send_message(int socket, const Message& message,
                                                Waiting& waiting);
tl::expected<void, MessageFailure> send_message(int socket, const Message& message);

/// The next message. `ended`: the other side is gone; `garbled`: it sent what is no message.
tl::expected<Message, MessageFailure> receive_message(int socket, Waiting& waiting);
tl::expected<Message, MessageFailure> receive_message(int socket);

}  // namespace planish::process
