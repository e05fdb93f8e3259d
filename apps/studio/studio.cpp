#include "studio.hpp"

#include "server/access.hpp"
#include "server/browser.hpp"
#include "server/first_document.hpp"
#include "server/http_server.hpp"
#include "server/temp_folder.hpp"

#include <fmt/format.h>

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

}  // namespace

Result<void> run_studio(const StudioOptions& options) {
  auto folder = TempFolder::make();
  if (!folder) return tl::unexpected(folder.error());
  DocumentStore store(folder->path(), options.time_limit);
  if (options.file)
    if (auto opened = open_first(store, *options.file); !opened) return opened;
  // From here on the signals are waited for; until now they could end the process at once.
  const sigset_t signals = held_signals();
  auto token = random_token();
  if (!token) return tl::unexpected(token.error());
  HttpServer server;
  const auto port = server.bind(options.port);
  if (!port) return tl::unexpected(port.error());
  const Access access(*port, *token);
  Api api(access, store);
  server.serve(api);
  const std::string address = fmt::format("http://127.0.0.1:{}/#{}", *port, *token);
  fmt::print("{}\n", address);
  std::fflush(stdout);
  if (options.open_browser) open_in_browser(address, folder->path());
  int signal = 0;
  sigwait(&signals, &signal);
  store.close_all();
  { const TempFolder removed(std::move(*folder)); }
  // A normal exit would wait for connections that browsers keep open.
  std::_Exit(EXIT_SUCCESS);
}

}  // namespace planish::studio
