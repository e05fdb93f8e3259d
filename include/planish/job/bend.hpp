#pragma once

#include <planish/job/maker.hpp>
#include <planish/job/options.hpp>

#include <array>
#include <string_view>

namespace planish::job {

/// Options of the press brake and of the order of bends, beside those of making the sheet.
inline constexpr std::array<std::string_view, 8> kPlanOptions{
    "tools", "springback", "clearance", "shortfall", "opening", "weights", "fix", "first"};

/// Whether an option says how the sheet is made that is to be bent: how it bends and is laid flat,
/// not how it is written or checked. Not `material`, whose words may stand for metals.
bool is_of_sheet_to_bend(const Option& option);

/// `maker` as `planish bend` uses it: with these options, those above, and the metal's.
Maker bending_with(const Maker& maker);

}  // namespace planish::job
