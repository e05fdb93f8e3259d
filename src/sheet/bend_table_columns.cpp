#include "bend_table_columns.hpp"

#include "refusals.hpp"

#include <planish/base/text.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>

// Columns of a bend table, as shops name them (formats.md#bend-table). A heading is squeezed to
// letters and digits and looked up, with a unit in brackets or at its end; columns that are not
// ours are skipped. Values are then one linear function away from r/t, mm, degrees or K. A header
// that leaves a value unclear, or gives one twice, is refused.

namespace planish::sheet_detail {
namespace {

/// How a header may spell a column: lower case, nothing but letters, digits and '/'. Values are
/// turned into the column's own by `shift` + `scale` · value.
struct Spelling {
  std::string_view text;
  Column column;
  double scale = 1.0;
  double shift = 0.0;
};

constexpr double kDinToK = 0.5;                   // DIN's k refers to T/2
constexpr double kYToK = 2.0 / std::numbers::pi;  // K = 2 Y / π
constexpr std::array kSpellings{
    Spelling{"r/t", Column::ratio},
    Spelling{"ri/t", Column::ratio},
    Spelling{"r/s", Column::ratio},
    Spelling{"radius/thickness", Column::ratio},
    Spelling{"rtratio", Column::ratio},
    Spelling{"r/tratio", Column::ratio},
    Spelling{"ratio", Column::ratio},
    Spelling{"r", Column::radius},
    Spelling{"ri", Column::radius},
    Spelling{"ir", Column::radius},
    Spelling{"radius", Column::radius},
    Spelling{"insideradius", Column::radius},
    Spelling{"innerradius", Column::radius},
    Spelling{"bendradius", Column::radius},
    Spelling{"insidebendradius", Column::radius},
    Spelling{"innerbendradius", Column::radius},
    Spelling{"t", Column::thickness},
    Spelling{"s", Column::thickness},
    Spelling{"thickness", Column::thickness},
    Spelling{"sheetthickness", Column::thickness},
    Spelling{"materialthickness", Column::thickness},
    Spelling{"angle", Column::angle},
    Spelling{"bendangle", Column::angle},
    Spelling{"alpha", Column::angle},
    Spelling{"a", Column::angle},
    Spelling{"openingangle", Column::angle, -1.0, 180.0},
    Spelling{"includedangle", Column::angle, -1.0, 180.0},
    Spelling{"k", Column::k},
    Spelling{"kfactor", Column::k},
    Spelling{"kvalue", Column::k},
    Spelling{"dink", Column::k, kDinToK},
    Spelling{"kdin", Column::k, kDinToK},
    Spelling{"y", Column::k, kYToK},
    Spelling{"yfactor", Column::k, kYToK},
    Spelling{"ba", Column::allowance},
    Spelling{"bendallowance", Column::allowance},
    Spelling{"allowance", Column::allowance},
    Spelling{"bd", Column::deduction},
    Spelling{"benddeduction", Column::deduction},
    Spelling{"deduction", Column::deduction},
};

struct UnitName {
  std::string_view text;
  bool is_angle;
  double scale;  // to mm or degrees
};

constexpr std::array kUnits{
    UnitName{"millimeters", false, 1.0},
    UnitName{"millimetres", false, 1.0},
    UnitName{"mm", false, 1.0},
    UnitName{"inches", false, 25.4},
    UnitName{"inch", false, 25.4},
    UnitName{"in", false, 25.4},
    UnitName{"\"", false, 25.4},
    UnitName{"degrees", true, 1.0},
    UnitName{"deg", true, 1.0},
    UnitName{"°", true, 1.0},
    UnitName{"\xB0", true, 1.0},  // the degree sign as Windows' own code page writes it
    UnitName{"radians", true, 180.0 / std::numbers::pi},
    UnitName{"rad", true, 180.0 / std::numbers::pi},
};

std::string squeezed(std::string_view text) {
  std::string result = lower_case(text);
  std::erase_if(result, [](char c) {
    return !((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '/');
  });
  return result;
}

std::string without_blanks(std::string_view text) {
  std::string result = lower_case(text);
  std::erase(result, ' ');
  return result;
}

const Spelling* spelling_of(std::string_view name) {
  const auto found = std::ranges::find(kSpellings, name, &Spelling::text);
  return found == kSpellings.end() ? nullptr : &*found;
}

bool has_unit(Column column, const UnitName& unit) {
  switch (column) {
    case Column::ratio:
    case Column::k:
      return false;
    case Column::angle:
      return unit.is_angle;
    default:
      return !unit.is_angle;
  }
}

Heading heading(const Spelling& spelling, double unit_scale, size_t field) {
  return {spelling.column, spelling.scale * unit_scale, spelling.shift, field};
}

/// The heading of one header cell; none for columns that are not ours.
Result<std::optional<Heading>> parse_heading(const CsvRecord& header, size_t field,
                                             const std::string& name) {
  const std::string& cell = header.fields[field];
  const size_t open = cell.find_first_of("([");
  if (const Spelling* spelling = spelling_of(squeezed(cell.substr(0, open)))) {
    if (open == std::string::npos) return heading(*spelling, 1.0, field);
    const std::string unit_text = without_blanks(
        cell.substr(open + 1, cell.find_first_of(")]", open) - open - 1));
    const bool unitless = spelling->column == Column::ratio || spelling->column == Column::k;
    const bool remark = unitless && unit_text.find('%') == std::string::npos;  // as in "K (ANSI)"
    if (unit_text.empty() || remark) return heading(*spelling, 1.0, field);
    for (const UnitName& unit : kUnits)
      if (unit.text == unit_text && has_unit(spelling->column, unit))
        return heading(*spelling, unit.scale, field);
    return fail(
        table_error(refuse::unknown_unit, name, header.line, {{"column", shortened(cell)}}));
  }
  // "R_mm", "T mm", "Angle deg": the unit without brackets.
  const std::string whole = without_blanks(cell.substr(0, open));
  for (const UnitName& unit : kUnits) {
    if (!whole.ends_with(unit.text)) continue;
    const Spelling* spelling = spelling_of(
        squeezed(whole.substr(0, whole.size() - unit.text.size())));
    if (spelling && has_unit(spelling->column, unit)) return heading(*spelling, unit.scale, field);
  }
  return std::nullopt;
}

}  // namespace

Error table_error(const Refusal& refusal, const std::string& name, int line, Facts facts) {
  facts.emplace(facts.begin(), "line", place::line(line));
  return error_of(refusal, facts, fmt::format("{}:{}", name, line));
}

Result<TableShape> TableShape::from(const CsvRecord& header, const std::string& name) {
  TableShape shape;
  for (size_t i = 0; i < header.fields.size(); ++i) {
    const auto found = parse_heading(header, i, name);
    if (!found) return pass_on(found);
    if (!found->has_value()) continue;
    auto& known = shape.headings_[index_of((*found)->column)];
    if (known) {
      return fail(table_error(refuse::column_twice, name, header.line,
                              {{"first", shortened(header.fields[known->field])},
                               {"second", shortened(header.fields[i])},
                               {"what", kColumnNames[index_of(known->column)]}}));
    }
    known = **found;
  }
  if (const Refusal* problem = shape.problem()) {
    const std::string names = fmt::format("{}", fmt::join(header.fields, "\", \""));
    return fail(table_error(*problem, name, header.line, {{"header", shortened(names, 200)}}));
  }
  return shape;
}

const Refusal* TableShape::problem() const {
  const int values = has(Column::k) + has(Column::allowance) + has(Column::deduction);
  if (values == 0 || (by_ratio() && !has(Column::ratio))) return &refuse::incomplete_header;
  if (values > 1) return &refuse::several_values;
  if (by_ratio() && (has(Column::radius) || has(Column::thickness)))
    return &refuse::ratio_and_lengths;
  if (by_ratio() && !has(Column::k)) return &refuse::lengths_need_sizes;
  return nullptr;
}

}  // namespace planish::sheet_detail
