#pragma once

#include "part_work.hpp"

namespace planish::batch {

// What a batch and its workers tell each other, as texts; reading gives nothing for other texts.

job::Texts texts_of(const FileTask& task);
std::optional<FileTask> task_in(const job::Texts& texts);

job::Texts texts_of(const PartDone& part);
std::optional<PartDone> part_in(const job::Texts& texts);

/// A body is begun.
job::Texts beginning(int body);
std::optional<int> body_in(const job::Texts& texts);

}  // namespace planish::batch
