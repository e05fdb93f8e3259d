#include "option_parts.hpp"

#include <planish/job/options.hpp>

#include <algorithm>

namespace planish::cli {

std::string flag_of(std::string_view option) {
  std::string flag = "--" + std::string(option);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

std::string spelled(const std::string& message) {
  std::string text = message;
  for (const job::Option& option : job::options()) {
    const std::string quoted = "`" + std::string(option.name) + "`";
    for (auto at = text.find(quoted); at != std::string::npos; at = text.find(quoted, at))
      text.replace(at, quoted.size(), flag_of(option.name));
  }
  return text;
}

CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& target,
                      const std::string& type, const std::string& description) {
  return app.add_option(name, target, description)->check(not_empty)->type_name(type);
}

CLI::Option* add_repeatable(CLI::App& app, const std::string& name,
                            std::vector<std::string>& target, const std::string& description) {
  return app.add_option(name, target, description)->allow_extra_args(false)->check(not_empty);
}

std::string not_empty(const std::string& text) { return text.empty() ? "is empty" : ""; }

}  // namespace planish::cli
