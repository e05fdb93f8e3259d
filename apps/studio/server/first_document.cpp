#include "first_document.hpp"

#include "../refusals.hpp"
#include "../work/attachments.hpp"
#include "api.hpp"

#include <planish/base/packed_error.hpp>
#include <planish/job/artifact.hpp>
#include <planish/schema/text_file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>

namespace planish::studio {
namespace {

Error error_of(const Answer& answer) {
  const nlohmann::json json = nlohmann::json::parse(answer.body, nullptr, false);
  if (!json.is_object()) return planish::error_of(refuse::no_answer, {});
  const auto status = answer.status == 500 ? ExitStatus::internal : ExitStatus::unreadable;
  return {received_code(json.value("code", ""), status), json.value("message", ""),
          json.value("where", "")};
}

tl::unexpected<Error> too_large(const std::filesystem::path& file) {
  return fail(
      refuse::file_too_large,
      {{"file", file.string()}, {"most", static_cast<double>(kLargestBody >> 20), unit::mebibytes}},
      file.string());
}

/// A name that the page can show, whatever the file is called.
std::string shown_name(const std::filesystem::path& file) {
  std::string name = file == "-" ? "stdin" : file.filename().string();
  const auto unfit = [](unsigned char c) { return std::iscntrl(c) || c == '\\'; };
  std::ranges::replace_if(name, unfit, '_');
  if (!name.empty() && name.front() == '.') name.front() = '_';
  constexpr std::size_t kLongest = 100;
  std::size_t from = name.size() > kLongest ? name.size() - kLongest : 0;
  const auto within = [](unsigned char c) { return (c & 0xC0U) == 0x80U; };  // inside a UTF-8
                                                                             // character
  while (from > 0 && from < name.size() && within(static_cast<unsigned char>(name[from])))
    ++from;
  name.erase(0, from);
  const auto foreign = [](unsigned char c) { return c >= 0x80U; };
  if (!is_plain_name(name)) std::ranges::replace_if(name, foreign, '_');
  return name;
}

/// Devices, which may have no end, and files too large for a worker are not read at all.
Result<void> check_size(const std::filesystem::path& file) {
  std::error_code unknown;
  const auto type = std::filesystem::status(file, unknown).type();
  if (type == std::filesystem::file_type::character || type == std::filesystem::file_type::block)
    return fail(refuse::file_is_device, {{"file", file.string()}}, file.string());
  const bool regular = type == std::filesystem::file_type::regular;
  if (!regular || std::filesystem::file_size(file, unknown) <= kLargestBody) return {};
  return too_large(file);
}

std::vector<job::NamedFile> files_named_in(const std::string& name, const std::string& content) {
  const auto maker = job::built_in().maker_for(name, content);
  if (!maker || !(*maker)->named_files) return {};
  return (*maker)->named_files(content);
}

}  // namespace

Result<void> open_first(DocumentStore& store, const std::filesystem::path& file) {
  if (auto bearable = check_size(file); !bearable) return bearable;
  const auto bytes = schema::read_text(file, "file");
  if (!bytes) return pass_on(bytes);
  if (bytes->size() > kLargestBody) return too_large(file);
  const Answer taken = store.take(shown_name(file), *bytes, Origin::command_line);
  if (taken.status != 200) return tl::unexpected(error_of(taken));
  const std::string id = nlohmann::json::parse(taken.body)["id"];
  const Answer opened = store.open(id);
  if (opened.status != 200) return tl::unexpected(error_of(opened));
  for (const auto& [name, pointer] : files_named_in(file.string(), *bytes)) {
    // A file elsewhere is reported as missing when it is needed.
    const auto content = is_plain_name(name) ? schema::read_text(file.parent_path() / name, "file")
                                             : fail(refuse::not_read, {{"file", name}});
    if (content) store.attach(id, name, *content);
  }
  return {};
}

}  // namespace planish::studio
