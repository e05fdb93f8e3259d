#include "folder.hpp"

#include <planish/io/flat_writers.hpp>
#include <planish/schema/text_file.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>
#include <sstream>

// The files of a pack, and those of an earlier one. A name is recorded before its file is written,
// so even after a crash the next pack knows all it may remove: recorded files that it did not write
// again. Names that lead out of the folder are never removed, whatever the record says.

namespace planish::pack {
namespace {

namespace fs = std::filesystem;

std::string lines_of(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += name + '\n';
  return text;
}

}  // namespace

fs::path Folder::record_file() const { return out_ / ".planish-pack" / "files"; }

Result<void> Folder::begin() {
  if (auto made = make_folder(record_file().parent_path()); !made) return made;
  if (const auto text = schema::read_text(record_file(), "record of a pack")) {
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);)
      known_.insert(line);
  }
  record_.open(record_file(), std::ios::app | std::ios::binary);
  return {};
}

Result<void> Folder::add(const std::string& name, const std::string& bytes) {
  if (!record_.is_open())
    if (auto begun = begin(); !begun) return begun;
  const fs::path target = out_ / name;
  if (auto made = make_folder(target.parent_path()); !made) return made;
  if (known_.insert(name).second) record_ << name << '\n' << std::flush;
  if (!record_) return cannot_write(record_file(), std::strerror(errno));
  if (auto written = write_file(target, bytes); !written) return written;
  files_.emplace_back(name);
  return {};
}

Result<void> Folder::finish() {
  std::set<std::string> now;
  for (const fs::path& file : files_)
    now.insert(file.string());
  std::error_code none;
  for (const std::string& name : known_) {
    const fs::path relative(name);
    const bool outside = relative.is_absolute() || std::ranges::count(relative, "..") > 0;
    if (!outside && !now.contains(name)) fs::remove(out_ / relative, none);
  }
  record_.close();
  return write_file(record_file(), lines_of(now));
}

}  // namespace planish::pack
