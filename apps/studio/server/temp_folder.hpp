#pragma once

#include <planish/base/result.hpp>

#include <filesystem>

namespace planish::studio {

/// A new folder that nobody else may look into, removed with all it holds at the end.
class TempFolder {
 public:
  /// Error: `cannot_write` with the reason of the system.
  static Result<TempFolder> make();
  TempFolder(TempFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  TempFolder& operator=(TempFolder&&) = delete;
  ~TempFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit TempFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

}  // namespace planish::studio
