#pragma once

#include "../work/answer.hpp"

#include <filesystem>
#include <mutex>
#include <string>

namespace planish::studio {

constexpr std::size_t kLargestKept = std::size_t{24} << 20;  ///< bytes of a file
constexpr std::size_t kMostKept = 64;                        ///< files

/// What the page keeps on this machine from one start to the next: files of plain names in one
/// folder, which is made with the first. The page's address changes with every start, and with it
/// what browsers keep. Thread-safe.
class KeptFiles {
 public:
  explicit KeptFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// `[{"name", "size"}]`, by name.
  Answer list() const;
  Answer read(const std::string& name) const;
  /// Replaces the file of that name, wholly or not at all.
  Answer write(const std::string& name, const std::string& bytes);
  Answer remove(const std::string& name);

 private:
  std::filesystem::path folder_;
  mutable std::mutex mutex_;
};

/// `$XDG_STATE_HOME/planish/studio`, or `~/.local/state/planish/studio`; empty where there is no
/// home.
std::filesystem::path kept_folder();

}  // namespace planish::studio
