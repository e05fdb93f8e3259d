#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace planish::process {

/// What a process and its child tell each other: texts of any bytes. What they mean is agreed by
/// those who ask and answer.
using Texts = std::vector<std::string>;

/// Address space of a child, bytes (of a copy: beyond that of its parent): 4 GiB; 0, which is no
/// limit, where sanitizers reserve more.
std::uint64_t default_memory_limit();

/// What work in a child may take.
struct Limits {
  std::chrono::milliseconds time{std::chrono::minutes(2)};  ///< until its answer is there
  std::uint64_t memory = default_memory_limit();            ///< address space, bytes; 0: no limit
};

/// The process that asks, as its child reaches it while it works.
struct Parent {
  Progress progress;
  std::function<void(const Texts&)> note;
};

/// Does in the child what a question asks. An exception ends the child.
using Answering = std::function<Texts(const Texts& question, const Parent& parent)>;

/// How a child that gave no answer ended.
struct ChildEnd {
  enum class Cause { crashed, out_of_time, out_of_memory, cancelled };
  Cause cause = Cause::crashed;
  std::string reason = {};  ///< "segmentation fault", "assertion failed: …"; empty: the cause says
                            ///< it
  std::string stage = {};     ///< the one that it told last; empty: none
  std::string said = {};      ///< the end of what it printed as errors
  bool from_outside = false;  ///< by a signal that no program sends itself: another one, somebody,
                              ///< or the system, where its memory runs short
};

/// The error that stands for it: `crashed`, `out_of_time`, `out_of_memory` or `cancelled`. `input`
/// names what was worked on, `limits` what was allowed.
Error error_of(const ChildEnd& end, const std::string& input, const Limits& limits);

/// Why a child is taken for crashed whose answer nobody understands: a `reason`.
inline constexpr auto kDamagedAnswer = "its answer is damaged";

/// A process of its own for work that may crash, hang or need any amount of memory: whatever it
/// does, whoever asks gets an answer or learns how it ended. It ends with this object, or with the
/// process that made it, whichever is first. Its standard output leads nowhere. Linux alone.
class ChildProcess {
 public:
  /// A copy of this process as it is now, which answers by `answering`; costs about a millisecond.
  /// What it prints as errors is not shown: `ChildEnd::said`. No other thread may be in the midst
  /// of work with Planish or its CAD kernel, whose locks the copy would find taken for ever.
  /// Error: `internal` with the reason of the system.
  static Result<std::unique_ptr<ChildProcess>> copy(const Answering& answering,
                                                    std::uint64_t memory);
  /// This program again, with `arguments` and the number of this process as the last of them; it
  /// must call `answer_parent`. From any thread, which may end before the child. Its working
  /// directory is `folder`, its group its own: Ctrl-C in a terminal does not reach it.
  /// Error: `internal` with the reason of the system.
  static Result<std::unique_ptr<ChildProcess>> program(const std::vector<std::string>& arguments,
                                                       const std::filesystem::path& folder);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  /// Asks and waits for the answer, for `limit` at the most, or until `parent.progress` is
  /// cancelled; `parent` hears what the child tells meanwhile. Where no answer came the child is
  /// ended.
  tl::expected<Texts, ChildEnd> ask(const Texts& question, std::chrono::milliseconds limit,
                                    const Parent& parent = {});

  bool is_alive() const;

  /// Ends the process at once; a thread in `ask` learns that it crashed.
  void kill();

 private:
  ChildProcess(int process, int socket, int errors)
      : process_(process), socket_(socket), errors_(errors) {}

  int process_, socket_;
  int errors_;  ///< where its errors are read; −1: nowhere
};

/// What a program does that `ChildProcess::program` started for the process `parent`: it answers
/// until nobody asks any more, and returns its exit status. `after` is called each time that an
/// answer has been sent, when nobody waits for it; an exception of it ends the program.
int answer_parent(const std::string& parent, const Answering& answering,
                  const std::function<void()>& after = {},
                  std::uint64_t memory = default_memory_limit());

}  // namespace planish::process
