#include "../studio.hpp"
#include "../work/workbench.hpp"
#include "worker.hpp"

#include <malloc.h>

#include <stdexcept>

namespace planish::studio {
namespace {

/// What one draft gives back the next one takes again. If the system had it in between, each page
/// of it would be a fault.
void keep_memory() {
  constexpr int kMost = 256 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that is allowed
  mallopt(M_TRIM_THRESHOLD, kMost);
}

}  // namespace

int run_worker(const std::string& server) {
  keep_memory();
  Workbench bench(".");
  const auto answering = [&](const job::Texts& question, const job::Parent& parent) {
    const auto task = task_of(question);
    if (!task) throw std::invalid_argument("a question that is no task");
    return texts_of(bench.perform(*task, parent.progress));
  };
  return job::answer_parent(server, answering);
}

}  // namespace planish::studio
