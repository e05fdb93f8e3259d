#include "summary_csv.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/sheet/csv.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

namespace planish::batch {
namespace {

std::string cell(const std::string& text) { return text; }

/// What would help with its warnings.
std::string remedies_of(const PartRecord& part) {
  std::vector<std::string> all;
  for (const RecordedFinding& warning : warnings_of(part))
    all.insert(all.end(), warning.remedies.begin(), warning.remedies.end());
  return fmt::format("{}", fmt::join(all, "; "));
}

/// The warnings that these would help with.
std::string remedied_of(const PartRecord& part) {
  std::vector<std::string> all;
  for (const RecordedFinding& warning : warnings_of(part))
    if (!warning.remedies.empty()) all.push_back(warning.message);
  return fmt::format("{}", fmt::join(all, " "));
}

std::string cell(const std::optional<double>& number) { return csv_number(number); }
std::string cell(const std::optional<int>& number) {
  return number ? std::to_string(*number) : std::string();
}

/// Titles and cells.
std::vector<std::pair<std::string, std::string>> row_of(const PartRecord& part,
                                                        const std::string& same_as) {
  return {{"input", cell(part.input)},
          {"body", cell(part.body)},
          {"quantity", cell(part.quantity)},
          {"status", cell(part.status)},
          {"reason", cell(part.reason)},
          {"message", cell(part.message)},
          {"units", cell(part.units)},
          {"thickness", cell(part.thickness)},
          {"length", cell(part.length)},
          {"width", cell(part.width)},
          {"area", cell(part.area)},
          {"outer_cutting", cell(part.outer_cutting)},
          {"inner_cutting", cell(part.inner_cutting)},
          {"openings", cell(part.openings)},
          {"bends", cell(part.bends)},
          {"mass", cell(part.mass)},
          {"volume_ratio", cell(part.volume_ratio)},
          {"warnings", std::to_string(warnings_of(part).size())},
          {"files", fmt::format("{}", fmt::join(part.written, ";"))},
          {"same_as", same_as},
          {"material", cell(part.material)},
          {"remedies", remedies_of(part)},
          {"remedied", remedied_of(part)}};
}

}  // namespace

std::string csv_titles() {
  const auto titles = mapped(row_of({}, {}), [&](const auto& row) { return row.first; });
  return csv_row(titles);
}

std::string csv_of(const PartRecord& part, const std::string& same_as) {
  const auto cells = mapped(row_of(part, same_as), [&](const auto& row) { return row.second; });
  return csv_row(cells);
}

}  // namespace planish::batch
