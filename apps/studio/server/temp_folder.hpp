#pragma once

#include <planish/base/result.hpp>

#include <filesystem>
#include <utility>

namespace planish::studio {

/// A new private folder, removed with its content at the end.
class TempFolder {
 public:
  /// Also removes such folders left by killed processes of this user. Error: `cannot_write` with
  /// the system's reason.
  static Result<TempFolder> make();
  TempFolder(TempFolder&& other) noexcept
      : path_(std::exchange(other.path_, {})), lock_(std::exchange(other.lock_, -1)) {}
  TempFolder& operator=(TempFolder&&) = delete;
  ~TempFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  TempFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}
  std::filesystem::path path_;
  int lock_;  ///< descriptor of a file in it that shows others that it is in use
};

}  // namespace planish::studio
