#pragma once

#include <optional>
#include <string>

namespace planish::pack {

/// To a thousandth, without trailing zeros; empty for what is not known.
std::string csv_number(double value);
std::string csv_number(const std::optional<double>& value);

}  // namespace planish::pack
