#pragma once

#include "report_json.hpp"

#include <planish/base/angle.hpp>
#include <planish/job/report.hpp>

#include <string>

namespace planish::job {

using schema::text_of;

/// A report as text for a terminal, after `title` and a colon; `tables` follow the table of bends.
std::string text_of(const Report& report, const std::string& title, const std::string& tables,
                    BendList bends = BendList::shown);

/// The sentence of an error with its options as on a command line: "--write-anyway".
std::string said_on_command_line(const Error& error);

/// The input's file name, or "standard input".
std::string input_name(const Report& report);

/// "90.0°", "12.25°".
std::string angle_text(Angle angle);

}  // namespace planish::job
