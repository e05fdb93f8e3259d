#include "request_schema.hpp"

#include "input_schemas.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace planish::job {
namespace {

Schema file_schema(const Option& option, OptionFiles files) {
  const Schema content = option.name == "rules"      ? rules_schema()
                         : option.name == "material" ? material_schema()
                         : option.name == "shop"     ? shop_schema()
                                                     : text();
  const Schema given = object(
      {optional("name", text().said("for messages and reports")), required("content", content)});
  if (files == OptionFiles::content) return given;
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
  std::vector<std::string_view> names;
  for (const Artifact& artifact : catalogue.artifacts)
    names.push_back(artifact.name);
  return names;
}

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

}  // namespace

Schema options_schema(OptionFiles files) {
  std::vector<Field> fields;
  for (const Option& option : options()) {
    std::string said(option.description);
    if (!option.otherwise.empty()) said += fmt::format("; default {}", option.otherwise);
    fields.push_back(optional(std::string(option.name),
                              bare_schema(option, files).or_null().said(std::move(said))));
  }
  return object(std::move(fields));
}

Schema request_schema(const Catalogue& catalogue) {
  std::vector<std::string_view> names;
  for (const Maker& maker : catalogue.makers)
    names.push_back(maker.name);
  std::vector<Field> fields = header_fields("planish/request", 1);
  fields.push_back(required("maker", words(names)));
  fields.push_back(required("input", input_schema()));
  fields.push_back(
      optional("options",
               options_schema(OptionFiles::path_or_content).said("options that the maker takes")));
  fields.push_back(
      optional("artifacts",
               list(words(artifact_names(catalogue))).said("artifacts that the maker can write")));
  fields.push_back(optional(
      "effort",
      words({"draft", "full"}).defaulting("full").said("draft: only the sheet and its pattern")));
  fields.push_back(optional(
      "plan", flag().defaulting(false).said("find the order of bends, as planish bend does")));
  return object(std::move(fields)).said("A request to a maker");
}

OptionValues values_of(const Json& options) {
  OptionValues values;
  for (const auto& [key, value] : options.items())
    if (!value.is_null()) values.set(option(key), value_of(option(key), value));
  return values;
}

}  // namespace planish::job
