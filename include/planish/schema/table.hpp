#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace planish::schema {

/// Columns of text that line up on a terminal; widths count code points, not bytes.
class Table {
 public:
  enum class Align { left, right };
  struct Column {
    std::string title;
    Align align = Align::left;
    std::size_t most = 0;  ///< characters of a cell, a name (`printable_name`); 0: any number
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// One cell per column; characters that could affect a terminal are replaced (see `printable`).
  void add(std::vector<std::string> cells);
  /// Title line and rows, each after `indent`, with two blanks between columns and none at the end.
  std::string text(std::string_view indent = "") const;

 private:
  std::vector<std::size_t> widths() const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Number of code points of UTF-8 text.
std::size_t display_width(std::string_view text);

}  // namespace planish::schema
