#pragma once

#include <planish/base/result.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planish {

/// A code of this name and status that outlives every error: for errors that arrive as text from
/// another process. Names are kept for good, once each.
ErrorCode received_code(std::string_view name, ExitStatus status);

/// An error as texts, for another process of this machine.
std::vector<std::string> packed(const Error& error);

/// The error again, nothing of it lost; nothing where the texts are not those of an error.
std::optional<Error> unpacked(std::span<const std::string> texts);

}  // namespace planish
