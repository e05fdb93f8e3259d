#include "conversation.hpp"
#include "refusals.hpp"

#include <planish/process/worker.hpp>
#include <planish/serve/serve.hpp>

#include <csignal>
#include <thread>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

// The loop of `planish serve`: read, hand over, until the client says so, the input ends or nobody
// reads any more. No more is read while many requests wait, so a client that only writes is slowed
// down and memory stays bounded. At the end of input all that was asked is answered.

namespace planish::serve {
namespace {

constexpr std::size_t kLongestMessage = std::size_t{256} << 20U;  // bytes
constexpr std::size_t kMostWaiting = 1000;                        // requests, before more are read
constexpr std::chrono::milliseconds kDrainPace(20);

/// Waits until few enough requests are open.
void wait_for(const Conversation& conversation, std::size_t open,
              const std::function<bool()>& stopped) {
  while (conversation.open() > open && !stopped())
    std::this_thread::sleep_for(kDrainPace);
}

void converse(MessageReader& reader, MessageWriter& writer, Conversation& conversation,
              const std::function<bool()>& stopped) {
  while (!conversation.exit_status() && !stopped()) {
    wait_for(conversation, kMostWaiting, stopped);
    Incoming incoming = reader.next();
    writer.use(reader.framing());
    switch (incoming.kind) {
      case Incoming::Kind::message:
        conversation.take(incoming.text);
        break;
      case Incoming::Kind::too_long:
        conversation.refuse(error_of(refuse::too_long, {}));
        break;
      case Incoming::Kind::no_length:
        conversation.refuse(error_of(refuse::no_length, {}));
        [[fallthrough]];
      case Incoming::Kind::end_of_input:
        return wait_for(conversation, 0, stopped);
    }
  }
}

}  // namespace

int serve(int input, int output, const ServeOptions& options, const job::Catalogue& catalogue,
          const std::function<bool()>& interrupted) {
  std::signal(SIGPIPE, SIG_IGN);
  MessageWriter writer(output);
  const auto stopped = [&] { return interrupted() || writer.is_closed(); };
  MessageReader reader(input, kLongestMessage, stopped);
  Conversation conversation(writer, options, catalogue);
  converse(reader, writer, conversation, stopped);
  return conversation.exit_status().value_or(interrupted() ? 1 : 0);
}

int run_serve_worker(const std::string& parent, std::uint64_t memory,
                     const job::Catalogue& catalogue) {
  const auto perform = [&](const WorkTask& task, const process::Parent& asking) {
    return work_on(task, catalogue, asking);
  };
  const auto give_back = [] {
#if defined(__GLIBC__)
    malloc_trim(0);
#endif
  };
  return process::answer_parent(parent, process::answering<WorkTask>(task_in, perform), give_back,
                                memory);
}

}  // namespace planish::serve
