#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace planish::batch {

/// What tables show of a part; numbers as the report has them, empty where it has none.
struct Row {
  std::string input, body, folder, quantity, status, reason, message, units;
  std::string thickness, length, width, area, outer_cutting, inner_cutting, openings, bends, mass;
  std::string volume_ratio, warnings, files, material;
  std::string findings = {};  ///< codes of warnings and errors, each once
  std::string same_as = {};   ///< the folder of the first identical part; empty for the first
};

/// From a report on one line.
Row row_of(const std::string& folder, const std::string& report);

/// The table as CSV (RFC 4180), titles first; `csv_titles` names the columns.
std::string csv_titles();
std::string csv_of(const Row& row);

}  // namespace planish::batch
