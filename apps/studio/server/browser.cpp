#include "browser.hpp"

#include <planish/base/text.hpp>
#include <planish/io/flat_writers.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace planish::studio {
namespace {

bool has_desktop() { return std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY"); }

/// In a session of its own, so that the browser outlives the studio.
void start_apart(std::string program, std::string argument) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK);
  std::array<char*, 3> arguments{program.data(), argument.data(), nullptr};
  pid_t process = 0;
  const int failed = posix_spawnp(&process, program.c_str(), &actions, &attributes,
                                  arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (failed == 0) std::thread([process] { waitpid(process, nullptr, 0); }).detach();
}

}  // namespace

void open_in_browser(const std::string& address, const std::filesystem::path& folder) {
  if (!has_desktop()) return;
  const auto file = folder / "open.html";
  const std::string text = fmt::format(
      "<!doctype html><meta charset=\"utf-8\"><title>planish studio</title><meta "
      "http-equiv=\"refresh\" content=\"0; url={0}\">"
      "<a href=\"{0}\">planish studio</a>\n",
      address);
  if (write_file(file, text)) start_apart("xdg-open", file.string());
}

void say_in_browser(const std::string& sentence, const std::filesystem::path& folder) {
  constexpr std::chrono::seconds kReading{10};
  if (!has_desktop()) return;
  const auto file = folder / "open.html";
  const std::string text = fmt::format(
      "<!doctype html><meta charset=\"utf-8\"><title>planish studio</title>"
      "<body style=\"font: 1.2em sans-serif; margin: 3em\"><h1>planish studio</h1><p>{}\n",
      replaced(sentence, {{'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}}));
  if (!write_file(file, text)) return;
  start_apart("xdg-open", file.string());
  std::this_thread::sleep_for(kReading);
}

}  // namespace planish::studio
