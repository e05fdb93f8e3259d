#pragma once

#include "../work/answer.hpp"

#include <planish/job/child_process.hpp>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace planish::studio {

/// Progress of a task: a stage's name and the share done, 0 to 1.
struct Stage {
  std::string name;
  double share = 0.0;
};

/// A process that works for one document in `folder`: this program again, as
/// `planish studio-worker`. Error: `internal` with the reason of the system.
Result<std::unique_ptr<job::ChildProcess>> start_worker(const std::filesystem::path& folder);

/// Has a worker do a task, for `limit` at the most. After an end there is no worker any more.
tl::expected<Answer, job::ChildEnd> ask(job::ChildProcess& worker, const Task& task,
                                        std::chrono::seconds limit,
                                        const std::function<void(Stage)>& report);

/// Tasks and answers as they are sent. Empty for texts that are none.
job::Texts texts_of(const Task& task);
job::Texts texts_of(const Answer& answer);
std::optional<Task> task_of(const job::Texts& texts);
std::optional<Answer> answer_of(const job::Texts& texts);

}  // namespace planish::studio
