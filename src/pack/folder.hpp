#pragma once

#include <planish/base/result.hpp>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace planish::pack {

/// The folder of a pack while its files are written. Which files are a pack's is kept beside them,
/// so that the next pack there can remove those that it does not write itself: a DXF of an earlier
/// quantity must not go to the shop.
class Folder {
 public:
  explicit Folder(std::filesystem::path out) : out_(std::move(out)) {}

  /// Writes a file, whole or not at all. Its name is on record before, so that the next pack
  /// removes it even if this one is cut off. Error: `cannot_write`.
  Result<void> add(const std::string& name, const std::string& bytes);
  /// Removes what an earlier pack wrote and this one did not. Error: `cannot_write`.
  Result<void> finish();

  const std::filesystem::path& path() const { return out_; }
  /// Written, below the folder.
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  Result<void> begin();
  std::filesystem::path record_file() const;

  std::filesystem::path out_;
  std::vector<std::filesystem::path> files_;
  std::set<std::string> known_;  ///< names on record, of this pack and earlier ones
  std::ofstream record_;
};

}  // namespace planish::pack
