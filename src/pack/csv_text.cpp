#include "csv_text.hpp"

#include <planish/base/text.hpp>

namespace planish::pack {

std::string csv_number(double value) { return trimmed_number(value, 3); }

std::string csv_number(const std::optional<double>& value) {
  return value ? csv_number(*value) : std::string();
}

}  // namespace planish::pack
