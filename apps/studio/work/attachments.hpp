#pragma once

#include <planish/base/result.hpp>
#include <planish/job/maker.hpp>

#include <filesystem>
#include <string>

namespace planish::studio {

/// Whether a file may have this name: 1 to 240 bytes of UTF-8, no slash, no control character, no
/// leading dot.
bool is_plain_name(const std::string& name);

/// Checks the names of files that a spec refers to. Errors: `invalid_input` for a name that is not
/// plain (`where` is `name` and JSON pointer).
Result<void> check_names(const job::Maker& maker, const std::string& spec, const std::string& name);

/// The same, before any of them is opened. Also `cannot_read` for a file that is not among the
/// attachments.
Result<void> check_attachments(const job::Maker& maker, const std::string& spec,
                               const std::string& name, const std::filesystem::path& attachments);

}  // namespace planish::studio
