#pragma once

#include "command_table.hpp"

#include <string>

namespace planish::cli {

/// Scripts by which a shell completes command lines of the program: commands, options, words that
/// options take, names of files that fit.
std::string bash_completion(const std::vector<TableCommand>& table);
std::string zsh_completion(const std::vector<TableCommand>& table);
std::string fish_completion(const std::vector<TableCommand>& table);

}  // namespace planish::cli
