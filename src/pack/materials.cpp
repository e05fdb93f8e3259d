#include "materials.hpp"

#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/job/options.hpp>
#include <planish/sheet/csv.hpp>

#include <fmt/format.h>

#include <algorithm>

// A table that gives parts their material: the first row that matches a part's name and colour is
// used. Patterns have * and ?; on a mismatch the last * takes one more letter, so matching takes no
// more than the product of both lengths, whatever the pattern.

namespace planish::pack {
namespace {

tl::unexpected<Error> wrong(const GivenFile& file, int line, const Refusal& refusal,
                            Facts facts = {}) {
  facts.emplace_back("file", file.name);
  facts.emplace_back("line", place::line(line));
  return fail(refusal, facts, fmt::format("{}:{}", file.name, line));
}

/// Where each column stands; -1: it is not there.
struct MaterialColumns {
  int part = -1, material = -1, density = -1, colour = -1;
};

Result<MaterialColumns> columns_of(const GivenFile& file, const CsvRecord& head) {
  MaterialColumns columns;
  for (int i = 0; i < std::ssize(head.fields); ++i) {
    const std::string title = lower_case(head.fields[static_cast<std::size_t>(i)]);
    if (title == "part" || title == "name") columns.part = i;
    if (title == "material") columns.material = i;
    if (title.starts_with("density")) columns.density = i;
    if (title == "colour" || title == "color") columns.colour = i;
  }
  if ((columns.part < 0 && columns.colour < 0) || columns.material < 0)
    return wrong(file, head.line, refuse::no_columns);
  return columns;
}

bool is_colour(const std::string& text) {
  constexpr std::size_t kLength = 7;
  return text.size() == kLength && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdef", 1) == std::string::npos;
}

}  // namespace

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

Result<Materials> Materials::parse(const GivenFile& file) {
  const auto records = split_csv(file.text, file.name);
  if (!records) return pass_on(records);
  if (records->empty()) return wrong(file, 1, refuse::no_materials);
  const auto columns = columns_of(file, records->front());
  if (!columns) return pass_on(columns);
  Materials materials;
  for (std::size_t i = 1; i < records->size(); ++i) {
    const CsvRecord& record = (*records)[i];
    const auto field = [&](int column) {
      return column >= 0 && column < std::ssize(record.fields)
                 ? record.fields[static_cast<std::size_t>(column)]
                 : std::string();
    };
    Row row{field(columns->part), field(columns->material), {}, lower_case(field(columns->colour))};
    if ((row.pattern.empty() && row.colour.empty()) || row.material.empty())
      return wrong(file, record.line, refuse::row_incomplete);
    // A row that begins with # is a comment, so it may be left out.
    if (!row.colour.empty() && row.colour.front() != '#') row.colour.insert(0, 1, '#');
    if (!row.colour.empty() && !is_colour(row.colour))
      return wrong(file, record.line, refuse::bad_colour, {{"colour", row.colour}});
    if (const std::string density = field(columns->density); !density.empty()) {
      row.density = job::parse_number(density);
      if (!row.density || *row.density <= 0.0)
        return wrong(file, record.line, refuse::bad_density, {{"density", density}});
    }
    materials.rows_.push_back(std::move(row));
  }
  return materials;
}

const Materials::Row* Materials::find(const std::vector<std::string>& names,
                                      const std::string& colour) const {
  const auto row = std::ranges::find_if(rows_, [&](const Row& one) {
    const bool named = one.pattern.empty() || std::ranges::any_of(names, [&](const auto& name) {
                         return fits(one.pattern, name);
                       });
    return named && (one.colour.empty() || one.colour == colour);
  });
  return row == rows_.end() ? nullptr : &*row;
}

}  // namespace planish::pack
