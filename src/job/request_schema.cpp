#include "request_schema.hpp"

#include "asked.hpp"
#include "input_schemas.hpp"

#include <planish/job/bend.hpp>
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

Schema sheets_schema() { return flag().said("of info: the sheet in each body, or why none"); }

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

}  // namespace

Schema options_schema(OptionFiles files, const Maker& maker) {
  return options_that(files, {&maker, 1}, every_option);
}

Schema request_schema(const Catalogue& catalogue) {
  auto names = mapped(catalogue.makers, &Maker::name);
  names.insert(names.end(), {kBend, kInfo});
  std::vector<Field> fields = header_fields("planish/request", 1);
  fields.push_back(required("maker", words(names).said("or bend or info, which are none")));
  fields.push_back(required("input", input_schema()));
  fields.push_back(
      optional("options", options_that(OptionFiles::path_or_content, catalogue.makers, every_option)
                              .said("options that the maker takes")));
  fields.push_back(
      optional("artifacts",
               list(words(artifact_names(catalogue))).said("artifacts that the maker can write")));
  fields.push_back(optional("effort", effort_schema()));
  fields.push_back(optional("sheets", sheets_schema()));
  return object(std::move(fields)).said("A request to a maker");
}

Schema request_schema(const std::string& maker, const Catalogue& catalogue) {
  const auto taken = [&](const Option& option) {
    if (maker == kInfo) return option.name == "body" || option.name == "units";
    if (maker != kBend) return catalogue.maker(maker)->takes(option.name);
    return std::ranges::any_of(
        catalogue.makers, [&](const Maker& one) { return bending_with(one).takes(option.name); });
  };
  std::vector<Field> fields{
      required("input", input_schema()),
      optional("options", options_that(OptionFiles::path_or_content, catalogue.makers, taken))};
  if (maker == kInfo) {
    fields.push_back(optional("sheets", sheets_schema()));
    return object(std::move(fields));
  }
  std::vector<std::string_view> names(std::begin(kBendArtifacts), std::end(kBendArtifacts));
  if (maker != kBend) {
    names.clear();
    for (const Artifact* artifact : catalogue.written_by(*catalogue.maker(maker)))
      names.push_back(artifact->name);
    fields.push_back(optional("effort", effort_schema()));
  }
  fields.push_back(optional("artifacts", list(words(names)).said("files to make")));
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

}  // namespace planish::job
