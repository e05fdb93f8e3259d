#include "part_work.hpp"

#include <planish/job/outputs.hpp>
#include <planish/job/run.hpp>
#include <planish/job/unfold.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace planish::batch {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto kSketch = "sketch.svg";

std::string on_one_line(const std::string& json) { return Json::parse(json).dump(); }

/// The options that a maker has.
std::string taken_by(const job::Maker& maker, const std::string& options) {
  Json taken = Json::object();
  for (const auto& [name, value] : Json::parse(options).items())
    if (maker.takes(name)) taken[name] = value;
  return taken.dump();
}

/// A drawing of the pattern for a page of many.
std::string sketch_of(const job::Made& made) {
  return svg_text(made.piece(0).flat, {.labels = false, .names = false, .legend = false});
}

/// Makes the files and the report of what was made.
PartDone finished(job::Made& made, const job::Maker& maker, const FileTask& task,
                  const job::Request& request, const job::Catalogue& catalogue,
                  const std::string& folder) {
  PartDone part{.folder = folder};
  job::Report& report = made.report();
  report.input = task.name;
  const auto add = [&](std::string name, std::string bytes) {
    report.files.push_back(folder + "/" + name);
    part.files.push_back({std::move(name), std::move(bytes)});
  };
  for (const std::string& format : task.formats) {
    const job::Artifact* artifact = catalogue.artifact(maker, format);
    if (!artifact || artifact->role == job::Role::report || report.refusal) continue;
    auto files = job::write(*artifact, made, request, job::safe_name(report.body));
    if (!files && artifact->may_be_missing(files.error())) {
      job::note_missing(report, *artifact, files.error());
      continue;
    }
    if (!files) {
      report.refusal = files.error();
      break;
    }
    for (job::WrittenArtifact& file : *files)
      add(std::move(file.name), std::move(file.bytes));
  }
  if (report.refusal) {
    report.files.clear();
    part.files.clear();
  } else {
    part.files.push_back({kSketch, sketch_of(made)});
  }
  const std::string json = made.json();
  if (std::ranges::count(task.formats, "json")) part.files.push_back({"report.json", json});
  part.report = on_one_line(json);
  return part;
}

std::vector<PartDone> unfolded(const FileTask& task, const job::Maker& maker,
                               const job::Request& request, const job::Catalogue& catalogue,
                               const job::Parent& parent) {
  const auto begins = [&](int body) { parent.note({fmt::format("{}", body)}); };
  auto reports = job::unfold_all(request, parent.progress, {task.given_up, begins});
  if (!reports) return {failed_part(task, catalogue, reports.error())};
  std::vector<PartDone> parts;
  for (std::size_t i = 0; i < reports->size(); ++i) {
    begins(static_cast<int>(i));
    const std::string folder = reports->size() == 1
                                   ? task.name
                                   : fmt::format("{}/{}_{}", task.name, i + 1,
                                                 job::safe_name((*reports)[i].body));
    const auto made = job::made_of((*reports)[i]);
    parts.push_back(finished(*made, maker, task, request, catalogue, folder));
  }
  parent.note({});
  return parts;
}

}  // namespace

PartDone failed_part(const FileTask& task, const job::Catalogue& catalogue, const Error& error) {
  job::Request request;
  request.input = task.name;
  const job::Maker& maker = catalogue.makers.front();
  const auto made = maker.failed(request, error);
  made->report().input = task.name;
  const std::string json = made->json();
  PartDone part{.folder = task.name, .report = on_one_line(json)};
  if (std::ranges::count(task.formats, "json")) part.files.push_back({"report.json", json});
  return part;
}

std::vector<PartDone> work_on(const FileTask& task, const job::Catalogue& catalogue,
                              const job::Parent& parent) {
  const auto failed = [&](const Error& error) {
    return std::vector{failed_part(task, catalogue, error)};
  };
  auto input = job::read_input_file(task.file, "input file");
  if (!input) return failed(input.error());
  const auto maker = catalogue.maker_for(input->name, input->content);
  if (!maker) return failed(maker.error());
  const auto options = job::read_options(taken_by(**maker, task.options), **maker,
                                         job::OptionFiles::path_or_content, "");
  if (!options) return failed(options.error());
  job::Request request;
  request.input = task.file;
  if (const auto entered = options->enter(request); !entered) return failed(entered.error());
  if ((*maker)->takes("body") && request.body.empty())
    return unfolded(task, **maker, request, catalogue, parent);
  const auto work = (*maker)->open(*input, parent.progress);
  if (!work) return failed(work.error());
  const auto made = (*work)->make(request, parent.progress);
  if (!made) return failed(made.error());
  std::vector<PartDone> parts;
  parts.push_back(finished(**made, **maker, task, request, catalogue, task.name));
  return parts;
}

job::Texts texts_of(const FileTask& task) {
  Json json{{"file", task.file},
            {"name", task.name},
            {"options", task.options},
            {"formats", task.formats},
            {"given_up", Json::array()}};
  job::Texts texts{""};
  for (const auto& [body, error] : task.given_up) {
    const job::Texts words = job::texts_of(error);
    json["given_up"].push_back({body, words.size()});
    texts.insert(texts.end(), words.begin(), words.end());
  }
  // Names of files may be any bytes.
  texts[0] = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  texts.insert(texts.begin() + 1, {task.file, task.name});
  return texts;
}

std::optional<FileTask> task_in(const job::Texts& texts) {
  constexpr std::size_t kOwn = 3;
  if (texts.size() < kOwn) return std::nullopt;
  const Json json = Json::parse(texts[0], nullptr, false);
  if (json.is_discarded()) return std::nullopt;
  FileTask task{.file = texts[1],
                .name = texts[2],
                .options = json["options"],
                .formats = json["formats"].get<std::vector<std::string>>()};
  auto text = texts.begin() + kOwn;
  for (const Json& one : json["given_up"]) {
    const auto count = one[1].get<std::ptrdiff_t>();
    if (texts.end() - text < count) return std::nullopt;
    auto error = job::error_in({text, text + count});
    if (!error) return std::nullopt;
    task.given_up.emplace(one[0].get<int>(), std::move(*error));
    text += count;
  }
  return task;
}

job::Texts texts_of(const std::vector<PartDone>& parts) {
  job::Texts texts{"parts"};
  for (const PartDone& part : parts) {
    texts.insert(texts.end(), {part.folder, part.report, std::to_string(part.files.size())});
    for (const PartFile& file : part.files)
      texts.insert(texts.end(), {file.name, file.bytes});
  }
  return texts;
}

std::optional<std::vector<PartDone>> parts_in(const job::Texts& texts) {
  if (texts.empty() || texts[0] != "parts") return std::nullopt;
  std::vector<PartDone> parts;
  for (std::size_t at = 1; at < texts.size();) {
    if (texts.size() - at < 3) return std::nullopt;
    PartDone& part = parts.emplace_back(PartDone{texts[at], texts[at + 1], {}});
    const auto files = static_cast<std::size_t>(std::strtoull(texts[at + 2].c_str(), nullptr, 10));
    at += 3;
    if (files > (texts.size() - at) / 2) return std::nullopt;
    for (std::size_t f = 0; f < files; ++f, at += 2)
      part.files.push_back({texts[at], texts[at + 1]});
  }
  return parts;
}

}  // namespace planish::batch
