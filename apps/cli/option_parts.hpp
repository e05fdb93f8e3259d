#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace planish::cli {

/// How an option of a request is spelled on the command line: "--k-table" for "k_table".
std::string flag_of(std::string_view option);

/// A message of the library with its option names, which are in backquotes, spelled as on the
/// command line.
std::string spelled(const std::string& message);

/// An option whose value may be any text that is not empty; `type` stands for it in the help.
CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& target,
                      const std::string& type, const std::string& description);

/// An option that may be given several times, each time with one value, so that an input may
/// follow it.
CLI::Option* add_repeatable(CLI::App& app, const std::string& name,
                            std::vector<std::string>& target, const std::string& description);

/// A check for options: an error message for an empty value, "" for any other.
std::string not_empty(const std::string& text);

}  // namespace planish::cli
