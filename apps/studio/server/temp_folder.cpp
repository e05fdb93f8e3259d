#include "temp_folder.hpp"

#include <planish/io/flat_writers.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>

namespace planish::studio {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPrefix = "planish-studio-";
// Held by the process that owns the folder; the system releases it when that process ends, in any
// way.
constexpr auto kLock = "lock";
constexpr mode_t kOwner = 0600;

/// −1 if there is none, or it is another user's.
int own_lock(const fs::path& folder) {
  const int lock = open((folder / kLock).c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC);
  struct stat found {};
  if (lock < 0 || (fstat(lock, &found) == 0 && found.st_uid == geteuid())) return lock;
  close(lock);
  return -1;
}

void remove_if_abandoned(const fs::path& folder) {
  const int lock = own_lock(folder);
  if (lock < 0) return;
  std::error_code ignored;
  if (flock(lock, LOCK_EX | LOCK_NB) == 0) fs::remove_all(folder, ignored);
  close(lock);
}

void remove_abandoned(const fs::path& place) {
  std::error_code error;
  for (fs::directory_iterator at(place, error), end; at != end; at.increment(error)) {
    std::error_code ignored;
    if (at->path().filename().string().starts_with(kPrefix) &&
        at->symlink_status(ignored).type() == fs::file_type::directory)
      remove_if_abandoned(at->path());
  }
}

}  // namespace

Result<TempFolder> TempFolder::make() {
  std::error_code ignored;
  const auto temp = fs::temp_directory_path(ignored);
  const fs::path place = temp.empty() ? fs::path("/tmp") : temp;
  remove_abandoned(place);
  for (;;) {
    std::string name = place / (std::string(kPrefix) + "XXXXXX");
    if (!mkdtemp(name.data())) return cannot_write(name, std::strerror(errno));
    const int lock = open((fs::path(name) / kLock).c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC,
                          kOwner);
    flock(lock, LOCK_EX);
    // Another studio starting at this moment may have taken the lock first and removed the folder.
    if (lock < 0 || fs::exists(fs::path(name) / kLock, ignored)) return TempFolder(name, lock);
    close(lock);
  }
}

TempFolder::~TempFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
  if (lock_ >= 0) close(lock_);
}

}  // namespace planish::studio
