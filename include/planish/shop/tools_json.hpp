#pragma once

#include <planish/base/result.hpp>
#include <planish/brake/tools.hpp>

#include <string>
#include <string_view>

namespace planish::shop {

/// Reads a tools file (formats.md#tools). Profiles may run either way; those returned run
/// counter-clockwise. Errors: `invalid_input` for anything that is not JSON (`where` is
/// name:line:column), unknown, repeated and missing keys, values of the wrong type or out of range;
/// `bad_tools` for what `check` finds. `where` is name and JSON pointer.
Result<BrakeTools> parse_tools(const std::string& json, const std::string& name);

/// The catalogue that is used if none is given, as the text of a tools file: a press brake of 100 t
/// and 3 m with common European tools.
std::string_view default_tools_json();
const BrakeTools& default_tools();

}  // namespace planish::shop
