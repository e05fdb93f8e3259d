#pragma once

#include <span>
#include <string_view>

namespace planish::studio {

/// A file embedded in the program.
struct EmbeddedFile {
  std::string_view name;  ///< "page/index.html", "examples/connect/a_folded.json"
  std::string_view bytes;
};

/// All embedded files, by name in ascending order. The build writes this function
/// (cmake/PlanishEmbed.cmake).
std::span<const EmbeddedFile> embedded_files();

/// Null if there is none of this name.
const EmbeddedFile* embedded_file(std::string_view name);

}  // namespace planish::studio
