#include "worker_process.hpp"

#include "lasting_thread.hpp"
#include "worker_limits.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

namespace planish::studio {
namespace {

Error not_started(int reason) {
  return {ErrorCode::internal,
          fmt::format("no worker could be started: {}", std::strerror(reason)),
          {}};
}

/// Settings for posix_spawn, released at the end.
class SpawnPlan {
 public:
  SpawnPlan(const std::filesystem::path& folder, int socket) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, socket, kWorkerSocket);
    posix_spawn_file_actions_addclosefrom_np(&actions_, kWorkerSocket + 1);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    // A group of its own: Ctrl-C in the terminal is for the server, which then ends its workers.
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;
  ~SpawnPlan() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  /// 0, or the error number.
  int spawn(pid_t& process) const {
    std::string name = "planish", command = "studio-worker", server = std::to_string(getpid());
    std::array<char*, 4> arguments{name.data(), command.data(), server.data(), nullptr};
    return posix_spawn(&process, "/proc/self/exe", &actions_, &attributes_, arguments.data(),
                       environ);
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace

Result<std::unique_ptr<WorkerProcess>> WorkerProcess::start(const std::filesystem::path& folder) {
  std::array<int, 2> sockets{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0)
    return tl::unexpected(not_started(errno));
  pid_t process = 0;
  const SpawnPlan plan(folder, sockets[1]);
  const int failed = LastingThread::of_process().run([&] { return plan.spawn(process); });
  close(sockets[1]);
  if (failed == 0) return std::unique_ptr<WorkerProcess>(new WorkerProcess(process, sockets[0]));
  close(sockets[0]);
  return tl::unexpected(not_started(failed));
}

WorkerProcess::~WorkerProcess() {
  kill();
  close(socket_);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool WorkerProcess::is_alive() const {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == 0;
}

void WorkerProcess::kill() { ::kill(process_, SIGKILL); }

tl::expected<Answer, WorkerEnd> WorkerProcess::ask(const Task& task, std::chrono::seconds limit,
                                                   const std::function<void(Stage)>& report) {
  const Moment until = std::chrono::steady_clock::now() + limit;
  const auto lost = [this](FrameFailure failure) {
    kill();
    return tl::unexpected(failure == FrameFailure::late ? WorkerEnd::late : WorkerEnd::died);
  };
  if (const auto sent = send_frame(socket_, task_frame(task), until); !sent)
    return lost(sent.error());
  for (;;) {
    const auto frame = receive_frame(socket_, until);
    if (!frame) return lost(frame.error());
    if (auto stage = stage_of(*frame)) {
      report(std::move(*stage));
      continue;
    }
    if (auto answer = answer_of(*frame)) return std::move(*answer);
    return lost(FrameFailure::ended);
  }
}

}  // namespace planish::studio
