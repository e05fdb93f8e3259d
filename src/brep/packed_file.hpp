#pragma once

#include <planish/base/result.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace planish::brep {

/// Whether the bytes are those of a gzip file or of a ZIP archive, by their first ones.
bool is_packed(std::string_view bytes);
bool is_archive(std::string_view bytes);

/// Whether a text begins as one that `read_step` reads does.
bool begins_as_shape(std::string_view text);

/// The file in a gzip file, or the only STEP file in a ZIP archive: by its suffix, else the only
/// file there, if it begins as one. At most 2 GiB come out. Errors: `truncated_file` (the bytes end
/// early or are damaged), `not_step` (an archive without a STEP file), `invalid_input` (with
/// several, encrypted or packed by another method than deflate; too large). `name` is for messages.
Result<std::string> unpacked(std::string_view bytes, const std::string& name);

/// What the first bytes of a gzip file say; empty if they are damaged.
std::string unpacked_beginning(std::string_view gzip);

/// The names of the STEP files in an archive, each once, without drive, "." and "..". Errors: those
/// of `unpacked`, but for several.
Result<std::vector<std::string>> step_names_in(std::string_view archive, const std::string& name);

/// The first file of such a name in an archive. Errors: `cannot_read` if there is none, those of
/// `unpacked`.
Result<std::string> unpacked_entry(std::string_view archive, const std::string& entry,
                                   const std::string& name);

}  // namespace planish::brep
