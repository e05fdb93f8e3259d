#include <planish/job/bend.hpp>

namespace planish::job {

bool is_of_sheet_to_bend(const Option& option) {
  return option.on_command_line && option.name != "material" &&
         (option.group == "Input" || option.group == "Bends" || option.group == "Joining" ||
          option.group == "Shop" || option.name == "units");
}

Maker bending_with(const Maker& maker) {
  Maker bending = maker;
  bending.name = "bend";
  std::erase_if(bending.options, [](const OptionUse& use) {
    return !is_of_sheet_to_bend(use.entry()) && use.name != "material";
  });
  for (const std::string_view name : kPlanOptions)
    bending.options.push_back({name});
  for (const std::string_view name : {"metal", "search_time"})
    bending.options.push_back({name});
  return bending;
}

}  // namespace planish::job
