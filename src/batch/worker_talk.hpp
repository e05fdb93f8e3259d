#pragma once

#include "part_work.hpp"

namespace planish::batch {

// What a batch and its workers tell each other, as texts; reading gives nothing for other texts.

process::Texts texts_of(const FileTask& task);
std::optional<FileTask> task_in(const process::Texts& texts);

process::Texts texts_of(const PartDone& part);
std::optional<PartDone> part_in(const process::Texts& texts);

/// All bodies of a file are done; what came of them was told before.
struct FileDone {};
process::Texts texts_of(const FileDone& done);
std::optional<FileDone> file_done_in(const process::Texts& texts);

/// A body is begun.
process::Texts beginning(int body);
std::optional<int> body_in(const process::Texts& texts);

}  // namespace planish::batch
