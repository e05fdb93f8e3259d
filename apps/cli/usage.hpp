#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace planish::cli {

/// What is wrong with a command line that was not taken, in one sentence, and where to read on.
std::string usage_sentence(const CLI::ParseError& error, const CLI::App& app);

}  // namespace planish::cli
