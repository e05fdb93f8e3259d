#pragma once

#include <optional>
#include <string>
#include <vector>

namespace planish::pack {

/// A row of CSV (RFC 4180), with its line end.
std::string csv_row(const std::vector<std::string>& cells);

/// To a thousandth, without trailing zeros; empty for what is not known.
std::string csv_number(double value);
std::string csv_number(const std::optional<double>& value);

}  // namespace planish::pack
