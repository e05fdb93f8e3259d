#include "commands.hpp"
#include "option_parts.hpp"
#include "refusals.hpp"
#include "terminal.hpp"

#include <planish/job/schemas.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace planish::cli {
namespace {

constexpr auto kSchemaExamples = R"(Examples:
  planish schema            the names of all schemas
  planish schema plates     what a plates file must hold
  planish schema report     what --json writes

They are in docs/schema/ too.)";

std::string names_of(const std::vector<const job::Artifact*>& artifacts) {
  const auto names = mapped(artifacts,
                            [&](const job::Artifact* artifact) { return artifact->name; });
  return fmt::format("{}", fmt::join(names, " "));
}

}  // namespace

CLI::App* add_schema(const Program& program, SchemaArguments& arguments) {
  CLI::App* command = program.app.add_subcommand(
      "schema", "print the JSON Schema of an input or of a report");
  add_text(*command, "name", arguments.name, "NAME",
           "name of the schema; without it, the names are listed");
  command->footer(kSchemaExamples);
  return command;
}

int run_schema(const Program& program, const SchemaArguments& arguments) {
  const auto names = job::schema_names(program.catalogue);
  const std::string& name = arguments.name;
  if (name.empty()) {
    fmt::print("{}\n", fmt::join(names, "\n"));
    return 0;
  }
  const std::string text = job::schema_text(name, program.catalogue);
  if (text.empty())
    return complain(
        error_of(refuse::no_such_name, {{"what", "schema"},
                                        {"name", name},
                                        {"known", fmt::format("{}", fmt::join(names, ", "))}}));
  fmt::print("{}", text);
  return 0;
}

std::string formats_text(const job::Catalogue& catalogue) {
  std::string text = "Makers:\n";
  for (const job::Maker& maker : catalogue.makers)
    text += fmt::format("  {:<11} {:<16} {}\n  {:<11} {:<16} writes {}\n", maker.name,
                        maker.input_kind(), maker.description, "", "",
                        names_of(catalogue.written_by(maker)));
  text += "\nFiles that are written:\n";
  for (const job::Artifact& artifact : catalogue.artifacts)
    text += fmt::format("  {:<11} {:<6} {:<17} {}\n", artifact.name, artifact.suffix,
                        artifact.media_type, artifact.description);
  return text;
}

}  // namespace planish::cli
