#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace planish::job {

/// The content of an option's file; `name` is for messages and reports.
struct OptionFile {
  std::string name, text;
};

using OptionValue = std::variant<bool, double, std::string, OptionFile,
                                 std::vector<std::pair<std::string, double>>>;

}  // namespace planish::job
