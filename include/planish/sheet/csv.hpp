#pragma once

#include <planish/base/result.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planish {

/// One record of a CSV text: trimmed fields without their quotes, and the line it begins on.
struct CsvRecord {
  int line = 0;
  std::vector<std::string> fields;
};

/// Splits CSV as spreadsheets write it: a byte order mark, any kind of line end, fields quoted
/// (doubled quotes and line ends inside), a first line "sep=;", empty lines, and comments from a
/// `#` at the start of a field to the end of the line. The separator is the first record's: a
/// semicolon if it has one, else a tab, else a comma. Errors: `invalid_input` with name:line.
Result<std::vector<CsvRecord>> split_csv(std::string_view text, const std::string& name);

/// A number of up to six digits, without an exponent and without zeros that say nothing; a whole
/// number of more digits keeps them. Empty for what is not known or not a number.
std::string csv_number(double value);
std::string csv_number(const std::optional<double>& value);

/// A row as CSV (RFC 4180) with its line end: cells in which a separator, quote or line break would
/// be misread are quoted.
std::string csv_row(const std::vector<std::string>& cells);

}  // namespace planish
