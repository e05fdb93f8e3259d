#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>

#include <optional>
#include <string>

namespace planish::fuzz {

// What is done with a damaged text. Each returns the error, or none.

/// Reads it as STEP, unfolds its first body, and writes report, DXF and SVG.
std::optional<Error> read_step_and_unfold(const std::string& text, const Progress& progress);

/// Reads it as a rules file, and as whichever other JSON file it is.
std::optional<Error> read_json(const std::string& text, const Progress& progress);

/// Reads it as the JSON file that it is, and makes a draft of it.
std::optional<Error> make_json(const std::string& text, const Progress& progress);

/// Reads it as a file of points, and as a bend table.
std::optional<Error> read_table(const std::string& text);

}  // namespace planish::fuzz
