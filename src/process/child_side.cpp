#include "child_side.hpp"

#include "messages.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <new>

// The child's side: it answers questions until its socket closes. It dies with its parent, leaves
// Ctrl-C to it, has no handlers of the process that it was copied from, and is limited in memory.
// An exception is an answer too. Each new stage is told at once, so that the parent knows where a
// crash came; shares within one stage only at a pace.

namespace planish::process {
namespace {

void limit(int resource, rlim_t most) {
  const rlimit value{most, most};
  setrlimit(static_cast<__rlimit_resource>(resource), &value);
}

/// Each new stage goes to the parent at once, so that it knows where a crash came; shares of one
/// stage no more often than anybody reads them.
class StageTeller {
 public:
  explicit StageTeller(int socket) : socket_(socket) {}

  void operator()(std::string_view stage, double share) {
    static constexpr std::chrono::milliseconds kPace(50);
    const Moment now = std::chrono::steady_clock::now();
    if (stage == stage_ && now - last_ < kPace) return;
    last_ = now;
    stage_ = stage;
    send_message(socket_, {MessageKind::stage, {stage_, fmt::format("{}", share)}});
  }

 private:
  int socket_;
  std::string stage_;
  Moment last_;
};

Message answered(int socket, const Answering& answering, const Texts& question) {
  Parent parent;
  parent.progress.report = StageTeller(socket);
  parent.note = [socket](const Texts& note) { send_message(socket, {MessageKind::note, note}); };
  try {
    return {MessageKind::answer, answering(question, parent)};
  } catch (const std::bad_alloc&) {
    return {MessageKind::failed, {}};
  } catch (const std::exception& defect) {
    return {MessageKind::failed, {defect.what()}};
  } catch (...) {
    return {MessageKind::failed, {"an exception of unknown type"}};
  }
}

}  // namespace

std::uint64_t default_memory_limit() {
#if defined(__SANITIZE_ADDRESS__)
  return 0;  // it reserves far more than it uses
#else
  return std::uint64_t{4} << 30;
#endif
}

bool settle_in(long parent, std::uint64_t memory) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) return false;  // it may have ended before the line above
  std::signal(SIGINT, SIG_IGN);           // the parent ends it
  // Whoever was copied may have handlers of its own, which know nothing of this process.
  for (const int signal : {SIGTERM, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP})
    std::signal(signal, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  if (memory > 0) limit(RLIMIT_AS, memory);
  return true;
}

int answer_questions(int socket, const Answering& answering, const std::function<void()>& after) {
  while (const auto question = receive_message(socket)) {
    if (question->kind != MessageKind::question) return 1;
    const Message answer = answered(socket, answering, question->texts);
    const auto sent = send_message(socket, answer);
    // Longer than a message may be.
    if (!sent && sent.error() != MessageFailure::garbled) return 1;
    if (!sent && !send_message(socket, {MessageKind::failed, {}})) return 1;
    if (after) after();
  }
  return 0;
}

int answer_parent(const std::string& parent, const Answering& answering,
                  const std::function<void()>& after, std::uint64_t memory) {
  constexpr int kDecimal = 10;
  if (!settle_in(std::strtol(parent.c_str(), nullptr, kDecimal), memory)) return 1;
  return answer_questions(kChildSocket, answering, after);
}

}  // namespace planish::process
