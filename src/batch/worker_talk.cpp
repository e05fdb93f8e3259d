#include "worker_talk.hpp"

#include <planish/base/packed_error.hpp>

#include <nlohmann/json.hpp>

#include <cstdlib>

// Tasks and parts as the texts of a message between a batch and its workers. A number stands before
// texts of which there may be any number. Reading takes nothing for granted: what a worker sends
// after something went wrong in it is a damaged answer, never a damaged batch.

namespace planish::batch {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto kBody = "body", kDone = "done", kPart = "part";

/// A number of texts that follow, and these.
class Reading {
 public:
  explicit Reading(const process::Texts& texts) : at_(texts.begin()), end_(texts.end()) {}

  bool has(std::ptrdiff_t count) const { return end_ - at_ >= count; }
  bool at_end() const { return at_ == end_; }
  const std::string& next() { return *at_++; }
  /// How many follow; more than there are if the text is no such number.
  std::ptrdiff_t count() { return std::strtol(next().c_str(), nullptr, 10); }
  process::Texts next(std::ptrdiff_t count) {
    const auto begin = at_;
    at_ += count;
    return {begin, at_};
  }

 private:
  process::Texts::const_iterator at_, end_;
};

}  // namespace

process::Texts texts_of(const FileTask& task) {
  process::Texts texts{task.file,
                       task.name,
                       task.options,
                       Json(task.formats).dump(),
                       std::to_string(task.share.number),
                       std::to_string(task.share.of)};
  for (const auto& [body, error] : task.given_up) {
    const process::Texts words = packed(error);
    texts.insert(texts.end(), {std::to_string(body), std::to_string(words.size())});
    texts.insert(texts.end(), words.begin(), words.end());
  }
  return texts;
}

std::optional<FileTask> task_in(const process::Texts& texts) {
  constexpr std::ptrdiff_t kOwn = 6;
  Reading reading(texts);
  if (!reading.has(kOwn)) return std::nullopt;
  FileTask task{
      .file = reading.next(), .name = reading.next(), .options = reading.next(), .formats = {}};
  const Json formats = Json::parse(reading.next(), nullptr, false);
  if (!formats.is_array()) return std::nullopt;
  task.formats = formats.get<std::vector<std::string>>();
  task.share.number = static_cast<int>(reading.count());
  task.share.of = static_cast<int>(reading.count());
  if (task.share.of < 1) return std::nullopt;
  while (!reading.at_end()) {
    if (!reading.has(2)) return std::nullopt;
    const auto body = static_cast<int>(reading.count());
    const auto count = reading.count();
    if (count < 0 || !reading.has(count)) return std::nullopt;
    auto error = unpacked(reading.next(count));
    if (!error) return std::nullopt;
    task.given_up.emplace(body, std::move(*error));
  }
  return task;
}

process::Texts texts_of(const PartDone& part) {
  process::Texts texts{kPart, part.record.folder, part.record.report, std::to_string(part.body),
                       std::to_string(part.record.shapes.size())};
  texts.insert(texts.end(), part.record.shapes.begin(), part.record.shapes.end());
  for (const PartFile& file : part.files)
    texts.insert(texts.end(), {file.name, file.bytes});
  return texts;
}

std::optional<PartDone> part_in(const process::Texts& texts) {
  constexpr std::ptrdiff_t kOwn = 5;
  Reading reading(texts);
  if (!reading.has(kOwn) || reading.next() != kPart) return std::nullopt;
  const std::string &folder = reading.next(), &report = reading.next();
  const auto body = static_cast<int>(reading.count());
  const auto count = reading.count();
  if (count < 0 || !reading.has(count) || !Json::accept(report)) return std::nullopt;
  std::vector<std::string> shapes = reading.next(count);
  std::vector<PartFile> files;
  while (!reading.at_end()) {
    if (!reading.has(2)) return std::nullopt;
    PartFile& file = files.emplace_back();
    file.name = reading.next();
    file.bytes = reading.next();
  }
  return part_done(folder, report, std::move(shapes), std::move(files), body);
}

process::Texts texts_of(const FileDone&) { return {kDone}; }

std::optional<FileDone> file_done_in(const process::Texts& texts) {
  if (texts != process::Texts{kDone}) return std::nullopt;
  return FileDone();
}

process::Texts beginning(int body) { return {kBody, std::to_string(body)}; }

std::optional<int> body_in(const process::Texts& texts) {
  if (texts.size() != 2 || texts[0] != kBody) return std::nullopt;
  return std::atoi(texts[1].c_str());
}

}  // namespace planish::batch
