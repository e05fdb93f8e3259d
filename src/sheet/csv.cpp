// Comma-separated values as spreadsheets write them (RFC 4180, with semicolons, tabs and comments):
// one walk through the text, which counts lines in whatever way they end, quoted ones too, so that
// an error has the line that an editor shows.

#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/sheet/csv.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace planish {
namespace {

std::string trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(kBlanks) - first + 1));
}

bool line_end(char c) { return c == '\n' || c == '\r'; }

/// Walks the text once, with the separator known.
class CsvReader {
 public:
  CsvReader(std::string_view text, char separator, std::string name)
      : text_(text), separator_(separator), name_(std::move(name)) {}

  Result<std::vector<CsvRecord>> records() {
    std::vector<CsvRecord> result;
    while (at_ < text_.size()) {
      auto record = next();
      if (!record) return pass_on(record);
      const bool empty = std::ranges::all_of(
          record->fields, [](const std::string& field) { return field.empty(); });
      if (!empty) result.push_back(std::move(*record));
    }
    return result;
  }

 private:
  Result<CsvRecord> next() {
    CsvRecord record{line_, {}};
    while (true) {
      skip_blanks();
      if (at_ < text_.size() && text_[at_] == '#') skip_comment();
      auto field = at_ < text_.size() && text_[at_] == '"' ? quoted()
                                                           : Result<std::string>(plain());
      if (!field) return pass_on(field);
      record.fields.push_back(trimmed(*field));
      if (at_ >= text_.size() || text_[at_] != separator_) break;
      ++at_;
    }
    end_line();
    return record;
  }

  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t') &&
           text_[at_] != separator_)
      ++at_;
  }

  void skip_comment() {
    while (at_ < text_.size() && !line_end(text_[at_]))
      ++at_;
  }

  /// Up to the separator, the end of the line or a comment after a blank.
  std::string plain() {
    const size_t from = at_;
    while (at_ < text_.size() && text_[at_] != separator_ && !line_end(text_[at_])) {
      if (text_[at_] == '#' && at_ > from && (text_[at_ - 1] == ' ' || text_[at_ - 1] == '\t'))
        break;
      ++at_;
    }
    std::string field(text_.substr(from, at_ - from));
    if (at_ < text_.size() && text_[at_] == '#') skip_comment();
    return field;
  }

  Result<std::string> quoted() {
    const int opened = line_;
    std::string field;
    for (++at_; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"' && at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
        ++at_;
      } else if (c == '"') {
        ++at_;
        return field + plain();  // text after the closing quote is blank, or belongs to the field
      } else if (c == '\n' || (c == '\r' && !(at_ + 1 < text_.size() && text_[at_ + 1] == '\n'))) {
        ++line_;
      }
      field += c;
    }
    return fail(refuse::open_quote, {{"line", place::line(opened)}},
                name_ + ":" + std::to_string(opened));
  }

  void end_line() {
    if (at_ >= text_.size()) return;
    if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
    ++at_;
    ++line_;
  }

  std::string_view text_;
  char separator_;
  std::string name_;
  size_t at_ = 0;
  int line_ = 1;
};

/// The separator of the first line that is neither empty nor a comment.
char separator_of(std::string_view text) {
  while (!text.empty()) {
    const size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string line = trimmed(text.substr(0, end));
    if (!line.empty() && line.front() != '#') {
      if (line.find(';') != std::string::npos) return ';';
      // A tab that stands inside the trimmed line separates; a trailing one may be stray.
      return line.find('\t') != std::string::npos ? '\t' : ',';
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return ',';
}

}  // namespace

Result<std::vector<CsvRecord>> split_csv(std::string_view text, const std::string& name) {
  text = without_byte_order_mark(text);
  if (text.find('\0') != std::string_view::npos) {
    return fail(refuse::not_plain_text, {}, name);
  }
  char separator = separator_of(text);
  std::string blank_head;
  if (text.size() >= 5 && (text.substr(0, 4) == "sep=" || text.substr(0, 4) == "SEP=")) {
    separator = text[4];
    blank_head = "#" + std::string(text);  // Excel's hint becomes a comment, so that lines keep
                                           // their numbers
    text = blank_head;
  }
  return CsvReader(text, separator, name).records();
}

std::string csv_number(double value) {
  constexpr int kDigits = 6;
  constexpr double kLeast = 1e-9;  // in any unit: the rounding of what is 0
  if (!std::isfinite(value)) return {};
  const double size = std::abs(value);
  if (size < kLeast) return "0";
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
  return trimmed_number(value, std::max(0, kDigits - before));
}

std::string csv_number(const std::optional<double>& value) {
  return value ? csv_number(*value) : std::string();
}

std::string csv_row(const std::vector<std::string>& cells) {
  std::string row;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) row += ',';
    if (cell.find_first_of(",;\"\r\n") == std::string::npos) {
      row += cell;
      continue;
    }
    row += '"' + replaced(cell, {{'"', "\"\""}}) + '"';
  }
  return row + "\n";
}

}  // namespace planish
