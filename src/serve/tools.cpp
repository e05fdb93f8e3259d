#include "tools.hpp"

#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/job/schemas.hpp>
#include <planish/schema/fail_at.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace planish::serve {
namespace {

constexpr auto kReport =
    "Answers with a report: size of the blank, bends, findings, how far the "
    "pattern can be trusted; or why there is no flat pattern.";

/// "write": where which artifact goes.
Json write_schema(const Json& artifacts) {
  Json paths = Json::object();
  for (const Json& artifact : artifacts)
    paths[artifact.get<std::string>()] = {{"type", "string"}, {"minLength", 1}};
  return {{"description",
           "files to write: the path of each artifact; all are written, or none. Those of several "
           "pieces are numbered"},
          {"type", "object"},
          {"properties", std::move(paths)},
          {"additionalProperties", false}};
}

/// The list of tools is read whole by a model, again and again: what an option's file holds is left
/// to `schema`.
void leave_to_schema(const std::string& name, Json& option) {
  if (!option.contains("anyOf")) return;
  for (Json& one : option["anyOf"])
    if (one.contains("properties") && one["properties"].contains("content") &&
        one["properties"]["content"].value("type", "") == "object")
      one["properties"]["content"] = {
          {"description",
           fmt::format("an object, or the text of a file; `schema` with name \"{}\" says what it "
                       "must hold",
                       name)}};
}

/// Without null, which says no more than leaving the option out.
void leave_out_null(Json& option) {
  if (!option.contains("anyOf") || option["anyOf"].size() != 2) return;
  if (option["anyOf"][1] != Json{{"type", "null"}}) return;
  Json one = option["anyOf"][0];
  option.erase("anyOf");
  one.update(option);
  option = std::move(one);
}

/// The schema of a request as that of a call: it reads no standard input, and can write files.
Json parameters_of(const std::string& name, const job::Catalogue& catalogue) {
  Json schema = Json::parse(job::request_schema_text(name, catalogue));
  for (const char* key : {"$schema", "$id", "title"})
    schema.erase(key);
  Json& properties = schema["properties"];
  properties["input"]["anyOf"][0]["description"] = "path of the file";
  for (auto& [option, value] : properties["options"]["properties"].items()) {
    leave_out_null(value);
    leave_to_schema(option, value);
  }
  if (properties.contains("artifacts"))
    properties["write"] = write_schema(properties["artifacts"]["items"]["enum"]);
  return schema;
}

Tool tool_of(const job::Maker& maker, const job::Catalogue& catalogue) {
  std::string said = fmt::format("{}. Reads a {}", capitalized(std::string(maker.description)),
                                 maker.input_kind());
  if (maker.schema)
    said += fmt::format(", JSON; `schema` with name \"{}\" says what it must hold",
                        maker.schema_name());
  return {std::string(maker.name), fmt::format("{}. {}", said, kReport),
          parameters_of(std::string(maker.name), catalogue), true};
}

Json object_schema(Json properties) {
  return {
      {"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

}  // namespace

std::vector<Tool> tools_of(const job::Catalogue& catalogue) {
  auto tools = mapped(catalogue.makers,
                      [&](const job::Maker& maker) { return tool_of(maker, catalogue); });
  for (const job::Task& task : catalogue.tasks)
    if (!task.name.empty())
      tools.push_back({std::string(task.name), std::string(task.details),
                       parameters_of(std::string(task.name), catalogue), true});
  tools.push_back(
      {"schema",
       "Give the JSON Schema of a file that is read or of a report; without a name the "
       "names of all.",
       object_schema({{"name", {{"type", "string"}, {"enum", job::schema_names(catalogue)}}}}),
       false});
  tools.push_back({"formats",
                   "List the makers with what they read, and the files that are written.",
                   object_schema(Json::object()), false});
  return tools;
}

Result<Json> answer_at_once(const std::string& tool, const Json& parameters,
                            const job::Catalogue& catalogue) {
  if (tool == "formats") return Json::parse(job::catalogue_json(catalogue));
  const auto names = job::schema_names(catalogue);
  if (!parameters.contains("name")) return Json{{"names", names}};
  const Json& name = parameters["name"];
  const std::string text = name.is_string() ? job::schema_text(name.get<std::string>(), catalogue)
                                            : "";
  if (text.empty())
    return schema::fail_at(
        refuse::no_such_schema, "/name",
        {{"name", text_of(name)}, {"known", fmt::format("{}", fmt::join(names, ", "))}});
  return Json::parse(text);
}

}  // namespace planish::serve
