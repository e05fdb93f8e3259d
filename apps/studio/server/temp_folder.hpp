#pragma once

#include <planish/base/result.hpp>

#include <filesystem>
#include <utility>

namespace planish::studio {

/// A new folder that nobody else may look into, removed with all it holds at the end.
class TempFolder {
 public:
  /// Removes also what processes of this user that were killed have left of this kind. Error:
  /// `cannot_write` with the reason of the system.
  static Result<TempFolder> make();
  TempFolder(TempFolder&& other) noexcept
      : path_(std::exchange(other.path_, {})), lock_(std::exchange(other.lock_, -1)) {}
  TempFolder& operator=(TempFolder&&) = delete;
  ~TempFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  TempFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}
  std::filesystem::path path_;
  int lock_;  ///< descriptor of a file in it, by which others see that it is in use
};

}  // namespace planish::studio
