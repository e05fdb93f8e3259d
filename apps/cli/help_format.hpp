#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace planish::cli {

/// Help of 80 columns: options on the left, their descriptions wrapped on the right.
std::shared_ptr<CLI::FormatterBase> help_format();

/// What stands for an option's value, "SECONDS", without what CLI11 adds to say how it is checked:
/// "SECONDS:FLOAT in [0 - 1]". Empty where the option takes none.
std::string plain_type(const CLI::Option& option);

}  // namespace planish::cli
