#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/sheet/csv.hpp>
#include <planish/shop/part_materials.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

// A table that gives parts their material: the first row that matches a part's name and colour is
// used. A column that nobody reads is refused, since a person who wrote it counts on it. Patterns
// have * and ?; on a mismatch the last * takes one more letter, so matching takes no more than the
// product of both lengths, whatever the pattern.

namespace planish::shop {
namespace {

/// What is read, and where it stands.
struct ListFile {
  std::string name;
  int line = 0;
  tl::unexpected<Error> wrong(const Refusal& refusal, Facts facts = {}) const {
    facts.emplace_back("file", name);
    facts.emplace_back("line", place::line(line));
    return fail(refusal, facts, fmt::format("{}:{}", name, line));
  }
};

enum class ListColumn { part, colour, material, density, quantity };
constexpr std::array kColumns{"part", "colour", "material", "density", "quantity"};
constexpr int kAbsent = -1;

/// Where each column stands; `kAbsent`: it is not there.
using ListColumns = std::array<int, kColumns.size()>;

std::optional<std::size_t> column_called(const std::string& title) {
  // A unit may follow: "density (kg/dm³)".
  const std::string known = title == "name"                ? "part"
                            : title == "color"             ? "colour"
                            : title.starts_with("density") ? "density"
                                                           : title;
  const auto found = std::ranges::find(kColumns, known);
  if (found == kColumns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kColumns.begin());
}

Result<ListColumns> columns_of(const ListFile& file, const CsvRecord& head) {
  ListColumns columns;
  columns.fill(kAbsent);
  for (int i = 0; i < std::ssize(head.fields); ++i) {
    const std::string& title = head.fields[static_cast<std::size_t>(i)];
    if (title.empty()) continue;
    const auto column = column_called(lower_case(title));
    if (!column)
      return file.wrong(
          refuse::unknown_column,
          {{"column", shortened(title)}, {"known", fmt::format("{}", fmt::join(kColumns, ", "))}});
    if (columns[*column] != kAbsent)
      return file.wrong(refuse::column_twice, {{"column", kColumns[*column]}});
    columns[*column] = i;
  }
  const auto has = [&](ListColumn one) { return columns[static_cast<std::size_t>(one)] >= 0; };
  if ((!has(ListColumn::part) && !has(ListColumn::colour)) || !has(ListColumn::material))
    return file.wrong(refuse::no_columns);
  return columns;
}

/// The number above 0 that a whole text spells; a comma alone is a decimal comma.
std::optional<double> number_above_zero(std::string text) {
  if (text.find('.') == std::string::npos && std::ranges::count(text, ',') == 1)
    text[text.find(',')] = '.';
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value) || value <= 0.0)
    return std::nullopt;
  return value;
}

bool is_colour(const std::string& text) {
  constexpr std::size_t kLength = 7;
  return text.size() == kLength && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdef", 1) == std::string::npos;
}

Result<PartMaterial> row_of(const ListFile& file, const CsvRecord& record,
                            const ListColumns& columns) {
  const auto field = [&](ListColumn one) {
    const int column = columns[static_cast<std::size_t>(one)];
    return column >= 0 && column < std::ssize(record.fields)
               ? record.fields[static_cast<std::size_t>(column)]
               : std::string();
  };
  for (int i = 0; i < std::ssize(record.fields); ++i)
    if (const std::string& text = record.fields[static_cast<std::size_t>(i)];
        !text.empty() && std::ranges::find(columns, i) == columns.end())
      return file.wrong(refuse::field_without_column, {{"text", shortened(text)}});
  PartMaterial row{.pattern = field(ListColumn::part),
                   .material = field(ListColumn::material),
                   .colour = lower_case(field(ListColumn::colour)),
                   .line = file.line};
  if ((row.pattern.empty() && row.colour.empty()) || row.material.empty())
    return file.wrong(refuse::row_incomplete);
  // A row that begins with # is a comment, so it may be left out.
  if (!row.colour.empty() && row.colour.front() != '#') row.colour.insert(0, 1, '#');
  if (!row.colour.empty() && !is_colour(row.colour))
    return file.wrong(refuse::bad_colour, {{"colour", row.colour}});
  if (const std::string density = field(ListColumn::density); !density.empty()) {
    row.density = number_above_zero(density);
    if (!row.density) return file.wrong(refuse::bad_density, {{"density", density}});
  }
  if (const std::string quantity = field(ListColumn::quantity); !quantity.empty()) {
    const auto wanted = number_above_zero(quantity);
    if (!wanted || std::floor(*wanted) != *wanted || *wanted > kMostPieces)
      return file.wrong(refuse::bad_quantity,
                        {{"quantity", shortened(quantity)}, {"most", kMostPieces}});
    row.quantity = static_cast<int>(*wanted);
  }
  return row;
}

}  // namespace

std::string unused_row_text(const PartMaterials& list, int line) {
  const auto row = std::ranges::find(list.rows(), line, &PartMaterial::line);
  const bool counts = row != list.rows().end() && row->quantity;
  return fmt::format("{}, line {}: no part takes its material{} from this row", list.name(), line,
                     counts ? " and quantity" : "");
}

bool fits(const std::string& pattern, const std::string& name) {
  const std::string wanted = lower_case(pattern), given = lower_case(name);
  std::size_t w = 0, g = 0, star = std::string::npos, behind = 0;
  while (g < given.size()) {
    if (w < wanted.size() && wanted[w] == '*') {
      star = w++;
      behind = g;
    } else if (w < wanted.size() && (wanted[w] == '?' || wanted[w] == given[g])) {
      ++w;
      ++g;
    } else if (star != std::string::npos) {
      w = star + 1;
      g = ++behind;
    } else {
      return false;
    }
  }
  return wanted.find_first_not_of('*', w) == std::string::npos;
}

Result<PartMaterials> PartMaterials::parse(const std::string& csv, const std::string& name) {
  ListFile file{name, 1};
  const auto records = split_csv(csv, name);
  if (!records) return pass_on(records);
  if (records->empty()) return file.wrong(refuse::no_materials);
  file.line = records->front().line;
  const auto columns = columns_of(file, records->front());
  if (!columns) return pass_on(columns);
  PartMaterials materials;
  materials.name_ = name;
  for (std::size_t i = 1; i < records->size(); ++i) {
    file.line = (*records)[i].line;
    auto row = row_of(file, (*records)[i], *columns);
    if (!row) return pass_on(row);
    materials.rows_.push_back(std::move(*row));
  }
  return materials;
}

const PartMaterial* PartMaterials::find(const std::vector<std::string>& names,
                                        const std::string& colour) const {
  const auto row = std::ranges::find_if(rows_, [&](const PartMaterial& one) {
    const bool named = one.pattern.empty() || std::ranges::any_of(names, [&](const auto& name) {
                         return fits(one.pattern, name);
                       });
    return named && (one.colour.empty() || one.colour == colour);
  });
  return row == rows_.end() ? nullptr : &*row;
}

}  // namespace planish::shop
