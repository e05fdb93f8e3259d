#pragma once

#include "json_parts.hpp"

#include <planish/base/angle.hpp>
#include <planish/job/report.hpp>

#include <string>

namespace planish::job {

/// A report as a person reads it, behind `title` and a colon; `tables` follow that of the bends.
std::string text_of(const Report& report, const std::string& title, const std::string& tables,
                    BendList bends = BendList::shown);

/// The input's file name; "standard input".
std::string input_name(const Report& report);

/// "90.0°", "12.25°".
std::string angle_text(Angle angle);

}  // namespace planish::job
