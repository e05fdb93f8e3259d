#pragma once

#include <span>
#include <string_view>

namespace planish::studio {

/// A file that the program carries in itself.
struct EmbeddedFile {
  std::string_view name;  ///< "page/index.html", "examples/connect/a_folded.json"
  std::string_view bytes;
};

/// All of them, by name in ascending order. The build writes this function
/// (cmake/PlanishEmbed.cmake).
std::span<const EmbeddedFile> embedded_files();

/// Null where there is none of this name.
const EmbeddedFile* embedded_file(std::string_view name);

}  // namespace planish::studio
