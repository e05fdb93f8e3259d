#include "help_format.hpp"

#include <sstream>
#include <string>

namespace planish::cli {
namespace {

constexpr std::size_t kLeft = 28;
constexpr std::size_t kRight = 52;

// CLI11 indents text after a line break, but does not wrap lines.
std::string wrapped(const std::string& text) {
  std::istringstream words(text);
  std::string lines, word;
  std::size_t column = 0;
  while (words >> word) {
    const bool fits = column + 1 + word.size() <= kRight;
    if (column > 0) lines += fits ? ' ' : '\n';
    column = (column > 0 && fits ? column + 1 : 0) + word.size();
    lines += word;
  }
  return lines;
}

class Format : public CLI::Formatter {
 public:
  Format() { column_width(kLeft); }

  std::string make_option_desc(const CLI::Option* option) const override {
    return wrapped(CLI::Formatter::make_option_desc(option));
  }

  // A vector's "..." would suggest several values after one option.
  std::string make_option_opts(const CLI::Option* option) const override {
    if (option->get_type_size() == 0) return {};
    return " " + plain_type(*option);
  }
};

}  // namespace

std::string plain_type(const CLI::Option& option) {
  if (option.get_type_size() == 0) return {};
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));
}

std::shared_ptr<CLI::FormatterBase> help_format() { return std::make_shared<Format>(); }

}  // namespace planish::cli
