#include <planish/io/flat_writers.hpp>

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <system_error>

namespace planish {
namespace {

namespace fs = std::filesystem;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File opened(const fs::path& path, const char* mode) {
  return {std::fopen(path.c_str(), mode), &std::fclose};
}

std::error_code last_error() { return {errno, std::generic_category()}; }

tl::unexpected<Error> cannot_write(const fs::path& target, const std::error_code& reason) {
  return fail(ErrorCode::cannot_write,
              fmt::format("cannot write {}: {}", target.string(), reason.message()),
              target.string());
}

/// Succeeds only if every byte was written, including on closing, where a full disk may show.
std::error_code put(File file, const std::string& content) {
  if (std::fwrite(content.data(), 1, content.size(), file.get()) != content.size()) {
    return last_error();
  }
  return std::fclose(file.release()) == 0 ? std::error_code() : last_error();
}

/// A name in the same directory, since renaming is atomic only within one file system.
fs::path name_beside(const fs::path& target) {
  static std::atomic<unsigned> count{0};
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  fs::path name = target;
  name.replace_filename(fmt::format(".planish-{:x}-{}.part", now, ++count));
  return name;
}

Result<void> write_directly(const fs::path& target, const std::string& content) {
  File file = opened(target, "wb");
  if (!file) return cannot_write(target, last_error());
  if (const auto reason = put(std::move(file), content)) return cannot_write(target, reason);
  return {};
}

Result<void> write_beside(const fs::path& target, const fs::path& real, const std::string& content,
                          std::optional<fs::perms> permissions) {
  const fs::path part = name_beside(real);
  File file = opened(part, "wbx");
  if (!file) return cannot_write(target, last_error());
  std::error_code reason = put(std::move(file), content);
  if (!reason && permissions) fs::permissions(part, *permissions, reason);
  if (!reason) fs::rename(part, real, reason);
  if (!reason) return {};
  std::error_code ignored;
  fs::remove(part, ignored);
  return cannot_write(target, reason);
}

}  // namespace

Result<void> write_file(const fs::path& target, const std::string& content) {
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (!fs::exists(status)) return write_beside(target, target, content, std::nullopt);
  if (!fs::is_regular_file(status) && !fs::is_directory(status)) {
    return write_directly(target, content);
  }
  // Renaming would also replace a write-protected file; opening it shows that.
  if (!opened(target, "r+b")) return cannot_write(target, last_error());
  const fs::path real = fs::canonical(target, error);
  if (error) return cannot_write(target, error);
  return write_beside(target, real, content, status.permissions());
}

}  // namespace planish
