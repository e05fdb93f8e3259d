#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/job/slit_json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

// Points of a scan from text, a line each (formats.md#points). Programs write them in many ways: a
// line whose first three fields each have one comma between digits has decimal commas, elsewhere
// commas separate. Each line is judged by itself.

namespace planish::job {
namespace {

constexpr std::string_view kBetween = " \t\r,;";

/// "320,04 446,08 1,5": a comma in each of the first three fields, between digits.
bool has_decimal_commas(std::string_view line) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  constexpr std::string_view kFieldEnds = " \t\r;";
  for (int field = 0; field < 3; ++field) {
    line.remove_prefix(std::min(line.find_first_not_of(kFieldEnds), line.size()));
    const std::string_view number = line.substr(0, line.find_first_of(kFieldEnds));
    const std::size_t comma = number.find(',');
    if (comma == std::string_view::npos || comma == 0 || comma + 1 >= number.size() ||
        number.find(',', comma + 1) != std::string_view::npos)
      return false;
    if (!is_digit(number[comma - 1]) || !is_digit(number[comma + 1])) return false;
    line.remove_prefix(number.size());
  }
  return true;
}

/// Takes the next number off the front of a line.
bool take_number(std::string_view& line, double& number) {
  line.remove_prefix(std::min(line.find_first_not_of(kBetween), line.size()));
  if (!line.empty() && line.front() == '+') line.remove_prefix(1);
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
  if (error != std::errc() || !std::isfinite(number)) return false;
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  return line.empty() || kBetween.find(line.front()) != std::string_view::npos;
}

}  // namespace

Result<std::vector<Vec3>> parse_points(const std::string& text, const std::string& name,
                                       double scale) {
  std::vector<Vec3> points;
  std::string_view rest = without_byte_order_mark(text);
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, length);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(kBetween) == std::string_view::npos) continue;
    std::string with_points;
    if (has_decimal_commas(line)) {
      with_points = line;
      std::ranges::replace(with_points, ',', '.');
      line = with_points;
    }
    Vec3 p;
    if (!take_number(line, p.x()) || !take_number(line, p.y()) || !take_number(line, p.z()))
      return fail(refuse::bad_scan_line, {{"line", place::line(number)}},
                  fmt::format("{}:{}", name, number));
    points.push_back(scale * p);
  }
  return points;
}

}  // namespace planish::job
