#include "served_work.hpp"

#include "base64.hpp"
#include "refusals.hpp"
#include "rpc.hpp"

#include <planish/base/packed_error.hpp>
#include <planish/job/output_paths.hpp>
#include <planish/job/run.hpp>
#include <planish/schema/fail_at.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>

// A request in a worker's process. What can be said before the work is said before it: outputs that
// would replace an input, folders that are missing, standard input, which carries the requests.
// Artifacts to be written are asked for like others, and an error about one is moved to its place
// in `write`, in the sentence too. Bytes that are no text go as base64.

namespace planish::serve {
namespace {

namespace fs = std::filesystem;

/// The bytes as text where they are text.
void put_bytes(Json& row, const std::string& bytes) {
  const Json text(bytes);
  bool is_text = bytes.find('\0') == std::string::npos;
  try {
    if (is_text) (void)text.dump();
  } catch (const Json::type_error&) {  // it is not UTF-8
    is_text = false;
  }
  row[is_text ? "text" : "base64"] = is_text ? text : Json(base64(bytes));
}

/// The file of an option or of the input, where it is given by its path.
std::optional<std::string> path_in(const Json& value) {
  return value.is_string() ? std::optional(value.get<std::string>()) : std::nullopt;
}

/// Files that are read, and so must not be replaced; all that are named, whether they are there or
/// not.
std::vector<fs::path> inputs_of(const Json& request, const job::Catalogue& catalogue) {
  std::vector<fs::path> inputs;
  const Json options = request.value("options", Json::object());
  for (const job::Option& option : job::options())
    if (option.kind == job::OptionKind::file && options.is_object() &&
        options.contains(option.name))
      if (const auto path = path_in(options[std::string(option.name)])) inputs.emplace_back(*path);
  const auto path = path_in(request.value("input", Json()));
  if (!path) return inputs;
  inputs.emplace_back(*path);
  const job::Maker* maker = catalogue.maker(request.value("maker", ""));
  if (!maker || !maker->named_files) return inputs;
  // If a file cannot be read, the maker will report it.
  if (const auto input = job::read_input_file(*path, maker->input_kind()))
    for (const job::NamedFile& named : maker->named_files(input->content))
      inputs.push_back(*input->folder / named.file);
  return inputs;
}

Error at(const std::string& artifact, Error error) {
  error.where = "/write/" + artifact;
  error.places = {place::pointer(error.where)};
  return error;
}

/// Said before the work rather than after it.
Result<void> check_writes(const WorkTask& task, const Json& request,
                          const job::Catalogue& catalogue) {
  if (task.writes.empty()) return {};
  const auto inputs = inputs_of(request, catalogue);
  std::vector<fs::path> outputs;
  for (const auto& [artifact, path] : task.writes) {
    outputs.emplace_back(path);
    if (auto spared = job::spare_inputs(path, inputs); !spared)
      return tl::unexpected(at(artifact, spared.error()));
    if (auto exists = job::folder_exists(path); !exists)
      return tl::unexpected(at(artifact, exists.error()));
    if (auto writable = check_writable(path); !writable)
      return tl::unexpected(at(artifact, writable.error()));
    if (auto different = job::all_different(outputs); !different)
      return tl::unexpected(at(artifact, different.error()));
  }
  return {};
}

/// Standard input carries the requests.
Result<void> check_no_standard_input(const Json& request) {
  const auto fails = [](const std::string& pointer) {
    return schema::fail_at(refuse::standard_input_taken, pointer);
  };
  if (request.value("input", Json()) == "-") return fails("/input");
  const Json options = request.value("options", Json::object());
  for (const job::Option& option : job::options())
    if (option.kind == job::OptionKind::file && options.is_object() &&
        options.value(std::string(option.name), Json()) == "-")
      return fails("/options/" + std::string(option.name));
  return {};
}

/// The name under which results have an artifact that a request may call by its suffix.
std::string name_in_results(const Json& request, const std::string& artifact,
                            const job::Catalogue& catalogue) {
  const job::Maker* maker = catalogue.maker(request.value("maker", ""));
  const job::Artifact* found = maker ? catalogue.artifact(*maker, artifact) : nullptr;
  return found ? std::string(found->name) : artifact;
}

/// Asks for the artifacts that are to be written; returns how many were asked for before.
std::size_t ask_for_writes(Json& request, const WorkTask& task) {
  if (!request.contains("artifacts")) request["artifacts"] = Json::array();
  Json& artifacts = request["artifacts"];
  if (!artifacts.is_array()) return 0;  // the request is wrong, and is told so
  const std::size_t before = artifacts.size();
  for (const auto& [artifact, path] : task.writes)
    if (std::ranges::find(artifacts, Json(artifact)) == artifacts.end())
      artifacts.push_back(artifact);
  return before;
}

/// An artifact that is asked for only to be written is wrong where it is to be written.
Error of_writes(Error error, const Json& request, std::size_t asked) {
  constexpr std::string_view kList = "/artifacts/";
  if (!error.where.starts_with(kList)) return error;
  const auto number = job::parse_number(error.where.substr(kList.size()));
  if (!number || *number < static_cast<double>(asked)) return error;
  const Json& artifacts = request["artifacts"];
  const auto artifact = artifacts[static_cast<Json::size_type>(*number)].get<std::string>();
  rename_place(error, place::pointer(error.where), place::pointer("/write/" + artifact));
  return at(artifact, std::move(error));
}

struct Wanted {
  fs::path path;
  int files = 0, next = 0;
};

WorkDone done_of(job::RunResult made, std::map<std::string, Wanted> wanted) {
  WorkDone done;
  done.refused = made.status == job::Status::refused;
  done.summary = std::move(made.summary);
  Json artifacts = Json::array();
  for (job::ArtifactFile& file : made.artifacts)
    if (wanted.contains(file.artifact)) ++wanted[file.artifact].files;
  for (job::ArtifactFile& file : made.artifacts) {
    Json row{{"artifact", file.artifact}, {"name", file.name}, {"media_type", file.media_type}};
    if (const auto found = wanted.find(file.artifact); found != wanted.end()) {
      Wanted& to = found->second;
      const fs::path path = job::name_of_piece(to.path, to.next++, to.files);
      row["path"] = path.string();
      row["size"] = file.bytes.size();
      done.summary += fmt::format("wrote {}\n", path.string());
      done.files.push_back({path, std::move(file.bytes)});
    } else {
      put_bytes(row, file.bytes);
    }
    artifacts.push_back(std::move(row));
  }
  Json report = Json::parse(made.report, nullptr, false);
  done.result = text_of({{"status", job::status_name(made.status)},
                         {"report", std::move(report)},
                         {"artifacts", std::move(artifacts)}});
  return done;
}

}  // namespace

Result<WorkDone> work_on(const WorkTask& task, const job::Catalogue& catalogue,
                         const process::Parent& parent) {
  Json request = Json::parse(task.request, nullptr, false);
  const auto input = path_in(request.value("input", Json()));
  if (input) parent.note({*input});
  if (auto fine = check_no_standard_input(request); !fine) return pass_on(fine);
  if (auto fine = check_writes(task, request, catalogue); !fine) return pass_on(fine);
  const bool writes = !task.writes.empty();
  const std::size_t asked = writes ? ask_for_writes(request, task) : 0;
  auto made = shown(job::run(writes ? text_of(request) : task.request, parent.progress, catalogue));
  if (!made) return tl::unexpected(writes ? of_writes(made.error(), request, asked) : made.error());
  std::map<std::string, Wanted> wanted;
  for (const auto& [artifact, path] : task.writes)
    wanted[name_in_results(request, artifact, catalogue)] = {path};
  return done_of(std::move(*made), std::move(wanted));
}

process::Texts texts_of(const WorkTask& task) {
  process::Texts texts{task.request};
  for (const auto& [artifact, path] : task.writes)
    texts.insert(texts.end(), {artifact, path});
  return texts;
}

std::optional<WorkTask> task_in(const process::Texts& texts) {
  if (texts.size() % 2 != 1) return std::nullopt;
  WorkTask task{.request = texts[0], .writes = {}};
  for (std::size_t i = 1; i < texts.size(); i += 2)
    task.writes.emplace_back(texts[i], texts[i + 1]);
  return task;
}

process::Texts texts_of(const Result<WorkDone>& done) {
  if (!done) return packed(done.error());
  process::Texts texts{"done", done->result, done->summary, done->refused ? "refused" : ""};
  for (const OutputFile& file : done->files)
    texts.insert(texts.end(), {file.path.string(), file.content});
  return texts;
}

std::optional<Result<WorkDone>> done_in(const process::Texts& texts) {
  constexpr std::size_t kOwn = 4;
  if (auto error = unpacked(texts)) return tl::unexpected(std::move(*error));
  if (texts.size() < kOwn || texts.size() % 2 != 0 || texts[0] != "done") return std::nullopt;
  WorkDone done{.result = texts[1], .summary = texts[2], .refused = !texts[3].empty(), .files = {}};
  for (std::size_t i = kOwn; i < texts.size(); i += 2)
    done.files.push_back({texts[i], texts[i + 1]});
  return done;
}

}  // namespace planish::serve
