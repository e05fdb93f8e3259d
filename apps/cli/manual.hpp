#pragma once

#include "command_table.hpp"

#include <string>
#include <string_view>

namespace planish::cli {

/// The manual page of a command of the table, or of the program for its first entry, in the
/// language of man(7). `date` is "2026-11-23", `version` that of the program.
std::string manual_page(const std::vector<TableCommand>& table, const TableCommand& command,
                        std::string_view date, std::string_view version);

/// What its file is called, without the section: "planish-unfold".
std::string page_name(const std::vector<TableCommand>& table, const TableCommand& command);

}  // namespace planish::cli
