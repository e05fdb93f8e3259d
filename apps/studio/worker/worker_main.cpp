#include "../studio.hpp"
#include "../work/workbench.hpp"
#include "worker.hpp"

#include <malloc.h>

namespace planish::studio {
namespace {

/// Memory that one draft frees the next one needs again. If it went back to the system in between,
/// each page would fault. What was read of a large file goes back once, at rest.
void keep_memory() {
  constexpr int kMost = 256 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that is allowed
  mallopt(M_TRIM_THRESHOLD, kMost);
}

}  // namespace

int run_worker(const std::string& server) {
  keep_memory();
  Workbench bench(".");
  const auto perform = [&](const Task& task, const process::Parent& parent) {
    return bench.perform(task, parent.progress);
  };
  const auto rest = [&] {
    if (bench.rest()) malloc_trim(0);
  };
  return process::answer_parent(server, process::answering<Task>(task_of, perform), rest);
}

}  // namespace planish::studio
