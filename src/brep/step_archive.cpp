#include "packed_file.hpp"
#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/brep/step_archive.hpp>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>

// Archives as folders of STEP files. A path goes on behind the archive with the name in it, so that
// whoever takes a path takes a file in an archive too.

namespace planish {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& file, std::size_t most = std::numeric_limits<int>::max()) {
  std::error_code none;
  std::string bytes(std::min<std::uintmax_t>(fs::file_size(file, none), most), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), std::ssize(bytes));
  bytes.erase(bytes.begin() + stream.gcount(), bytes.end());
  return bytes;
}

/// The beginning of a file that is packed, or nothing.
std::string packed_beginning(const fs::path& file) {
  constexpr std::size_t kMark = 4;
  std::string bytes = bytes_of(file, kMark);
  return brep::is_packed(bytes) ? bytes : "";
}

/// The archive that a path leads through.
std::optional<fs::path> archive_of(const fs::path& path) {
  std::error_code none;
  for (fs::path above = path.parent_path(); above.has_relative_path(); above = above.parent_path())
    if (fs::exists(above, none)) {
      if (!fs::is_regular_file(above, none) || !brep::is_archive(packed_beginning(above)))
        return std::nullopt;
      return above;
    }
  return std::nullopt;
}

}  // namespace

bool has_step_name(const fs::path& name) {
  const std::string lower = lower_case(name.extension().string());
  return lower == ".step" || lower == ".stp" || lower == ".p21";
}

std::optional<std::vector<fs::path>> step_files_in(const fs::path& file) {
  const std::string first = packed_beginning(file);
  if (first.empty()) return std::nullopt;
  std::vector<fs::path> found;
  if (!brep::is_archive(first)) {
    constexpr std::size_t kFirst = std::size_t{1} << 16;
    const std::string text = brep::unpacked_beginning(bytes_of(file, kFirst));
    if (text.empty() || brep::begins_as_shape(text)) found.push_back(file);
    return found;
  }
  const auto names = brep::step_names_in(bytes_of(file), file.filename().string());
  if (!names && names.error().code == code::not_step) return found;
  if (!names || names->size() == 1) return std::vector{file};
  for (const std::string& one : *names)
    found.push_back(file / one);
  return found;
}

bool is_in_archive(const fs::path& path) { return archive_of(path).has_value(); }

Result<std::string> read_in_archive(const fs::path& path) {
  const auto archive = archive_of(path);
  if (!archive)
    return fail(refuse::cannot_open, {{"file", path.string()}, {"why", "there is no such file"}},
                path.string());
  return brep::unpacked_entry(bytes_of(*archive),
                              path.lexically_relative(*archive).generic_string(),
                              archive->filename().string());
}

}  // namespace planish
