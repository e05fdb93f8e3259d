#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/csv.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace planish::sheet_detail {

/// What a column of a bend table can hold.
enum class Column { ratio, radius, thickness, angle, k, allowance, deduction };
constexpr size_t index_of(Column column) { return static_cast<size_t>(column); }
inline constexpr size_t kColumns = 7;
inline constexpr std::array<std::string_view, kColumns> kColumnNames{"R/T", "R",  "T", "angle",
                                                                     "K",   "BA", "BD"};

/// What a header cell says about its column: a value is shift + scale · number, in mm or degrees.
struct Heading {
  Column column;
  double scale = 1.0;
  double shift = 0.0;
  size_t field = 0;
};

/// An error in a line of a table, `{@line}` of the refusal.
Error table_error(const Refusal& refusal, const std::string& name, int line, Facts facts = {});

/// The columns of a bend table, and the kind of table that they make.
class TableShape {
 public:
  /// Reads the header row. Errors: `invalid_input` if it does not identify a bend and one value.
  static Result<TableShape> from(const CsvRecord& header, const std::string& name);

  bool has(Column column) const { return headings_[index_of(column)].has_value(); }
  const Heading& at(Column column) const { return *headings_[index_of(column)]; }
  bool by_ratio() const { return !(has(Column::radius) && has(Column::thickness)); }
  Column value() const {
    return has(Column::k)           ? Column::k
           : has(Column::allowance) ? Column::allowance
                                    : Column::deduction;
  }

 private:
  /// What is wrong with the columns.
  const Refusal* problem() const;

  std::array<std::optional<Heading>, kColumns> headings_;
};

}  // namespace planish::sheet_detail
