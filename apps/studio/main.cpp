#include "studio.hpp"

#include <terminal.hpp>

#include <cstdio>
#include <cstdlib>
#include <string_view>

// What `planish studio` goes on as, and what that starts as its workers:
//   planish-studio serve FILE PORT SECONDS END browser|no-browser
//                        the first four may be empty, which leaves the usual
//   planish-studio studio-worker SERVER

int main(int argc, char** argv) {
  using namespace planish;
  const std::string_view task = argc > 1 ? argv[1] : "";
  if (task == "studio-worker" && argc == 3) return studio::run_worker(argv[2]);
  if (task != "serve" || argc != 7) {
    std::fputs("planish: start the studio by `planish studio`\n", stderr);
    return 2;
  }
  studio::StudioOptions options;
  if (*argv[2] != '\0') options.file = argv[2];
  if (*argv[3] != '\0') options.port = std::atoi(argv[3]);
  if (*argv[4] != '\0') options.time_limit = std::chrono::seconds(std::atoi(argv[4]));
  if (*argv[5] != '\0') options.end_after = std::chrono::seconds(std::atoi(argv[5]));
  options.open_browser = std::string_view(argv[6]) == "browser";
  const auto done = studio::run_studio(options);
  return done ? 0 : cli::complain(done.error());
}
