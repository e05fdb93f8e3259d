// All options in one list, in the order of the help, and those that say which part is read and in
// which unit it is told. The others are in the tables of option_tables.hpp.
#include "option_tables.hpp"

#include <planish/base/assert.hpp>

#include <algorithm>

namespace planish::job {
namespace {

Result<void> set_units(Request& to, const OptionValue& value) {
  to.units = given_text(value) == "inch" ? LengthUnit::inch
             : given_text(value) == "m"  ? LengthUnit::m
                                         : LengthUnit::mm;
  return {};
}

const std::vector<Option>& general_options() {
  static const std::vector<Option> table = joined({
      {OptionGroup::input,
       {
           row::name("body",
                     "body to use if there are several: its number (see `planish info`) or name",
                     stored<&Request::body>),
       }},
      {OptionGroup::output,
       {
           row::word("units", {"mm", "inch", "m"}, "", "unit of the DXF and of the reports",
                     set_units),
           {.name = "piece",
            .kind = OptionKind::whole,
            .description = "piece to show if there are several, from 0",
            .otherwise = "0",
            .range = {"a whole number of at least 0", 0.0},
            .on_command_line = false,
            .set = stored<&Request::piece>},
       }},
  });
  return table;
}

}  // namespace

std::vector<Option> joined(std::vector<OptionRows> groups) {
  std::vector<Option> table;
  for (OptionRows& one : groups)
    for (Option& row : one.rows) {
      row.group = one.group;
      table.push_back(std::move(row));
    }
  return table;
}

std::string_view heading(OptionGroup group) {
  constexpr std::string_view kHeadings[] = {"",      "Input",   "Output",          "Shop",
                                            "Bends", "Joining", "Formed features", "Corners",
                                            "DXF",   "Checks",  "Press brake",     "Order"};
  return kHeadings[static_cast<int>(group)];
}

std::span<const Option> options() {
  static const std::vector<Option> all = [] {
    std::vector<Option> every;
    // A shop comes before all that may take the place of what it says.
    for (const auto* table : {&general_options(), &shop_options(), &sheet_options(), &dxf_options(),
                              &check_options(), &bending_options()})
      every.insert(every.end(), table->begin(), table->end());
    return every;
  }();
  return all;
}

const Option& OptionUse::entry() const { return own ? *own : option(name); }

const Option& option(std::string_view name) {
  const auto all = options();
  const auto found = std::ranges::find(all, name, &Option::name);
  PLANISH_ASSERT(found != all.end());
  return *found;
}

}  // namespace planish::job
