#pragma once

#include <cstdlib>
#include <filesystem>

namespace planish::test {

/// The folder of the real parts that `tests/corpus/parts.jsonl` lists: PLANISH_PARTS, or
/// `../shared/parts` beside the repository. Tests skip where it is absent; `kNoRealParts` says how
/// to bring it.
inline std::filesystem::path real_parts_folder() {
  if (const char* folder = std::getenv("PLANISH_PARTS")) return folder;
  return std::filesystem::path(PLANISH_SOURCE_DIR) / "../shared/parts";
}

inline constexpr const char*
    kNoRealParts = "the real parts are absent: tools/fetch_parts.py brings them (docs/checking.md)";

}  // namespace planish::test
