#pragma once

#include "../work/answer.hpp"
#include "frames.hpp"

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <memory>

namespace planish::studio {

/// Why a worker gave no answer.
enum class WorkerEnd { died, late };

/// A process that works on one document: this program again, as `planish studio-worker`. It ends
/// with this object or with the server, whichever comes first.
class WorkerProcess {
 public:
  /// Its working directory is `folder`. Error: `internal` with the reason of the system.
  static Result<std::unique_ptr<WorkerProcess>> start(const std::filesystem::path& folder);
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;
  ~WorkerProcess();

  /// Sends a task and waits for its answer, for at most `limit`. After `died` or `late` the worker
  /// is gone.
  tl::expected<Answer, WorkerEnd> ask(const Task& task, std::chrono::seconds limit,
                                      const std::function<void(Stage)>& report);

  bool is_alive() const;

  /// Ends the process at once; a thread in `ask` gets `died`.
  void kill();

 private:
  WorkerProcess(pid_t process, int socket) : process_(process), socket_(socket) {}

  pid_t process_;
  int socket_;
};

}  // namespace planish::studio
