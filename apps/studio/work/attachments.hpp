#pragma once

#include <planish/base/result.hpp>

#include <filesystem>
#include <string>

namespace planish::studio {

/// Whether a file may have this name: 1 to 128 bytes of UTF-8, no slash, no control character, no
/// leading dot.
bool is_plain_name(const std::string& name);

/// Looks at the files that a slit spec names before anything opens one. Errors: `invalid_input` for
/// a name that is not plain, `cannot_read` for one that is not among the attachments (`where` is
/// `name` and JSON pointer).
Result<void> check_attachments(const std::string& spec, const std::string& name,
                               const std::filesystem::path& attachments);

/// The spec with no points in the place of files that it names. Errors: `invalid_input` for names
/// that are not plain, and for what is not JSON.
Result<std::string> without_attachments(const std::string& spec, const std::string& name);

}  // namespace planish::studio
