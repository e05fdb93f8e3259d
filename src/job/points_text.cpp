#include <planish/job/slit_json.hpp>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

namespace planish::job {
namespace {

constexpr std::string_view kBetween = " \t\r,;";

/// The next number of a line, which is shortened by it.
bool take_number(std::string_view& line, double& number) {
  line.remove_prefix(std::min(line.find_first_not_of(kBetween), line.size()));
  if (!line.empty() && line.front() == '+') line.remove_prefix(1);
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
  if (error != std::errc() || !std::isfinite(number)) return false;
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  return line.empty() || kBetween.find(line.front()) != std::string_view::npos;
}

}  // namespace

Result<std::vector<Vec3>> parse_points(const std::string& text, const std::string& name, double scale) {
  std::vector<Vec3> points;
  std::string_view rest = text;
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t length = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, length);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(kBetween) == std::string_view::npos) continue;
    Vec3 p;
    if (!take_number(line, p.x()) || !take_number(line, p.y()) || !take_number(line, p.z()))
      return fail(ErrorCode::invalid_input, "a line of a scan must begin with three numbers, x y z", fmt::format("{}:{}", name, number));
    points.push_back(scale * p);
  }
  return points;
}

}  // namespace planish::job
