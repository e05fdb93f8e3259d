#include "asked.hpp"

#include "refusals.hpp"
#include "request_schema.hpp"

#include <planish/base/text.hpp>
#include <planish/schema/fail_at.hpp>
#include <planish/schema/json_depth.hpp>
#include <planish/schema/json_reading.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace planish::job {
using namespace schema;
namespace {

constexpr auto kOptions = "/options";

Result<OptionValues> checked_options(const Json& options, const Maker& maker, OptionFiles files,
                                     const std::string& pointer) {
  if (const auto wrong = first_mistake(options_schema(files, maker), options)) {
    const std::string where = pointer + wrong->pointer;
    return fail_at(*wrong->refusal, where, wrong->facts);
  }
  for (const auto& [name, value] : options.items())
    if (!maker.takes(name) && !value.is_null())
      return fail_at(refuse::not_an_option, pointer + "/" + name,
                     {{"option", shortened(name)}, {"task", maker.name}});
  OptionValues values = values_of(options, maker);
  if (files == OptionFiles::content) values.read_no_files();
  return values;
}

/// Files that an input names are left unread where nobody says where they are.
Result<void> check_folder(const Maker& maker, const InputFile& file) {
  if (file.folder || !maker.named_files) return {};
  const auto named = maker.named_files(file.content);
  if (named.empty()) return {};
  return fail_at(refuse::folder_unsaid, "/input/folder",
                 {{"kind", maker.input_kind()},
                  {"file", named.front().file},
                  {"named", place::pointer("/input/content" + named.front().pointer)}});
}

void read_input_key(Asked& asked, const Json& input) {
  if (input.is_string()) {
    asked.request.input = input.get<std::string>();
    return;
  }
  const Json& content = input["content"];
  InputFile file;
  file.name = input.value("name", std::string("input"));
  file.content = content.is_string() ? content.get<std::string>() : content.dump();
  if (input.contains("folder")) file.folder = input["folder"].get<std::string>();
  asked.request.input = file.name;
  asked.content = std::move(file);
}

/// Which maker reads the input, whose format says so where the request does not.
Result<void> choose_maker(Asked& asked, const std::string& name, const Catalogue& catalogue) {
  asked.task = catalogue.task(name);
  if (asked.task->reader == Reader::named) asked.maker = catalogue.maker(name);
  if (asked.task->reader == Reader::by_format) {
    if (!asked.content) {
      auto file = read_input_file(asked.request.input, "input file");
      if (!file) return pass_on(file);
      asked.content = std::move(*file);
    }
    const auto maker = catalogue.maker_for(asked.content->name, asked.content->content);
    if (!maker) return pass_on(maker);
    asked.maker = *maker;
  }
  if (asked.maker && asked.content) return check_folder(*asked.maker, *asked.content);
  return {};
}

Result<void> read_options(Asked& asked, const Json& options) {
  const auto values = checked_options(options, asked.task->taking(asked.maker),
                                      OptionFiles::path_or_content, kOptions);
  if (!values) return pass_on(values);
  if (auto entered = values->enter(asked.request); !entered)
    return tl::unexpected(at_pointer(entered.error(), kOptions));
  return {};
}

Result<void> read_flags(Asked& asked, const Json& json, const Catalogue& catalogue) {
  for (const Task& task : catalogue.tasks)
    for (const TaskFlag& flag : task.flags) {
      const std::string key(flag.name);
      if (!json.value(key, false)) continue;
      if (&task != asked.task)
        return fail_at(refuse::flag_of_another, "/" + key, {{"task", task.name}});
      asked.flags.push_back(flag.name);
    }
  return {};
}

Result<void> read_artifacts(Asked& asked, const Json& names, const Catalogue& catalogue) {
  const auto& own = asked.task->artifacts;
  const std::string_view task = asked.task->name.empty() ? asked.maker->name : asked.task->name;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto name = names[i].get<std::string>();
    const std::string place = fmt::format("/artifacts/{}", i);
    if (own && own->empty()) return fail_at(refuse::writes_nothing, place, {{"task", task}});
    const bool known = !own || std::ranges::count(*own, name) > 0;
    const Artifact* artifact = known ? catalogue.artifact(*asked.maker, name) : nullptr;
    if (!artifact)
      return fail_at(
          refuse::not_written_by, place,
          {{"task", task},
           {"artifact", shortened(name)},
           {"known",
            fmt::format("{}", fmt::join(written_by(*asked.task, asked.maker, catalogue), ", "))}});
    if (artifact->role == Role::flat && artifact->suffix == ".dxf")
      asked.request.bending.as_made = true;
    asked.artifacts.push_back(artifact);
  }
  return {};
}

}  // namespace

std::vector<std::string_view> written_by(const Task& task, const Maker* maker,
                                         const Catalogue& catalogue) {
  if (task.artifacts) return *task.artifacts;
  std::vector<std::string_view> names;
  for (const Artifact* artifact : catalogue.written_by(*maker))
    names.push_back(artifact->name);
  return names;
}

std::vector<std::string_view> task_names(const Catalogue& catalogue) {
  std::vector<std::string_view> names;
  for (const Task& task : catalogue.tasks)
    if (!task.name.empty()) names.push_back(task.name);
  return names;
}

Result<Asked> read_asked(const std::string& text, const Catalogue& catalogue,
                         std::optional<std::string> bytes) {
  const Schema schema = request_schema(catalogue);
  JsonReading reading(text, "request", {}, schema);
  if (reading.error()) return tl::unexpected(*reading.error());
  const Json& json = reading.document();
  Asked asked;
  read_input_key(asked, json["input"]);
  if (bytes && asked.content) asked.content->content = std::move(*bytes);
  if (auto chosen = choose_maker(asked, json["maker"].get<std::string>(), catalogue); !chosen)
    return pass_on(chosen);
  if (json.contains("options"))
    if (auto read = read_options(asked, json["options"]); !read) return pass_on(read);
  if (json.value("effort", "full") == "draft") asked.request.effort = Effort::draft;
  if (asked.task->ask) asked.task->ask(asked.request);
  if (auto flags = read_flags(asked, json, catalogue); !flags) return pass_on(flags);
  if (json.contains("artifacts"))
    if (auto known = read_artifacts(asked, json["artifacts"], catalogue); !known)
      return pass_on(known);
  return asked;
}

Result<std::unique_ptr<Made>> make_asked(const Asked& asked, const Progress& progress) {
  const auto work = asked.content ? asked.maker->open(*asked.content, progress)
                                  : open_input(*asked.maker, asked.request, progress);
  if (!work) return pass_on(work);
  auto made = shown((*work)->make(asked.request, progress));
  if (!made) return made;
  if (auto piece = piece_of(**made, asked.request.piece); !piece) return pass_on(piece);
  (*made)->report().task = asked.task->name;
  return made;
}

Outcome<RunResult> told(const Made& made, std::vector<ArtifactFile> artifacts) {
  const Report& report = made.report();
  RunResult result{report.status(), made.json(), made.text(), std::move(artifacts)};
  if (!report.refusal) return result;
  return tl::unexpected(Refused<RunResult>(*report.refusal, std::move(result)));
}

Result<OptionValues> read_options(const std::string& json, const Maker& maker, OptionFiles files,
                                  const std::string& pointer) {
  if (const auto byte = too_deep_at(json))
    return fail(too_deep(json, *byte, "The options", pointer));
  const Json options = Json::parse(json, nullptr, false);
  if (options.is_discarded()) return fail_at(refuse::options_not_json, pointer);
  return checked_options(options, maker, files, pointer);
}

}  // namespace planish::job
