#include "../studio.hpp"
#include "../work/workbench.hpp"
#include "frames.hpp"
#include "worker_limits.hpp"

#include <malloc.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>

namespace planish::studio {
namespace {

void limit(int resource, rlim_t most) {
  const rlimit value{most, most};
  setrlimit(static_cast<__rlimit_resource>(resource), &value);
}

/// Makes this worker end with the server that started it; false if the server has already ended.
bool bound_to_server(long server) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  return getppid() == server;  // the server may have ended before the line above
}

/// Memory that one draft frees the next one needs again. If it went back to the system in between,
/// each page would fault.
void keep_memory() {
  constexpr int kMost = 256 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that is allowed
  mallopt(M_TRIM_THRESHOLD, kMost);
}

/// Sends stages to the server, but no more often than anyone can read.
Progress reported_to(int socket) {
  static constexpr std::chrono::milliseconds kPace(50);
  Progress progress;
  progress.report = [socket, last = Moment()](std::string_view stage, double share) mutable {
    const Moment now = std::chrono::steady_clock::now();
    if (now - last < kPace) return;
    last = now;
    send_frame(socket, progress_frame({std::string(stage), share}));
  };
  return progress;
}

}  // namespace

int run_worker(const std::string& server) {
  if (!bound_to_server(std::strtol(server.c_str(), nullptr, 10))) return 1;
  std::signal(SIGINT, SIG_IGN);
  limit(RLIMIT_CORE, 0);
  if (kMostMemory > 0) limit(RLIMIT_AS, kMostMemory);
  keep_memory();
  Workbench bench(".");
  while (const auto frame = receive_frame(kWorkerSocket)) {
    const auto task = task_of(*frame);
    if (!task) return 1;
    const Answer answer = bench.perform(*task, reported_to(kWorkerSocket));
    if (!send_frame(kWorkerSocket, answer_frame(answer))) return 1;
  }
  return 0;
}

}  // namespace planish::studio
