#include "journal.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace planish::batch {
namespace {

using Json = nlohmann::ordered_json;

tl::unexpected<Error> broken(ErrorCode code, const std::filesystem::path& file) {
  return fail(code,
              fmt::format("cannot {} {}: {}", code == ErrorCode::cannot_read ? "read" : "write",
                          file.string(), std::strerror(errno)),
              file.string());
}

}  // namespace

Result<Journal> Journal::open(const std::filesystem::path& file) {
  Journal journal;
  journal.file_ = file;
  std::error_code none;
  if (!std::filesystem::exists(file, none)) std::ofstream(file, std::ios::binary);
  journal.stream_.open(file, std::ios::in | std::ios::out | std::ios::binary);
  if (!journal.stream_) return broken(ErrorCode::cannot_write, file);
  for (std::string line; std::getline(journal.stream_, line);) {
    if (journal.stream_.eof()) break;  // cut off
    const Json json = Json::parse(line, nullptr, false);
    if (json.is_object() && json.contains("name") && json.contains("key"))
      journal.places_[json["name"].get<std::string>()] = {json["key"].get<std::string>(),
                                                          journal.end_, line.size()};
    journal.end_ += static_cast<std::streamoff>(line.size()) + 1;
  }
  journal.stream_.clear();
  if (const auto size = std::filesystem::file_size(file, none);
      !none && size > static_cast<std::uintmax_t>(journal.end_))
    std::filesystem::resize_file(file, static_cast<std::uintmax_t>(journal.end_), none);
  return journal;
}

bool Journal::has(const std::string& name, const std::string& key) const {
  const auto place = places_.find(name);
  return place != places_.end() && place->second.key == key;
}

Result<void> Journal::add(const std::string& name, const std::string& key,
                          const std::vector<PartDone>& parts) {
  // Reports are JSON already: they are put in as they are.
  std::string line = fmt::format("{{\"name\":{},\"key\":{},\"parts\":[", Json(name).dump(),
                                 Json(key).dump());
  for (std::size_t i = 0; i < parts.size(); ++i)
    line += fmt::format("{}{{\"folder\":{},\"report\":{}}}", i == 0 ? "" : ",",
                        Json(parts[i].folder).dump(), parts[i].report);
  line += "]}";
  stream_.seekp(end_);
  stream_ << line << '\n';
  stream_.flush();
  if (!stream_) return broken(ErrorCode::cannot_write, file_);
  places_[name] = {key, end_, line.size()};
  end_ += static_cast<std::streamoff>(line.size()) + 1;
  return {};
}

Result<std::vector<Journal::Part>> Journal::parts_of(const std::string& name) {
  const auto place = places_.find(name);
  if (place == places_.end()) return std::vector<Part>{};
  std::string line(place->second.length, '\0');
  stream_.seekg(place->second.at);
  stream_.read(line.data(), static_cast<std::streamsize>(line.size()));
  if (!stream_) return broken(ErrorCode::cannot_read, file_);
  const Json json = Json::parse(line);
  std::vector<Part> rows;
  for (const Json& part : json["parts"])
    rows.push_back({part["folder"].get<std::string>(), part["report"].dump()});
  return rows;
}

}  // namespace planish::batch
