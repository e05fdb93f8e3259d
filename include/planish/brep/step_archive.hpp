#pragma once

#include <planish/base/result.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planish {

/// Whether a name ends as that of a STEP file: .step, .stp or .p21, in any case.
bool has_step_name(const std::filesystem::path& name);

/// The STEP files in a packed file, each as the path that `read_step` takes: those of a ZIP archive
/// in its order, "parts.zip/left.step", of those of one name the first; the packed file itself if
/// it is one by gzip, or damaged, so that reading it says why. Empty: it holds none. Nothing: it is
/// not packed.
std::optional<std::vector<std::filesystem::path>> step_files_in(const std::filesystem::path& file);

/// Whether a path leads into an archive: "parts.zip/left.step", where parts.zip is one.
bool is_in_archive(const std::filesystem::path& path);

/// The bytes of such a file. Errors: `cannot_read` (the archive has no such file),
/// `truncated_file`, `invalid_input` (encrypted, or packed by a method that is not read).
Result<std::string> read_in_archive(const std::filesystem::path& path);

}  // namespace planish
