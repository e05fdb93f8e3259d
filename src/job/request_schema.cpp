// What a request may say, printed and checked by the same schema. It is made from the tables of
// makers, tasks and options, so that a new row is a new key here and nowhere else. `options` is the
// union over all makers: which of them one maker takes is checked when the request is read
// (asked.cpp), since the message can name the maker then.
#include "request_schema.hpp"

#include "asked.hpp"
#include "makers.hpp"

#include <planish/shop/schemas.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <span>

namespace planish::job {
using namespace shop;
using namespace schema;
namespace {

Schema file_schema(const Option& option, OptionFiles files) {
  const Schema content = option.name == "rules"      ? rules_schema()
                         : option.name == "material" ? material_schema()
                         : option.name == "shop"     ? shop_schema()
                                                     : text();
  const Schema given = object(
      {optional("name", text().said("for messages and reports")), required("content", content)});
  if (files == OptionFiles::content) {
    if (option.name != "material") return given;
    return any_of({text().said("name of a material of `shop`"), given},
                  "the name of a material of `shop`, or an object with the content of a file");
  }
  return any_of({text().said("path of the file"), given},
                "the path of a file, or an object with its content");
}

Schema face_schema(const Option& option) {
  Schema named = words(option.words);
  std::string said = fmt::format("{} or the number of a face", fmt::join(option.words, ", "));
  named.words = said;
  return any_of({whole(1), named}, std::move(said));
}

Schema bare_schema(const Option& option, OptionFiles files) {
  switch (option.kind) {
    case OptionKind::flag:
      return flag();
    case OptionKind::number:
      return number(option.range);
    case OptionKind::whole:
      return whole(static_cast<int>(option.range.low));
    case OptionKind::word:
      return words(option.words);
    case OptionKind::face:
      return face_schema(option);
    case OptionKind::name:
      return any_of({whole(1), text()}, "a number of at least 1, or a name");
    case OptionKind::file:
      return file_schema(option, files);
    case OptionKind::by_bend:
      break;
  }
  return map(number(option.range));
}

Schema input_schema() {
  return any_of(
      {text().said("path of the file; - reads standard input"),
       object({optional("name", text().said("for messages and reports, and the stem of files")),
               required("content",
                        any_of({text(), map(anything())}, "an object, or the text of a file")),
               optional("folder", text().said("folder of the files that it refers to"))})},
      "the path of a file, or an object with its content");
}

std::vector<std::string_view> artifact_names(const Catalogue& catalogue) {
  return mapped(catalogue.artifacts, &Artifact::name);
}

Schema effort_schema() {
  return words({"draft", "full"}).defaulting("full").said("draft: only the sheet and its pattern");
}

std::vector<Field> flag_fields(const Task& task) {
  std::vector<Field> fields;
  for (const TaskFlag& one : task.flags)
    fields.push_back(optional(std::string(one.name), flag().said(std::string(one.description))));
  return fields;
}

/// Makers with the options that requests for a task may have; `maker`: of that name, or null.
std::vector<Maker> takers(const Task& task, const Maker* maker, const Catalogue& catalogue) {
  if (task.reader != Reader::by_format) return {task.taking(maker)};
  std::vector<Maker> all;
  for (const Maker& one : catalogue.makers)
    all.push_back(task.taking(&one));
  return all;
}

/// All shared options, and the own ones of makers.
std::vector<const Option*> entries(std::span<const Maker> makers) {
  auto all = mapped(options(), [&](const Option& option) { return &option; });
  for (const Maker& maker : makers)
    for (const OptionUse& use : maker.options)
      if (use.own) all.push_back(use.own);
  return all;
}

Schema options_that(OptionFiles files, std::span<const Maker> makers,
                    const std::function<bool(const Option&)>& taken) {
  std::vector<Field> fields;
  for (const Option* option : entries(makers)) {
    if (!taken(*option)) continue;
    std::string said(option->description);
    if (!option->otherwise.empty()) said += fmt::format("; default {}", option->otherwise);
    fields.push_back(optional(std::string(option->name),
                              bare_schema(*option, files).or_null().said(std::move(said))));
  }
  return object(std::move(fields));
}

bool every_option(const Option&) { return true; }

OptionValue value_of(const Option& option, const Json& value) {
  switch (option.kind) {
    case OptionKind::flag:
      return value.get<bool>();
    case OptionKind::number:
    case OptionKind::whole:
      return value.get<double>();
    case OptionKind::by_bend: {
      std::vector<std::pair<std::string, double>> rows;
      for (const auto& [bend, k] : value.items())
        rows.emplace_back(bend, k.get<double>());
      return rows;
    }
    case OptionKind::file:
      if (value.is_object()) {
        const Json& content = value["content"];
        return OptionFile{value.value("name", std::string(option.name)),
                          content.is_string() ? content.get<std::string>() : content.dump()};
      }
      break;
    default:
      break;
  }
  return value.is_string() ? value.get<std::string>()
                           : std::to_string(static_cast<long long>(value.get<double>()));
}

Json json_of(bool value) { return value; }
Json json_of(double value) { return value; }
Json json_of(const std::string& value) { return value; }
Json json_of(const OptionFile& file) { return {{"name", file.name}, {"content", file.text}}; }
Json json_of(const std::vector<std::pair<std::string, double>>& numbers) {
  Json json = Json::object();
  for (const auto& [id, value] : numbers)
    json[id] = value;
  return json;
}

}  // namespace

Schema options_schema(OptionFiles files, const Maker& maker) {
  return options_that(files, {&maker, 1}, every_option);
}

Schema request_schema(const Catalogue& catalogue) {
  auto names = mapped(catalogue.makers, &Maker::name);
  const std::vector<std::string_view> others = task_names(catalogue);
  names.insert(names.end(), others.begin(), others.end());
  std::vector<Field> fields = header_fields("planish/request", 1);
  fields.push_back(required(
      "maker", words(names).said(fmt::format("or {}, which are none", fmt::join(others, " or ")))));
  fields.push_back(required("input", input_schema()));
  fields.push_back(
      optional("options", options_that(OptionFiles::path_or_content, catalogue.makers, every_option)
                              .said("options that the maker takes")));
  fields.push_back(
      optional("artifacts",
               list(words(artifact_names(catalogue))).said("artifacts that the maker can write")));
  fields.push_back(optional("effort", effort_schema()));
  for (const Task& task : catalogue.tasks)
    for (Field& one : flag_fields(task))
      fields.push_back(std::move(one));
  return object(std::move(fields)).said("A request to a maker");
}

Schema request_schema(const std::string& name, const Catalogue& catalogue) {
  const Task& task = *catalogue.task(name);
  const Maker* maker = catalogue.maker(name);
  const std::vector<Maker> any = takers(task, maker, catalogue);
  const auto taken = [&](const Option& option) {
    return std::ranges::any_of(any, [&](const Maker& one) { return one.takes(option.name); });
  };
  std::vector<Field> fields{
      required("input", input_schema()),
      optional("options", options_that(OptionFiles::path_or_content, catalogue.makers, taken))};
  if (task.drafts) fields.push_back(optional("effort", effort_schema()));
  const std::vector<std::string_view> written = written_by(task, maker, catalogue);
  if (!written.empty())
    fields.push_back(optional("artifacts", list(words(written)).said("files to make")));
  for (Field& one : flag_fields(task))
    fields.push_back(std::move(one));
  return object(std::move(fields));
}

OptionValues values_of(const Json& options, const Maker& maker) {
  OptionValues values;
  for (const Option* option : entries({&maker, 1})) {
    const auto given = options.find(std::string(option->name));
    if (given != options.end() && !given->is_null()) values.set(*option, value_of(*option, *given));
  }
  return values;
}

std::string options_json(const OptionValues& values) {
  Json json = Json::object();
  for (const auto& [option, value] : values.all())
    json[std::string(option->name)] = std::visit([](const auto& one) { return json_of(one); },
                                                 value);
  return json.dump();
}

}  // namespace planish::job
