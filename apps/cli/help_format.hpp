#pragma once

#include <CLI/CLI.hpp>

#include <memory>

namespace planish::cli {

/// Help of 80 columns: options on the left, their descriptions wrapped on the right.
std::shared_ptr<CLI::FormatterBase> help_format();

}  // namespace planish::cli
