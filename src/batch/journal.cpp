#include "journal.hpp"

#include "refusals.hpp"

#include <planish/io/flat_writers.hpp>
#include <planish/schema/text_file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstring>
#include <system_error>

// A line for each input: name and key, a tab, the records of its parts. Opening looks at names and
// keys alone and keeps where each line lies, so a journal of any size takes little memory; records
// are parsed when they are asked for. A line counts whole or not at all: what has no line break was
// cut off, and is dropped. A later line replaces an earlier one of the same name
// (decisions/0015-a-batch-is-a-journal.md).

namespace planish::batch {
namespace {

using Json = nlohmann::ordered_json;

// Between the head of a line, {"name": ..., "key": ...}, and its parts.
constexpr char kBehindHead = '\t';

tl::unexpected<Error> unread(const std::filesystem::path& file) {
  return fail(schema::cannot_read("journal", file, std::strerror(errno)));
}

std::string json_text(const std::string& text) { return Json(text).dump(); }

}  // namespace

void Journal::look_through() {
  for (std::string line; std::getline(stream_, line);) {
    if (stream_.eof()) break;  // cut off
    const Json head = Json::parse(line.substr(0, line.find(kBehindHead)), nullptr, false);
    if (head.is_object() && head.contains("name") && head.contains("key"))
      places_[head["name"].get<std::string>()] = {head["key"].get<std::string>(), end_,
                                                  line.size()};
    end_ += static_cast<std::streamoff>(line.size()) + 1;
  }
  stream_.clear();
}

Result<Journal> Journal::read(const std::filesystem::path& file) {
  Journal journal;
  journal.file_ = file;
  journal.stream_.open(file, std::ios::in | std::ios::binary);
  if (!journal.stream_) return unread(file);
  journal.look_through();
  return journal;
}

Result<Journal> Journal::open(const std::filesystem::path& file) {
  Journal journal;
  journal.file_ = file;
  std::error_code none;
  if (!std::filesystem::exists(file, none)) std::ofstream(file, std::ios::binary);
  journal.stream_.open(file, std::ios::in | std::ios::out | std::ios::binary);
  if (!journal.stream_) return cannot_write(file, std::strerror(errno));
  journal.look_through();
  if (const auto size = std::filesystem::file_size(file, none);
      !none && size > static_cast<std::uintmax_t>(journal.end_))
    std::filesystem::resize_file(file, static_cast<std::uintmax_t>(journal.end_), none);
  return journal;
}

std::string Journal::key_of(const std::string& name) const {
  const auto place = places_.find(name);
  return place == places_.end() ? std::string() : place->second.key;
}

std::vector<std::string> Journal::names() const {
  return mapped(places_, [&](const auto& row) { return row.first; });
}

tl::unexpected<Error> Journal::unwritten() {
  const auto error = cannot_write(file_, std::strerror(errno));
  stream_.clear();
  return error;
}

Result<void> Journal::flush() {
  stream_.flush();
  if (!stream_) return unwritten();
  return {};
}

Result<void> Journal::append(const std::string& name, const std::string& key,
                             std::string_view line) {
  stream_.seekp(end_);
  stream_ << line << '\n';
  if (!stream_) return unwritten();
  places_[name] = {key, end_, line.size()};
  end_ += static_cast<std::streamoff>(line.size()) + 1;
  return {};
}

Result<void> Journal::add(const std::string& name, const std::string& key,
                          const std::vector<PartDone>& parts) {
  std::string line = fmt::format(R"({{"name":{},"key":{}}}{}[)", json_text(name), json_text(key),
                                 kBehindHead);
  for (std::size_t i = 0; i < parts.size(); ++i)
    line += (i == 0 ? "" : ",") + record_text(parts[i].record);
  if (auto added = append(name, key, line + "]"); !added) return added;
  return flush();
}

Result<void> Journal::add_from(Journal& other, const std::string& name) {
  const Place& place = other.places_.at(name);
  const auto line = other.line_at(place);
  if (!line) return pass_on(line);
  return append(name, place.key, *line);
}

Result<std::string> Journal::line_at(const Place& place) {
  std::string line(place.length, '\0');
  stream_.seekg(place.at);
  stream_.read(line.data(), static_cast<std::streamsize>(line.size()));
  if (stream_) return line;
  const auto error = unread(file_);
  stream_.clear();
  return error;
}

Result<std::vector<PartRecord>> Journal::parts_of(const std::string& name) {
  const auto place = places_.find(name);
  if (place == places_.end()) return std::vector<PartRecord>{};
  const auto line = line_at(place->second);
  if (!line) return pass_on(line);
  auto records = part_records(std::string_view(*line).substr(line->find(kBehindHead) + 1));
  if (!records)
    return fail(refuse::journal_damaged, {{"file", file_.string()}, {"name", name}},
                file_.string());
  return std::move(*records);
}

}  // namespace planish::batch
