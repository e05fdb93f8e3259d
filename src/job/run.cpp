#include "json_depth.hpp"
#include "json_reading.hpp"
#include "request_schema.hpp"

#include <planish/base/text.hpp>
#include <planish/job/run.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace planish::job {
namespace {

constexpr auto kOptions = "/options";

/// A parsed request; nothing is made yet.
struct Asked : MadeRequest {
  std::optional<InputFile> content;  ///< empty: `request.input` names a file
};

Result<OptionValues> checked_options(const Json& options, const Maker& maker, OptionFiles files,
                                     const std::string& pointer) {
  if (const auto wrong = first_mistake(options_schema(files), options)) {
    const std::string where = pointer + wrong->pointer;
    return fail(ErrorCode::invalid_input,
                fmt::format("request: {} {}", shortened(where, 200), wrong->sentence), where);
  }
  for (const auto& [name, value] : options.items())
    if (!maker.takes(name) && !value.is_null())
      return fail(ErrorCode::bad_option,
                  fmt::format("`{}` is not an option of {}", shortened(name), maker.name),
                  pointer + "/" + name);
  return values_of(options);
}

/// Files that an input names are left unread where nobody says where they are.
Result<void> check_folder(const Maker& maker, const InputFile& file) {
  if (file.folder || !maker.named_files) return {};
  const auto named = maker.named_files(file.content);
  if (named.empty()) return {};
  return fail(ErrorCode::invalid_input,
              fmt::format("request: /input/folder is missing: the {} names the file {} at {}; say "
                          "in which folder it is",
                          maker.input_kind(), named.front().file, named.front().pointer),
              "/input/folder");
}

Result<void> read_input(Asked& asked, const Json& input) {
  if (input.is_string()) {
    asked.request.input = input.get<std::string>();
    return {};
  }
  const Json& content = input["content"];
  InputFile file;
  file.name = input.value("name", std::string("input"));
  file.content = content.is_string() ? content.get<std::string>() : content.dump();
  if (input.contains("folder")) file.folder = input["folder"].get<std::string>();
  if (auto found = check_folder(*asked.maker, file); !found) return found;
  asked.request.input = file.name;
  asked.content = std::move(file);
  return {};
}

Result<void> read_artifacts(Asked& asked, const Json& names, const Catalogue& catalogue) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Json& name = names[i];
    const Artifact* artifact = catalogue.artifact(*asked.maker, name.get<std::string>());
    if (!artifact) {
      std::vector<std::string_view> known;
      for (const Artifact* one : catalogue.written_by(*asked.maker))
        known.push_back(one->name);
      return fail(ErrorCode::bad_option,
                  fmt::format("{} cannot write \"{}\"; it writes {}", asked.maker->name,
                              shortened(name.get<std::string>()), fmt::join(known, ", ")),
                  fmt::format("/artifacts/{}", i));
    }
    asked.artifacts.push_back(artifact);
  }
  return {};
}

Result<Asked> read_request(const std::string& text, const Catalogue& catalogue) {
  const Schema schema = request_schema(catalogue);
  JsonReading reading(text, "request", {}, schema);
  if (reading.error()) return tl::unexpected(*reading.error());
  const Json& json = reading.document();
  Asked asked;
  asked.maker = catalogue.maker(json["maker"].get<std::string>());
  if (auto read = read_input(asked, json["input"]); !read) return tl::unexpected(read.error());
  if (json.contains("options")) {
    const auto values = checked_options(json["options"], *asked.maker, OptionFiles::path_or_content,
                                        kOptions);
    if (!values) return tl::unexpected(values.error());
    if (auto entered = values->enter(asked.request); !entered)
      return tl::unexpected(at_pointer(entered.error(), kOptions));
  }
  if (json.value("effort", "full") == "draft") asked.request.effort = Effort::draft;
  if (json.value("plan", false)) asked.request.bending.ask = Bending::Ask::plan;
  if (json.contains("artifacts"))
    if (auto known = read_artifacts(asked, json["artifacts"], catalogue); !known)
      return tl::unexpected(known.error());
  return asked;
}

Result<std::unique_ptr<Made>> made_of(const Asked& asked, const Progress& progress) {
  const auto work = asked.content ? asked.maker->open(*asked.content, progress)
                                  : open_input(*asked.maker, asked.request, progress);
  if (!work) return tl::unexpected(work.error());
  auto made = (*work)->make(asked.request, progress);
  if (!made) return made;
  if (auto shown = piece_of(**made, asked.request.piece); !shown)
    return tl::unexpected(shown.error());
  return made;
}

Result<MadeRequest> done(Asked asked, const Progress& progress) {
  auto made = made_of(asked, progress);
  if (!made) return tl::unexpected(at_pointer(made.error(), kOptions));
  asked.made = std::move(*made);
  asked.made->report().of_bending = asked.request.bending.ask == Bending::Ask::plan;
  return MadeRequest(std::move(asked));
}

Result<RunResult> with_artifacts(Result<MadeRequest> made) {
  if (!made) return tl::unexpected(made.error());
  return result_of(*made);
}
Texts texts_of(const RunResult& result) {
  Texts texts{"result", std::to_string(static_cast<int>(result.status)), result.report};
  for (const ArtifactFile& file : result.artifacts)
    texts.insert(texts.end(), {file.artifact, file.name, file.media_type, file.bytes});
  return texts;
}

std::optional<RunResult> result_in(const Texts& texts) {
  constexpr std::size_t kOfResult = 3, kOfFile = 4;
  if (texts.size() < kOfResult || texts[0] != "result") return std::nullopt;
  if ((texts.size() - kOfResult) % kOfFile != 0) return std::nullopt;
  RunResult result;
  for (const Status status : {Status::ok, Status::warning, Status::refused})
    if (texts[1] == std::to_string(static_cast<int>(status))) result.status = status;
  result.report = texts[2];
  for (std::size_t i = kOfResult; i < texts.size(); i += kOfFile)
    result.artifacts.push_back({texts[i], texts[i + 1], texts[i + 2], texts[i + 3]});
  return result;
}

}  // namespace

Result<OptionValues> read_options(const std::string& json, const Maker& maker, OptionFiles files,
                                  const std::string& pointer) {
  if (const auto byte = too_deep_at(json))
    return fail(ErrorCode::invalid_input, "the options " + too_deep_sentence(json, *byte), pointer);
  const Json options = Json::parse(json, nullptr, false);
  if (options.is_discarded())
    return fail(ErrorCode::invalid_input, "the options are not JSON", pointer);
  return checked_options(options, maker, files, pointer);
}

Result<MadeRequest> make(const std::string& request, const Progress& progress,
                         const Catalogue& catalogue, std::optional<std::string> bytes) {
  auto asked = read_request(request, catalogue);
  if (!asked) return tl::unexpected(asked.error());
  if (bytes && asked->content) asked->content->content = std::move(*bytes);
  return done(std::move(*asked), progress);
}

Result<RunResult> result_of(MadeRequest& request) {
  RunResult result;
  Report& report = request.made->report();
  const std::string stem = report.body;
  for (const Artifact* artifact : request.artifacts) {
    if (report.refusal && artifact->role != Role::report) continue;
    auto files = write(*artifact, *request.made, request.request, stem);
    if (!files && request.artifacts.size() > 1 && artifact->may_be_missing(files.error())) {
      note_missing(report, *artifact, files.error());
      continue;
    }
    if (!files) return tl::unexpected(files.error());
    for (WrittenArtifact& file : *files)
      result.artifacts.push_back({std::string(artifact->name), std::move(file.name),
                                  std::string(artifact->media_type), std::move(file.bytes)});
  }
  result.status = report.status();
  result.report = request.made->json();
  return result;
}

Result<RunResult> run(const std::string& request, const Progress& progress,
                      const Catalogue& catalogue) {
  return with_artifacts(make(request, progress, catalogue));
}

Result<RunResult> run_apart(const std::string& request, const Progress& progress,
                            const Limits& limits, const Catalogue& catalogue) {
  const auto answering = [&](const Texts&, const Parent& parent) {
    auto asked = read_request(request, catalogue);
    if (!asked) return texts_of(asked.error());
    parent.note({asked->request.input.string()});
    const auto result = with_artifacts(done(std::move(*asked), parent.progress));
    return result ? texts_of(*result) : texts_of(result.error());
  };
  const auto child = ChildProcess::copy(answering, limits.memory);
  if (!child) return tl::unexpected(child.error());
  std::string input = "the request";
  const auto name = [&](const Texts& note) { input = note.empty() ? input : note.front(); };
  const auto answer = (*child)->ask({}, limits.time, {progress, name});
  if (!answer) return tl::unexpected(error_of(answer.error(), input, limits));
  if (auto error = error_in(*answer)) return tl::unexpected(std::move(*error));
  if (auto result = result_in(*answer)) return std::move(*result);
  return tl::unexpected(error_of({{}, kDamagedAnswer}, input, limits));
}

}  // namespace planish::job
