#include "bend_table_columns.hpp"
#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/sheet/allowance.hpp>
#include <planish/sheet/csv.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

// A bend table from CSV. Rows become numbers with the units and shifts of their columns
// (bend_table_columns.cpp), and whatever cannot be is refused with its line: an impossible value,
// more fields than headings, which tells unquoted decimal commas, and two rows for one bend, which
// tell two materials in one file.

namespace planish {
namespace {

using namespace sheet_detail;

/// Reads a number; a comma alone is a decimal comma.
std::optional<double> number(std::string text) {
  if (text.find('.') == std::string::npos && std::ranges::count(text, ',') == 1)
    text[text.find(',')] = '.';
  const char* first = text.data();
  const char* last = first + text.size();
  if (first != last && *first == '+') ++first;
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Why a value is impossible; empty if it is possible.
std::string_view objection(Column column, double value) {
  switch (column) {
    case Column::ratio:
      return value < 0.0 ? "R/T must not be negative" : "";
    case Column::radius:
      return value < 0.0 ? "R must not be negative" : "";
    case Column::thickness:
      return value <= 0.0 ? "T must be positive" : "";
    case Column::angle:
      return value <= 0.0 || value >= 360.0 ? "the bend angle must lie between 0 and 360 degrees"
                                            : "";
    case Column::k:
      return value < 0.0 || value > 1.0 ? "K must lie between 0 and 1" : "";
    case Column::allowance:
      return value < 0.0 ? "BA must not be negative" : "";
    case Column::deduction:
      return "";
  }
  return "";
}

std::string_view unit_of(Column column) {
  if (column == Column::ratio || column == Column::k) return unit::none;
  return column == Column::angle ? unit::degrees : unit::mm;
}

Result<double> cell_value(const CsvRecord& record, const Heading& heading,
                          const std::string& name) {
  const std::string_view column = kColumnNames[index_of(heading.column)];
  if (heading.field >= record.fields.size() || record.fields[heading.field].empty())
    return fail(table_error(refuse::cell_missing, name, record.line, {{"column", column}}));
  const std::string& text = record.fields[heading.field];
  const auto read = number(text);
  if (!read) {
    return fail(table_error(refuse::cell_not_a_number, name, record.line,
                            {{"cell", shortened(text)}, {"column", column}}));
  }
  const double value = heading.shift + heading.scale * *read;
  if (const std::string_view why = objection(heading.column, value); !why.empty())
    return fail(table_error(
        refuse::cell_out_of_range, name, record.line,
        {{"rule", why}, {"cell", shortened(text)}, {"value", value, unit_of(heading.column)}}));
  return value;
}

Result<BendTable::Row> parse_row(const TableShape& shape, const CsvRecord& record,
                                 const std::string& name) {
  using Row = BendTable::Row;
  Row row;
  for (const auto& [column, member] :
       {std::pair{shape.by_ratio() ? Column::ratio : Column::radius, &Row::radius},
        {Column::thickness, &Row::thickness},
        {Column::angle, &Row::angle},
        {shape.value(), &Row::value}}) {
    if (!shape.has(column)) continue;
    const auto value = cell_value(record, shape.at(column), name);
    if (!value) return pass_on(value);
    row.*member = *value;
  }
  return row;
}

/// More fields than headings are a sign of unquoted decimal commas in comma-separated files.
std::optional<Error> too_many_fields(const CsvRecord& header, const CsvRecord& record,
                                     const std::string& name) {
  size_t used = record.fields.size();
  while (used > 0 && record.fields[used - 1].empty())
    --used;
  if (used <= header.fields.size()) return std::nullopt;
  return table_error(refuse::too_many_fields, name, record.line,
                     {{"count", used}, {"wanted", header.fields.size()}});
}

/// Two rows for one bend: usually two materials in one file.
std::optional<Error> contradiction(const BendTable& table, const std::vector<int>& lines) {
  const auto key = [](const BendTable::Row& r) {
    return std::array{r.thickness, r.angle, r.radius};
  };
  std::vector<size_t> order(table.rows.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::ranges::stable_sort(order, {}, [&](size_t row) { return key(table.rows[row]); });
  for (size_t i = 0; i + 1 < order.size(); ++i) {
    const BendTable::Row& a = table.rows[order[i]];
    const BendTable::Row& b = table.rows[order[i + 1]];
    if (key(a) != key(b) || a.value == b.value) continue;
    return table_error(refuse::contradicting_rows, table.name, lines[order[i + 1]],
                       {{"value", b.value, unit::none},
                        {"earlier", place::line(lines[order[i]])},
                        {"earlier_value", a.value, unit::none}});
  }
  return std::nullopt;
}

BendTable::Value value_of(Column column) {
  if (column == Column::k) return BendTable::Value::k_factor;
  return column == Column::allowance ? BendTable::Value::allowance : BendTable::Value::deduction;
}

}  // namespace

Result<BendTable> parse_bend_table(const std::string& csv, const std::string& name) {
  const auto records = split_csv(csv, name);
  if (!records) return pass_on(records);
  if (records->empty()) return fail(refuse::empty_table, {}, name);
  const CsvRecord& header = records->front();
  const auto shape = TableShape::from(header, name);
  if (!shape) return pass_on(shape);

  BendTable table{value_of(shape->value()), shape->by_ratio(), shape->has(Column::angle), {}, name};
  std::vector<int> lines;
  for (auto record = records->begin() + 1; record != records->end(); ++record) {
    if (auto error = too_many_fields(header, *record, name)) return tl::unexpected(*error);
    const auto row = parse_row(*shape, *record, name);
    if (!row) return pass_on(row);
    table.rows.push_back(*row);
    lines.push_back(record->line);
  }
  if (table.rows.empty()) return fail(table_error(refuse::no_rows_follow, name, header.line));
  if (auto error = contradiction(table, lines)) return tl::unexpected(*error);
  return table;
}

}  // namespace planish
