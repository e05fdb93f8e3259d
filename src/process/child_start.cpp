#include "child_side.hpp"
#include "lasting_thread.hpp"
#include "refusals.hpp"

#include <planish/base/id_vector.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

// How a child process starts: as a copy of this one, or as the program again. Its descriptors are
// standard input, nowhere, its errors and the socket, and no others, so nothing that the parent
// holds open stays open in it. The program is started by a thread that lasts, because Linux ends a
// child with the thread that started it, not with the process.

namespace planish::process {
namespace {

tl::unexpected<Error> not_started(int reason) {
  return fail(refuse::not_started, {{"reason", std::strerror(reason)}});
}

/// A descriptor, closed at the end, and above those of standard input and output, which may be
/// closed.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int low) {
    constexpr int kFirst = kChildSocket;
    number_ = low < 0 || low >= kFirst ? low : fcntl(low, F_DUPFD_CLOEXEC, kFirst);
    if (number_ != low) close(low);
  }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }

  int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_ = -1;
};

struct BothEnds {
  Descriptor ours, theirs;
};

Result<BothEnds> socket_ends() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    return not_started(errno);
  return BothEnds{Descriptor(ends[0]), Descriptor(ends[1])};
}

Result<BothEnds> pipe_ends() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) return not_started(errno);
  return BothEnds{Descriptor(ends[0]), Descriptor(ends[1])};
}

/// In the child: its descriptors are standard input, nowhere, `errors` and `socket`, and no others.
void take_descriptors(int errors, int socket) {
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  dup2(socket, kChildSocket);
  close_range(kChildSocket + 1, ~0U, 0);
}

/// Bytes of address space that this process takes; 0 where it cannot be known.
std::uint64_t own_address_space() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// What posix_spawn is told, given back at the end.
class SpawnPlan {
 public:
  SpawnPlan(const std::filesystem::path& folder, int socket) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, socket, kChildSocket);
    posix_spawn_file_actions_addclosefrom_np(&actions_, kChildSocket + 1);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    // A group of its own: Ctrl-C in the terminal is for the parent, which then ends its children.
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

  /// 0, or the reason why not.
  int spawn(pid_t& process, std::vector<std::string> words) const {
    auto arguments = mapped(words, [&](std::string& word) { return word.data(); });
    arguments.push_back(nullptr);
    return posix_spawn(&process, "/proc/self/exe", &actions_, &attributes_, arguments.data(),
                       environ);
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace

Result<std::unique_ptr<ChildProcess>> ChildProcess::copy(const Answering& answering,
                                                         std::uint64_t memory) {
  auto sockets = socket_ends();
  if (!sockets) return tl::unexpected(sockets.error());
  auto errors = pipe_ends();
  if (!errors) return tl::unexpected(errors.error());
  // A copy has all that this process has, however much that is: what it may take comes on top.
  if (memory > 0) memory += own_address_space();
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process < 0) return not_started(errno);
  if (process == 0) {
    take_descriptors(errors->theirs.number(), sockets->theirs.number());
    // What the parent does when it ends (files to flush, objects of its own) is not for its copy.
    _exit(settle_in(parent, memory) ? answer_questions(kChildSocket, answering) : 1);
  }
  return std::unique_ptr<ChildProcess>(
      new ChildProcess(process, sockets->ours.release(), errors->ours.release()));
}

Result<std::unique_ptr<ChildProcess>> ChildProcess::program(
    const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
  auto sockets = socket_ends();
  if (!sockets) return tl::unexpected(sockets.error());
  std::vector<std::string> words{"planish"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.push_back(std::to_string(getpid()));
  pid_t process = 0;
  const SpawnPlan plan(folder, sockets->theirs.number());
  const int failed = LastingThread::of_process().run([&] { return plan.spawn(process, words); });
  if (failed != 0) return not_started(failed);
  return std::unique_ptr<ChildProcess>(new ChildProcess(process, sockets->ours.release(), -1));
}

}  // namespace planish::process
