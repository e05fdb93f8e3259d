#pragma once

#include "../work/answer.hpp"

#include <planish/process/child_process.hpp>

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
Result<std::unique_ptr<process::ChildProcess>> start_worker(const std::filesystem::path& folder);

/// Has a worker do a task, for `limit` at the most. After an end there is no worker any more.
tl::expected<Answer, process::ChildEnd> ask(process::ChildProcess& worker, const Task& task,
                                            std::chrono::seconds limit,
                                            const std::function<void(Stage)>& report);

/// Tasks and answers as they are sent. Empty for texts that are none.
process::Texts texts_of(const Task& task);
process::Texts texts_of(const Answer& answer);
std::optional<Task> task_of(const process::Texts& texts);
std::optional<Answer> answer_of(const process::Texts& texts);

}  // namespace planish::studio
