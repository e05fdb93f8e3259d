#include "attachments.hpp"

#include "../refusals.hpp"

#include <planish/schema/printable.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace planish::studio {
namespace {

std::vector<job::NamedFile> named_files(const job::Maker& maker, const std::string& spec) {
  return maker.named_files ? maker.named_files(spec) : std::vector<job::NamedFile>{};
}

}  // namespace

bool is_plain_name(const std::string& name) {
  constexpr std::size_t kLongest = 240;
  const auto unfit = [](unsigned char c) { return c < 0x20 || c == 0x7F || c == '/' || c == '\\'; };
  return !name.empty() && name.size() <= kLongest && name.front() != '.' &&
         std::ranges::none_of(name, unfit) && schema::printable(name) == name;
}

Result<void> check_names(const job::Maker& maker, const std::string& spec,
                         const std::string& name) {
  for (const job::NamedFile& named : named_files(maker, spec))
    if (!is_plain_name(named.file))
      return fail(refuse::no_plain_name,
                  {{"kind", maker.input_kind()}, {"field", place::pointer(named.pointer)}},
                  name + named.pointer);
  return {};
}

Result<void> check_attachments(const job::Maker& maker, const std::string& spec,
                               const std::string& name, const std::filesystem::path& attachments) {
  if (auto plain = check_names(maker, spec, name); !plain) return plain;
  for (const job::NamedFile& named : named_files(maker, spec)) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(attachments / named.file, ignored))
      return fail(refuse::file_not_added,
                  {{"file", named.file}, {"field", place::pointer(named.pointer)}},
                  name + named.pointer);
  }
  return {};
}

}  // namespace planish::studio
