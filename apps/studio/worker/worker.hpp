#pragma once

#include "../work/answer.hpp"

#include <planish/process/worker.hpp>

#include <filesystem>
#include <optional>

namespace planish::studio {

/// A process that works for one document in `folder`: this program again, as
/// `planish studio-worker`.
using DocumentWorker = process::Worker<Task, Answer>;
process::Starting studio_worker(const std::filesystem::path& folder);

/// Tasks and answers as they are sent. Empty for texts that are none.
process::Texts texts_of(const Task& task);
process::Texts texts_of(const Answer& answer);
std::optional<Task> task_of(const process::Texts& texts);
std::optional<Answer> answer_of(const process::Texts& texts);

}  // namespace planish::studio
