#include "kept_files.hpp"

#include "../work/attachments.hpp"

#include <planish/io/flat_writers.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

namespace planish::studio {
namespace {

namespace fs = std::filesystem;

Answer not_kept(const std::string& name) {
  return failure(404, "not_found", fmt::format("nothing is kept as {}", name), name);
}

Answer cannot_keep(const std::string& name, const std::string& why) {
  return failure(500, "cannot_write", why, name);
}

std::vector<fs::directory_entry> files_in(const fs::path& folder) {
  std::vector<fs::directory_entry> files;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (entry.is_regular_file(failed) && is_plain_name(entry.path().filename().string()))
      files.push_back(entry);
  std::ranges::sort(files);
  return files;
}

}  // namespace

Answer KeptFiles::list() const {
  const std::lock_guard lock(mutex_);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::error_code failed;
  for (const fs::directory_entry& file : files_in(folder_))
    list.push_back({{"name", file.path().filename().string()}, {"size", file.file_size(failed)}});
  return {200, kJsonType, list.dump()};
}

Answer KeptFiles::read(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  if (!is_plain_name(name)) return not_kept(name);
  std::ifstream file(folder_ / name, std::ios::binary);
  if (!file) return not_kept(name);
  return {200, "application/octet-stream", std::string(std::istreambuf_iterator<char>(file), {})};
}

Answer KeptFiles::write(const std::string& name, const std::string& bytes) {
  if (!is_plain_name(name))
    return failure(422, "invalid_input", "what is kept needs a plain name of at most 240 bytes",
                   name);
  if (bytes.size() > kLargestKept)
    return failure(
        413, "too_large",
        fmt::format("{} is too large to be kept; the limit is {} MiB", name, kLargestKept >> 20),
        name);
  const std::lock_guard lock(mutex_);
  if (folder_.empty()) return cannot_keep(name, "there is no home folder to keep anything in");
  const auto present = files_in(folder_);
  const bool known = std::ranges::any_of(
      present, [&](const auto& file) { return file.path().filename() == name; });
  if (!known && present.size() >= kMostKept)
    return failure(429, "too_many_files", fmt::format("{} files are kept; remove one", kMostKept),
                   name);
  std::error_code failed;
  if (fs::create_directories(folder_, failed)) ::chmod(folder_.c_str(), S_IRWXU);
  if (const auto written = write_file(folder_ / name, bytes); !written)
    return cannot_keep(name, written.error().message);
  return {204, "", ""};
}

Answer KeptFiles::remove(const std::string& name) {
  const std::lock_guard lock(mutex_);
  std::error_code failed;
  if (!is_plain_name(name) || !fs::remove(folder_ / name, failed)) return not_kept(name);
  return {204, "", ""};
}

fs::path kept_folder() {
  const auto folder = [](const char* variable) -> fs::path {
    const char* value = std::getenv(variable);
    return value && fs::path(value).is_absolute() ? value : "";
  };
  fs::path state = folder("XDG_STATE_HOME");
  if (const fs::path home = folder("HOME"); state.empty() && !home.empty())
    state = home / ".local" / "state";
  return state.empty() ? state : state / "planish" / "studio";
}

}  // namespace planish::studio
