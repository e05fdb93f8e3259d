#pragma once

#include "part_work.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace planish::batch {

/// What a batch has done, in a file that only grows: a line for each input, with its key and the
/// reports of its parts. A run that is cut off leaves at most the last line unfinished, which is
/// then not counted. Reports stay in the file; only where they are is kept in memory.
class Journal {
 public:
  /// Opens or begins it. Errors: `cannot_read`, `cannot_write`.
  static Result<Journal> open(const std::filesystem::path& file);

  /// Whether an input was done with this key: content, options and version.
  bool has(const std::string& name, const std::string& key) const;
  /// Adds what was made of an input. Error: `cannot_write`.
  Result<void> add(const std::string& name, const std::string& key,
                   const std::vector<PartDone>& parts);

  struct Part {
    std::string folder, report;  ///< JSON on one line
  };
  /// The parts of an input that it has. Error: `cannot_read`.
  Result<std::vector<Part>> parts_of(const std::string& name);

 private:
  struct Place {
    std::string key;
    std::streamoff at = 0;
    std::size_t length = 0;
  };

  std::filesystem::path file_;
  std::fstream stream_;
  std::streamoff end_ = 0;
  std::map<std::string, Place> places_;  ///< by name
};

}  // namespace planish::batch
