#include "refusals.hpp"

#include <planish/io/flat_writers.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

// Files whole or not at all. Bytes go to a file beside the target, in the same folder, since
// renaming is atomic only within one file system; it takes the target's place once every byte is
// written and the file closed, where a full disk may first show. Of several files none takes its
// place before all are written. A write-protected target is found by opening it, as renaming would
// replace it.

namespace planish {
namespace {

namespace fs = std::filesystem;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File opened(const fs::path& path, const char* mode) {
  return {std::fopen(path.c_str(), mode), &std::fclose};
}

std::error_code last_error() { return {errno, std::generic_category()}; }

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
  if (!file) return cannot_write(target, last_error().message());
  if (const auto reason = put(std::move(file), content))
    return cannot_write(target, reason.message());
  return {};
}

/// Where a target's bytes go.
struct Target {
  fs::path real;                         ///< behind symbolic links
  std::optional<fs::perms> permissions;  ///< of the file that is there
  bool direct = false;                   ///< a device or pipe
};

Result<Target> place_of(const fs::path& target) {
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (!fs::exists(status)) return Target{target, {}};
  if (!fs::is_regular_file(status) && !fs::is_directory(status)) return Target{target, {}, true};
  // Renaming would also replace a write-protected file; opening it shows that.
  if (!opened(target, "r+b")) return cannot_write(target, last_error().message());
  const fs::path real = fs::canonical(target, error);
  if (error) return cannot_write(target, error.message());
  return Target{real, status.permissions()};
}

/// A file that stands beside its target until it takes its place, and goes with this if it never
/// does.
class Part {
 public:
  Part(fs::path target, Target place)
      : target_(std::move(target)), place_(std::move(place)), part_(name_beside(place_.real)) {}
  Part(Part&& other) noexcept
      : target_(std::move(other.target_)),
        place_(std::move(other.place_)),
        part_(std::exchange(other.part_, {})) {}
  Part& operator=(Part&&) = delete;
  ~Part() {
    std::error_code ignored;
    if (!part_.empty()) fs::remove(part_, ignored);
  }

  Result<void> write(const std::string& content) {
    File file = opened(part_, "wbx");
    if (!file) {
      part_.clear();
      return cannot_write(target_, last_error().message());
    }
    std::error_code reason = put(std::move(file), content);
    if (!reason && place_.permissions) fs::permissions(part_, *place_.permissions, reason);
    if (reason) return cannot_write(target_, reason.message());
    return {};
  }

  Result<void> take_place() {
    std::error_code reason;
    fs::rename(part_, place_.real, reason);
    if (reason) return cannot_write(target_, reason.message());
    part_.clear();
    return {};
  }

 private:
  fs::path target_;
  Target place_;
  fs::path part_;
};

}  // namespace

tl::unexpected<Error> cannot_write(const fs::path& file, const std::string& reason) {
  return fail(refuse::cannot_write, {{"file", file.string()}, {"reason", reason}}, file.string());
}

Result<void> write_file(const fs::path& target, const std::string& content) {
  auto place = place_of(target);
  if (!place) return pass_on(place);
  if (place->direct) return write_directly(target, content);
  Part part(target, std::move(*place));
  if (auto written = part.write(content); !written) return written;
  return part.take_place();
}

Result<void> write_files(const std::vector<OutputFile>& files,
                         const std::function<Result<void>()>& before_they_appear) {
  std::vector<Part> parts;
  std::vector<const OutputFile*> direct;
  for (const OutputFile& file : files) {
    auto place = place_of(file.path);
    if (!place) return pass_on(place);
    if (place->direct) {
      direct.push_back(&file);
      continue;
    }
    parts.emplace_back(file.path, std::move(*place));
    if (auto written = parts.back().write(file.content); !written) return written;
  }
  for (const OutputFile* file : direct)
    if (auto written = write_directly(file->path, file->content); !written) return written;
  if (before_they_appear)
    if (auto done = before_they_appear(); !done) return done;
  for (Part& part : parts)
    if (auto taken = part.take_place(); !taken) return taken;
  return {};
}

Result<void> make_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (!failed) return {};
  return fail(refuse::cannot_make_folder, {{"file", folder.string()}, {"reason", failed.message()}},
              folder.string());
}

Result<void> check_writable(const fs::path& target) {
  const auto place = place_of(target);
  if (!place) return pass_on(place);
  const fs::path folder = place->real.has_parent_path() ? place->real.parent_path() : ".";
  const char* needed = place->direct ? target.c_str() : folder.c_str();
  if (access(needed, W_OK) != 0) return cannot_write(target, last_error().message());
  return {};
}

}  // namespace planish
