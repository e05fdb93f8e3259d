#include "input.hpp"

#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/schema/printable.hpp>
#include <planish/schema/text_file.hpp>
#include <planish/schema/units.hpp>

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <vector>

namespace planish::job {
using namespace schema;
namespace {

constexpr int kListedBodies = 12;  // in a message

std::string body_list(const StepFile& file) {
  std::string text;
  const int n = static_cast<int>(file.bodies.size());
  for (int i = 0; i < n && i < kListedBodies; ++i) {
    const Body& body = file.bodies[i];
    text += fmt::format("{}{} \"{}\"", i ? ", " : "", i + 1, printable_name(body.name()));
    if (body.quantity() > 1) text += fmt::format(" (×{})", body.quantity());
  }
  if (n > kListedBodies) text += fmt::format(" and {} more", n - kListedBodies);
  return text;
}

std::optional<int> as_number(const std::string& text) {
  int number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

std::vector<int> bodies_named(const StepFile& file, const std::string& name) {
  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(file.bodies.size()); ++i) {
    if (file.bodies[i].name() == name) found.push_back(i);
  }
  return found;
}

}  // namespace

Result<StepFile> read_input(const std::filesystem::path& input, const Progress& progress) {
  if (input != "-") return read_step(input, progress);
  const auto text = read_text(input, "STEP file");
  if (!text) return pass_on(text);
  if (progress.should_stop()) return fail(refuse::cancelled);
  return read_step_text(*text, "standard input", progress);
}

Result<int> choose_body(const StepFile& file, const std::string& wanted) {
  const int n = static_cast<int>(file.bodies.size());
  if (wanted.empty()) {
    if (n == 1) return 0;
    return fail(refuse::body_unchosen, {{"count", n}, {"known", body_list(file)}}, "body");
  }
  // Numbers take precedence: a name can be anything, but every body has a number.
  if (const auto number = as_number(wanted); number && *number >= 1 && *number <= n) {
    return *number - 1;
  }
  const std::vector<int> named = bodies_named(file, wanted);
  if (named.size() == 1) return named.front();
  if (named.empty()) {
    return fail(n == 1 ? refuse::not_the_body : refuse::no_body,
                {{"body", shortened(wanted)}, {"known", body_list(file)}}, "body");
  }
  Facts facts{{"body", shortened(wanted)}, {"known", body_list(file)}};
  for (const int i : named)
    facts.emplace_back("same", place::body(i + 1));
  return fail(refuse::body_name_twice, facts, "body");
}

}  // namespace planish::job
