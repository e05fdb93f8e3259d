#include "temp_folder.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

namespace planish::studio {

Result<TempFolder> TempFolder::make() {
  std::error_code ignored;
  auto place = std::filesystem::temp_directory_path(ignored);
  std::string name =
      (place.empty() ? std::filesystem::path("/tmp") : place) / "planish-studio-XXXXXX";
  if (mkdtemp(name.data())) return TempFolder(name);
  return fail(ErrorCode::cannot_write,
              fmt::format("cannot make the folder {}: {}", name, std::strerror(errno)), name);
}

TempFolder::~TempFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace planish::studio
