#include "attachments.hpp"

#include "json_text.hpp"

#include <planish/job/printable.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::studio {
namespace {

/// A file that the spec names, and where.
struct Named {
  std::string file;
  std::size_t scan;
  std::string where(const std::string& spec_name) const {
    return fmt::format("{}/scan/{}/points", spec_name, scan);
  }
};

bool names_a_file(const Json& scan) {
  return scan.is_object() && scan.contains("points") && scan["points"].is_string();
}

std::vector<Named> named_files(const Json& spec) {
  std::vector<Named> files;
  if (!spec.is_object() || !spec.contains("scan") || !spec["scan"].is_array()) return files;
  const Json& scans = spec["scan"];
  for (std::size_t i = 0; i < scans.size(); ++i)
    if (names_a_file(scans[i])) files.push_back({scans[i]["points"].get<std::string>(), i});
  return files;
}

Result<void> check_name(const Named& named, const std::string& spec_name) {
  if (is_plain_name(named.file)) return {};
  return fail(ErrorCode::invalid_input,
              fmt::format("slit file: /scan/{}/points must name a file that was added to the "
                          "document, without folders",
                          named.scan),
              named.where(spec_name));
}

}  // namespace

bool is_plain_name(const std::string& name) {
  constexpr std::size_t kLongest = 128;
  const auto unfit = [](unsigned char c) { return c < 0x20 || c == 0x7F || c == '/' || c == '\\'; };
  return !name.empty() && name.size() <= kLongest && name.front() != '.' &&
         std::none_of(name.begin(), name.end(), unfit) && job::printable(name) == name;
}

Result<void> check_attachments(const std::string& spec, const std::string& name,
                               const std::filesystem::path& attachments) {
  const auto json = parse_json(spec, "slit file");
  if (!json) return tl::unexpected(json.error());
  for (const Named& named : named_files(*json)) {
    if (auto plain = check_name(named, name); !plain) return plain;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(attachments / named.file, ignored))
      return fail(ErrorCode::cannot_read,
                  fmt::format("the scan {} was not added to the document", named.file),
                  named.where(name));
  }
  return {};
}

Result<std::string> without_attachments(const std::string& spec, const std::string& name) {
  auto json = parse_json(spec, "slit file");
  if (!json) return tl::unexpected(json.error());
  for (const Named& named : named_files(*json)) {
    if (auto plain = check_name(named, name); !plain) return tl::unexpected(plain.error());
    (*json)["scan"][named.scan]["points"] = Json::array();
  }
  return json_text(*json);
}

}  // namespace planish::studio
