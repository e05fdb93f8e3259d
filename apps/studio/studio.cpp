#include "studio.hpp"

#include "server/access.hpp"
#include "server/browser.hpp"
#include "server/first_document.hpp"
#include "server/http_server.hpp"
#include "server/kept_files.hpp"
#include "server/presence.hpp"
#include "server/temp_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace planish::studio {
namespace {

/// Later threads leave these signals to the thread that waits for them.
sigset_t held_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

/// Waits for one of the signals or, with `end_after`, until no page has been open for so long.
void wait_for_end(const sigset_t& signals, const StudioOptions& options, const Presence& presence) {
  constexpr timespec kLook{1, 0};
  if (!options.end_after) {
    int signal = 0;
    sigwait(&signals, &signal);
    return;
  }
  while (presence.absence() < *options.end_after)
    if (sigtimedwait(&signals, nullptr, &kLook) > 0) return;
}

/// The file that the user named; where nobody sees standard error, the browser says why it cannot
/// be opened.
Result<void> open_named(DocumentStore& store, const StudioOptions& options,
                        const TempFolder& folder) {
  if (!options.file) return {};
  auto opened = open_first(store, *options.file);
  if (!opened && options.open_browser && isatty(STDERR_FILENO) == 0)
    say_in_browser(opened.error().message, folder.path());
  return opened;
}

}  // namespace

Result<void> run_studio(const StudioOptions& options) {
  auto folder = TempFolder::make();
  if (!folder) return pass_on(folder);
  DocumentStore store(folder->path(), options.time_limit);
  if (auto opened = open_named(store, options, *folder); !opened) return opened;
  // From here on the signals are waited for; until now they could end the process at once.
  const sigset_t signals = held_signals();
  auto token = random_token();
  if (!token) return pass_on(token);
  HttpServer server;
  const auto port = server.bind(options.port);
  if (!port) return pass_on(port);
  const Access access(*port, *token);
  KeptFiles kept(kept_folder());
  Api api(access, store, kept);
  Presence presence;
  server.serve(api, options.end_after ? &presence : nullptr);
  const std::string address = fmt::format("http://127.0.0.1:{}/#{}", *port, *token);
  fmt::print("{}\n", address);
  std::fflush(stdout);
  if (options.open_browser) open_in_browser(address, folder->path());
  wait_for_end(signals, options, presence);
  store.close_all();
  { const TempFolder removed(std::move(*folder)); }
  // A normal exit would wait for connections that browsers keep open.
  std::_Exit(EXIT_SUCCESS);
}

}  // namespace planish::studio
