#include "step_header.hpp"

#include "refusals.hpp"

#include <planish/base/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

// What is wrong with a STEP file, seen before the kernel reads it, since the kernel gives no
// reasons: an empty file, another format, an end that is missing, no instance. The end mark is
// looked for in the last bytes, because comments may follow it. Schema and CAD system come from the
// header as it is written.

namespace planish::brep {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

std::string_view trimmed_left(std::string_view text) {
  const size_t first = text.find_first_not_of(kBlank);
  return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

/// The quoted strings of one header entity, in order; '' inside a string is one quote.
std::vector<std::string> strings_of(std::string_view header, std::string_view entity) {
  std::vector<std::string> strings;
  size_t at = header.find(entity);
  if (at == std::string_view::npos) return strings;
  bool quoted = false;
  for (at += entity.size(); at < header.size(); ++at) {
    const char c = header[at];
    if (!quoted && c == ';') break;
    if (c == '\'') {
      if (quoted && at + 1 < header.size() && header[at + 1] == '\'') {
        strings.back() += c;
        ++at;
        continue;
      }
      quoted = !quoted;
      if (quoted) strings.emplace_back();
    } else if (quoted) {
      strings.back() += c;
    }
  }
  return strings;
}

std::string application_protocol(const std::string& schema) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kProtocols{{
      {"config_control_design", "AP203"},
      {"ap203", "AP203"},
      {"automotive_design", "AP214"},
      {"ap214", "AP214"},
      {"ap242", "AP242"},
  }};
  const std::string lower = lower_case(schema);
  for (const auto& [key, name] : kProtocols)
    if (lower.find(key) != std::string::npos) return fmt::format("{} ({})", name, schema);
  return schema;
}

}  // namespace

bool begins_as_step(std::string_view text) {
  return trimmed_left(without_byte_order_mark(text)).starts_with("ISO-10303-21");
}

Result<StepHeader> read_step_header(std::string_view text, const std::string& name) {
  const std::string_view body = trimmed_left(text);
  if (body.empty()) return fail(refuse::empty_file, {{"file", name}}, name);
  if (!begins_as_step(body)) return fail(refuse::not_step, {{"file", name}}, name);
  constexpr size_t kTail = 4096;  // comments may follow the end mark
  const std::string_view tail = body.substr(body.size() - std::min(kTail, body.size()));
  if (tail.find("END-ISO-10303-21") == std::string_view::npos)
    return fail(refuse::file_ends_early, {{"file", name}, {"count", text.size()}}, name);
  const std::string_view header = body.substr(0, body.find("ENDSEC"));
  // The kernel fails on a file without any instance (#1 = …).
  if (body.find('#', header.size()) == std::string_view::npos)
    return fail(refuse::holds_nothing, {{"file", name}}, name);
  StepHeader result;
  if (const auto schema = strings_of(header, "FILE_SCHEMA"); !schema.empty())
    result.schema = application_protocol(schema.front());
  // FILE_NAME: name, time stamp, authors, organisations, preprocessor, originating system,
  // approval.
  if (const auto strings = strings_of(header, "FILE_NAME"); strings.size() >= 3) {
    result.cad_system = strings[strings.size() - 2];
    if (trimmed_left(result.cad_system).empty()) result.cad_system = strings[strings.size() - 3];
  }
  return result;
}

}  // namespace planish::brep
