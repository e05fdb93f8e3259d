#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace planish::serve {

/// How messages lie in the stream: each on a line of its own, or behind headers of which one is
/// Content-Length (as language servers are talked to).
enum class Framing { lines, headers };

struct Incoming {
  enum class Kind {
    message,
    too_long,     ///< and left out
    no_length,    ///< headers without a Content-Length: where the next message begins is unknown
    end_of_input  ///< or nobody waits for answers any more
  };
  Kind kind = Kind::end_of_input;
  std::string text = {};
};

/// Takes messages from a descriptor. The first bytes say how they lie in it.
class MessageReader {
 public:
  /// `stopped` is asked every 100 ms.
  MessageReader(int input, std::size_t longest, std::function<bool()> stopped)
      : input_(input), longest_(longest), stopped_(std::move(stopped)) {}

  /// Waits for the next message; empty lines are none.
  Incoming next();
  Framing framing() const { return framing_.value_or(Framing::lines); }

 private:
  /// Whether there are more bytes now.
  bool read_more();
  /// A line without its end; empty at the end of input. Of one that is too long, its beginning.
  std::optional<std::string> next_line();
  Incoming behind_headers(const std::string& first);

  int input_;
  std::size_t longest_;
  std::function<bool()> stopped_;
  std::optional<Framing> framing_;
  std::string bytes_;
  bool ended_ = false;
};

/// Sends messages, each whole, from any thread.
class MessageWriter {
 public:
  explicit MessageWriter(int output) : output_(output) {}

  void use(Framing framing);
  void send(std::string_view message);
  /// Whether nobody reads any more.
  bool is_closed();

 private:
  bool write_all(std::string_view bytes);

  int output_;
  std::mutex mutex_;
  Framing framing_ = Framing::lines;
  bool closed_ = false;
};

}  // namespace planish::serve
