#pragma once

#include <planish/base/result.hpp>

#include <string>
#include <string_view>

namespace planish::brep {

/// Whether the bytes are those of a gzip file or of a ZIP archive, by their first ones.
bool is_packed(std::string_view bytes);

/// The file in a gzip file, or the only STEP file in a ZIP archive: by its suffix, else the only
/// file there. At most 2 GiB come out. Errors: `truncated_file` (the bytes end early or are
/// damaged), `not_step` (an archive without a STEP file), `invalid_input` (with several, encrypted
/// or packed by another method than deflate; too large), `out_of_memory`. `name` is for messages.
Result<std::string> unpacked(std::string_view bytes, const std::string& name);

}  // namespace planish::brep
