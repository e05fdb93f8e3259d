#pragma once

#include "part_work.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace planish::batch {

/// What a batch has done, in a file that only grows: a line for each input, with its key and what
/// its parts are. The last line of a name counts. A run that is cut off leaves at most the last
/// line unfinished, which is then dropped. Only where each line is stays in memory.
class Journal {
 public:
  /// Opens it to read it alone. Error: `cannot_read`.
  static Result<Journal> read(const std::filesystem::path& file);
  /// Opens or begins it. Error: `cannot_write`.
  static Result<Journal> open(const std::filesystem::path& file);

  /// The key of an input: what it was made from and with; empty if it has none.
  std::string key_of(const std::string& name) const;
  /// All names, in byte order.
  std::vector<std::string> names() const;

  /// The parts of an input that it has, in the order of the file. Error: `cannot_read`.
  Result<std::vector<PartRecord>> parts_of(const std::string& name);

  /// Adds what was made of an input. Error: `cannot_write`.
  Result<void> add(const std::string& name, const std::string& key,
                   const std::vector<PartDone>& parts);
  /// Adds what another one holds of a name; on the disk once it is flushed. Errors: `cannot_read`,
  /// `cannot_write`.
  Result<void> add_from(Journal& other, const std::string& name);
  /// Error: `cannot_write`.
  Result<void> flush();

 private:
  struct Place {
    std::string key;
    std::streamoff at = 0;
    std::size_t length = 0;
  };

  /// Finds the places in the stream.
  void look_through();
  Result<std::string> line_at(const Place& place);
  tl::unexpected<Error> unwritten();
  Result<void> append(const std::string& name, const std::string& key, std::string_view line);

  std::filesystem::path file_;
  std::fstream stream_;
  std::streamoff end_ = 0;
  std::map<std::string, Place> places_;  ///< by name
};

}  // namespace planish::batch
