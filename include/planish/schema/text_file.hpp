#pragma once

#include <planish/base/result.hpp>

#include <filesystem>
#include <string>

namespace planish::schema {

/// A file's bytes, or those of standard input for "-"; `what` names the kind of file in messages
/// ("plates file"). Errors: `cannot_read` with the system's reason.
Result<std::string> read_text(const std::filesystem::path& file, const std::string& what);

/// `cannot_read` of such a file, or of a folder, for a reason.
Error cannot_read(const std::string& what, const std::filesystem::path& file,
                  const std::string& reason);

}  // namespace planish::schema
