#pragma once

#include <planish/base/result.hpp>
#include <planish/batch/part_record.hpp>
#include <planish/job/artifact.hpp>
#include <planish/process/child_process.hpp>

#include <map>
#include <string>
#include <vector>

namespace planish::batch {

/// One of `of` shares of the bodies of a file, counted from 1; other inputs are one body.
struct BodyShare {
  int number = 1, of = 1;
  bool holds(int body) const { return body % of + 1 == number; }
};

/// What is asked of a worker: everything about one input file.
struct FileTask {
  std::string file, name;            ///< where it lies, and what it is called
  std::string options;               ///< a JSON object; each maker takes those of them that it has
  std::vector<std::string> formats;  ///< artifacts, where the maker writes them
  std::map<int, Error> given_up = {};  ///< bodies that ended a worker before, from 0
  BodyShare share = {};
};

struct PartFile {
  std::string name, bytes;
};

/// One part that was made or refused.
struct PartDone {
  PartRecord record;
  std::vector<PartFile> files = {};  ///< those that the record names
  int body = 0;                      ///< of its file, from 0
};
PartDone part_done(std::string folder, std::string report, std::vector<std::string> shapes,
                   std::vector<PartFile> files, int body = 0);

/// Hears of each body, from 0, before it is worked on, and of each part that is done.
struct Listener {
  std::function<void(int body)> begins;
  std::function<void(PartDone part)> done;
  Progress progress;
};

/// Does the task.
void work_on(const FileTask& task, const job::Catalogue& catalogue, const Listener& listener);

/// The one part of a file that gave nothing else.
PartDone failed_part(const FileTask& task, const job::Catalogue& catalogue, const Error& error);

}  // namespace planish::batch
