#include "messages.hpp"
#include "refusals.hpp"

#include <planish/base/text.hpp>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <thread>

// A question to a child process, and how it ended if no answer came. Whatever goes wrong kills the
// child, so no state is left between questions. The cause is told by the first sign: the time was
// over, the parent cancelled, the answer was damaged; else the process is waited for, and its
// signal or the assertion in its last words says why. A kill from outside mostly is the system's,
// where memory runs short.

namespace planish::process {
namespace {

using Cause = ChildEnd::Cause;

/// "assertion failed: …" of what a child said as it ended; empty where it says nothing of the kind.
std::string assertion_in(const std::string& said) {
  const std::size_t at = said.rfind("assertion failed: ");
  if (at == std::string::npos) return {};
  return said.substr(at, said.find('\n', at) - at);
}

/// How a process ended that was waited for: cause and reason.
ChildEnd end_of(const siginfo_t& info, const std::string& said) {
  ChildEnd end;
  end.reason = assertion_in(said);
  if (!end.reason.empty()) return end;
  if (info.si_code == CLD_EXITED) {
    end.reason = fmt::format("exit status {}", info.si_status);
    return end;
  }
  const int signal = info.si_status;
  end.from_outside = signal == SIGKILL || signal == SIGTERM || signal == SIGHUP;
  if (signal == SIGKILL) end.cause = Cause::out_of_memory;
  end.reason = lower_case(strsignal(signal));
  return end;
}

/// How a process ended whose socket is closed; empty where it lives on.
std::optional<siginfo_t> waited_for(pid_t process) {
  constexpr std::chrono::milliseconds kPace(1), kPatience(1000);
  for (auto waited = kPace; waited < kPatience; waited += kPace) {
    siginfo_t info{};
    if (waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        info.si_pid != 0)
      return info;
    std::this_thread::sleep_for(kPace);
  }
  return std::nullopt;
}

/// Tells a parent what its child tells it.
void pass_on(const Message& message, const Parent& parent, std::string& stage) {
  if (message.kind == MessageKind::note && parent.note) parent.note(message.texts);
  if (message.kind != MessageKind::stage || message.texts.size() != 2) return;
  const std::string& share = message.texts[1];
  double value = 0.0;
  const auto read = std::from_chars(share.data(), share.data() + share.size(), value);
  if (read.ec != std::errc()) return;
  stage = message.texts[0];
  parent.progress.at(stage, value);
}

std::string words_of(std::chrono::milliseconds time) {
  return fmt::format("{} s", std::chrono::duration<double>(time).count());
}

std::string words_of(std::uint64_t bytes) {
  constexpr double kMebi = 1U << 20U;
  return fmt::format("{:.0f} MiB", static_cast<double>(bytes) / kMebi);
}

}  // namespace

ChildProcess::~ChildProcess() {
  kill();
  close(socket_);
  if (errors_ >= 0) close(errors_);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool ChildProcess::is_alive() const {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == 0;
}

void ChildProcess::kill() { ::kill(process_, SIGKILL); }

tl::expected<Texts, ChildEnd> ChildProcess::ask(const Texts& question,
                                                std::chrono::milliseconds limit,
                                                const Parent& parent) {
  Waiting waiting;
  waiting.until = std::chrono::steady_clock::now() + limit;
  waiting.cancelled = parent.progress.cancelled;
  waiting.errors = errors_;
  std::string stage;
  const auto ended = [&](ChildEnd end) {
    kill();
    end.stage = stage;
    end.said = waiting.heard;
    return tl::unexpected(std::move(end));
  };
  const auto lost = [&](MessageFailure failure) {
    if (failure == MessageFailure::late) return ended({Cause::out_of_time});
    if (failure == MessageFailure::cancelled) return ended({Cause::cancelled});
    if (failure == MessageFailure::garbled) return ended({Cause::crashed, kDamagedAnswer});
    const auto info = waited_for(process_);
    if (!info) return ended({Cause::crashed, "it closed its socket"});
    for (std::size_t before = 1; before != waiting.heard.size();) {
      before = waiting.heard.size();
      listen(waiting);
    }
    return ended(end_of(*info, waiting.heard));
  };
  if (const auto sent = send_message(socket_, {MessageKind::question, question}, waiting); !sent)
    return lost(sent.error());
  for (;;) {
    auto message = receive_message(socket_, waiting);
    if (!message) return lost(message.error());
    if (message->kind == MessageKind::answer) return std::move(message->texts);
    if (message->kind == MessageKind::question) return lost(MessageFailure::garbled);
    if (message->kind == MessageKind::failed) {
      if (message->texts.empty()) return ended({Cause::out_of_memory});
      return ended({Cause::crashed, message->texts.front()});
    }
    pass_on(*message, parent, stage);
  }
}

Error error_of(const ChildEnd& end, const std::string& input, const Limits& limits) {
  const std::string during = end.stage.empty() ? "" : fmt::format(" at \"{}\"", end.stage);
  switch (end.cause) {
    case Cause::cancelled:
      return planish::error_of(refuse::child_cancelled, {});
    case Cause::out_of_time:
      return planish::error_of(
          refuse::child_out_of_time,
          {{"input", input}, {"time", words_of(limits.time)}, {"during", during}}, input);
    case Cause::out_of_memory:
      return planish::error_of(
          refuse::child_out_of_memory,
          {{"input", input},
           {"memory",
            limits.memory > 0 ? "the " + words_of(limits.memory) + " allowed" : "there is"},
           {"during", during}},
          input);
    case Cause::crashed:
      break;
  }
  const bool ours = end.reason.starts_with("assertion failed");
  return planish::error_of(ours ? refuse::child_asserted : refuse::child_crashed,
                           {{"input", input}, {"during", during}, {"reason", end.reason}}, input);
}

}  // namespace planish::process
