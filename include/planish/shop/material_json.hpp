#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/material.hpp>

#include <string>

namespace planish::shop {

/// Reads a material file (formats.md#material). `name` is the file's; it names the material too
/// where the file does not. Errors: `invalid_input` for anything that is not JSON (`where` is
/// name:line:column) and for what breaks the schema or a rule of `MaterialCurves` (`where` is name
/// and JSON pointer).
Result<MaterialCurves> parse_material(const std::string& json, const std::string& name);

}  // namespace planish::shop
