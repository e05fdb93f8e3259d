#pragma once

#include <planish/base/result.hpp>
#include <planish/job/artifact.hpp>
#include <planish/job/child_process.hpp>

#include <map>
#include <string>
#include <vector>

namespace planish::batch {

/// What is asked of a worker: everything about one input file.
struct FileTask {
  std::string file, name;            ///< where it lies, and what it is called
  std::string options;               ///< a JSON object; each maker takes those of them that it has
  std::vector<std::string> formats;  ///< artifacts, where the maker writes them
  std::map<int, Error> given_up = {};  ///< bodies that ended a worker before, from 0
};

struct PartFile {
  std::string name, bytes;
};

/// One part that was made or refused.
struct PartDone {
  std::string folder;  ///< below that of all parts; equal for the same input always
  std::string report;  ///< JSON on one line, without a line end
  std::vector<PartFile> files;
};

/// Does the task; `parent` hears the number of each body before it is worked on.
std::vector<PartDone> work_on(const FileTask& task, const job::Catalogue& catalogue,
                              const job::Parent& parent);

/// The one part of a file that gave nothing else.
PartDone failed_part(const FileTask& task, const job::Catalogue& catalogue, const Error& error);

// As they are sent between processes; empty for texts that are none.
job::Texts texts_of(const FileTask& task);
std::optional<FileTask> task_in(const job::Texts& texts);
job::Texts texts_of(const std::vector<PartDone>& parts);
std::optional<std::vector<PartDone>> parts_in(const job::Texts& texts);

}  // namespace planish::batch
