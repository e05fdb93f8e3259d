#include <planish/base/assert.hpp>
#include <planish/schema/printable.hpp>
#include <planish/schema/table.hpp>

#include <algorithm>

namespace planish::schema {
namespace {

std::string padded(const std::string& cell, std::size_t width, Table::Align align) {
  const std::size_t own = display_width(cell);
  const std::string blanks(own < width ? width - own : 0, ' ');
  return align == Table::Align::left ? cell + blanks : blanks + cell;
}

}  // namespace

std::size_t display_width(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;  // not a continuation byte
  }));
}

void Table::add(std::vector<std::string> cells) {
  PLANISH_ASSERT(cells.size() == columns_.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
    cells[c] = printable_name(cells[c], columns_[c].most);
  rows_.push_back(std::move(cells));
}

std::vector<std::size_t> Table::widths() const {
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    std::size_t width = display_width(columns_[c].title);
    for (const auto& row : rows_)
      width = std::max(width, display_width(row[c]));
    widths.push_back(width);
  }
  return widths;
}

std::string Table::text(std::string_view indent) const {
  const std::vector<std::size_t> width = widths();
  std::string all;
  const auto put = [&](const auto& cell_of) {
    std::string line(indent);
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if (c > 0) line += "  ";
      line += padded(cell_of(c), width[c], columns_[c].align);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    all += line + "\n";
  };
  put([&](std::size_t c) { return columns_[c].title; });
  for (const auto& row : rows_) {
    put([&](std::size_t c) { return row[c]; });
  }
  return all;
}

}  // namespace planish::schema
