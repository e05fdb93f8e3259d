#pragma once

#include <planish/job/artifact.hpp>
#include <planish/process/child_process.hpp>

#include <functional>
#include <string>

namespace planish::serve {

struct ServeOptions {
  int jobs = 1;            ///< requests at a time, each in a process of its own
  process::Limits limits;  ///< of each request; `bend` has its search time on top
  std::string version;     ///< of the program, as clients are told it
};

/// Answers requests (docs/serve.md), JSON-RPC 2.0 and Model Context Protocol, until the client says
/// `exit`, its messages end and all are answered, nobody reads the answers any more, or
/// `interrupted`. Returns the exit status: 0, or 1 for `exit` without `shutdown` and for
/// `interrupted`. The work is done by processes that this program is started again for, as
/// `serve-worker MEMORY PARENT`. Ignores SIGPIPE from then on.
int serve(int input, int output, const ServeOptions& options, const job::Catalogue& catalogue,
          const std::function<bool()>& interrupted);

/// What this program does as a worker; returns the exit status.
int run_serve_worker(const std::string& parent, std::uint64_t memory,
                     const job::Catalogue& catalogue);

}  // namespace planish::serve
