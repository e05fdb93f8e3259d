// The tasks: what a request can ask for. A task beside the makers is a row here and the function
// that it names.
#include "asked.hpp"

#include <algorithm>

namespace planish::job {
namespace {

Maker maker_itself(const Maker* reader) { return *reader; }
Maker bending_of(const Maker* reader) { return bending_with(*reader); }

Maker of_step(const Maker*) {
  return {.name = "info", .input = "STEP", .options = {{"body"}, {"units"}}};
}

/// A draft has no plan.
void ask_for_plan(Request& request) {
  request.effort = Effort::full;
  request.bending.ask = Bending::Ask::plan;
}

}  // namespace

const std::vector<Task>& tasks() {
  static const std::vector<Task> table{
      {.reader = Reader::named, .taking = maker_itself, .drafts = true, .run = run_maker},
      {.name = "bend",
       .description = "find the order in which a press brake bends a part",
       .details = "Find the cheapest order of strokes in which a press brake bends a part, or "
                  "prove that there is none. Reads whatever a sheet is made of: a STEP file, or a "
                  "file of another maker. Answers with the report of the part and its plan.",
       .reader = Reader::by_format,
       .taking = bending_of,
       .artifacts = std::vector<std::string_view>{"pdf", "svg", "dxf", "json"},
       .ask = ask_for_plan,
       .run = run_bend},
      {.name = "info",
       .description = "show what is in a STEP file",
       .details = "Say what is in a STEP file: its bodies with size, volume and material; with "
                  "`sheets` the sheet in each, or why there is none.",
       .taking = of_step,
       .artifacts = std::vector<std::string_view>(),
       .flags = {{"sheets", "of info: the sheet in each body, or why none"}},
       .run = run_info}};
  return table;
}

bool is_of_sheet_to_bend(const Option& option) {
  constexpr OptionGroup kGroups[] = {OptionGroup::input, OptionGroup::bends, OptionGroup::joining,
                                     OptionGroup::shop};
  return option.on_command_line && option.name != "material" &&
         (std::ranges::count(kGroups, option.group) > 0 || option.name == "units" ||
          option.name == "write_anyway");
}

Maker bending_with(const Maker& maker) {
  Maker bending = maker;
  bending.name = "bend";
  std::erase_if(bending.options, [](const OptionUse& use) {
    return !is_of_sheet_to_bend(use.entry()) && use.name != "material";
  });
  for (const std::string_view name : kPlanOptions)
    bending.options.push_back({name});
  for (const std::string_view name : {"metal", "search_time", "as_made"})
    bending.options.push_back({name});
  return bending;
}

}  // namespace planish::job
