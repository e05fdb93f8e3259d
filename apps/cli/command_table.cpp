#include "command_table.hpp"

#include "help_format.hpp"
#include "option_parts.hpp"

#include <planish/job/schemas.hpp>

#include <algorithm>
#include <cctype>

namespace planish::cli {
namespace {

bool is_word(const std::string& text) {
  return !text.empty() && std::ranges::none_of(text, [](unsigned char c) {
    return !std::islower(c) && !std::isdigit(c) && c != '_' && c != '-';
  });
}

/// "auto" and "reference" of "auto|reference|FACE".
std::vector<std::string> words_in(const std::string& type) {
  std::vector<std::string> words;
  std::size_t from = 0;
  for (std::size_t to = 0; to != std::string::npos; from = to + 1) {
    to = type.find('|', from);
    std::string word = type.substr(from, to == std::string::npos ? to : to - from);
    if (is_word(word)) words.push_back(std::move(word));
  }
  return words;
}

void describe_file(TableOption& entry, const std::string& command,
                   const job::Catalogue& catalogue) {
  const std::string kind = entry.type.substr(entry.type.rfind('|') + 1);
  const bool input = !entry.names.front().starts_with("-");
  entry.folder = kind == "FOLDER/";
  entry.file = kind.starts_with("FILE") || kind == "STEP" || kind == "PATH" || kind == "INPUT";
  if (kind.starts_with("FILE.")) entry.suffixes = {kind.substr(4)};
  // A file of any kind is what the command's maker reads, of other commands all that makers read.
  const job::Maker* maker = input && kind == "FILE" ? catalogue.maker(command) : nullptr;
  const bool any = input && kind == "FILE" && !maker;
  if (any || kind == "STEP" || (maker && maker->format.empty()))
    entry.suffixes = {".step", ".stp", ".stpz", ".gz", ".zip", ".brep"};
  if (any || (maker && !maker->format.empty())) entry.suffixes.emplace_back(".json");
}

/// What `--format` takes: of a maker the suffixes of what it writes into a folder; else all names.
std::vector<std::string> formats_of_command(const std::string& command,
                                            const job::Catalogue& catalogue) {
  std::vector<std::string> words;
  if (const job::Maker* maker = catalogue.maker(command)) {
    for (const job::Artifact* artifact : catalogue.written_by(*maker, job::Role::flat))
      words.emplace_back(artifact->suffix.substr(1));
    return words;
  }
  for (const job::Artifact& artifact : catalogue.artifacts)
    words.emplace_back(artifact.name);
  return words;
}

TableOption table_option(const CLI::Option& option, const std::string& command,
                         const job::Catalogue& catalogue) {
  TableOption entry;
  for (const std::string& name : option.get_snames())
    entry.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    entry.names.push_back("--" + name);
  if (option.get_positional()) entry.names = {option.get_name(true, false)};
  entry.type = plain_type(option);
  entry.group = option.get_group();
  entry.description = option.get_description();
  entry.required = option.get_required();
  entry.repeats = option.get_items_expected_max() > 1;
  entry.words = words_in(entry.type);
  describe_file(entry, command, catalogue);
  if (entry.names.back() == "--format") {
    entry.words = formats_of_command(command, catalogue);
    entry.commas = true;
  }
  if (command == "schema" && option.get_positional()) entry.words = job::schema_names(catalogue);
  return entry;
}

TableCommand table_command(const CLI::App& app, const std::string& name,
                           const job::Catalogue& catalogue) {
  TableCommand entry{.name = name,
                     .description = app.get_description(),
                     .footer = app.get_footer(),
                     .options = {},
                     .inputs = {}};
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; }))
    (option->get_positional() ? entry.inputs : entry.options)
        .push_back(table_option(*option, name, catalogue));
  return entry;
}

}  // namespace

std::vector<TableCommand> command_table(const CLI::App& app, const job::Catalogue& catalogue) {
  std::vector<TableCommand> table{table_command(app, app.get_name(), catalogue)};
  for (const CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!one->get_group().empty()) table.push_back(table_command(*one, one->get_name(), catalogue));
  for (TableCommand& command : table)
    for (TableOption& input : command.inputs)
      if (input.type == "COMMAND")
        for (const TableCommand& other : table)
          if (&other != &table.front()) input.words.push_back(other.name);
  return table;
}

}  // namespace planish::cli
