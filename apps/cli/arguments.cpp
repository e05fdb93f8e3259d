#include "arguments.hpp"

#include "apart.hpp"
#include "option_parts.hpp"

#include <planish/shop/rules_json.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace planish::cli {
namespace {

using job::Maker;
using job::Option;
using job::OptionKind;
using job::OptionUse;
using job::Role;

struct RoleWords {
  Role role;
  const char* option;
  const char* words;
};

constexpr RoleWords kRoles[] = {{Role::folded, "-o,--output", "folded part"},
                                {Role::flat, "--flat", "flat pattern"},
                                {Role::mould, "--mould", "mould that the sheet lies on"}};

std::string description(const Option& option, const OptionUse& use) {
  const auto otherwise = use.otherwise.empty() ? option.otherwise : use.otherwise;
  if (otherwise.empty()) return std::string(option.description);
  return fmt::format("{}; default {}", option.description, otherwise);
}

void add_used(CLI::App& app, const OptionUse& use, job::OptionValues& values) {
  const Option& option = use.entry();
  if (option.on_command_line) add_grouped(app, option, description(option, use), values);
}

void add_options(CLI::App& app, const Maker& maker, job::OptionValues& values, bool of_input) {
  for (const OptionUse& use : maker.options)
    if ((use.entry().group == job::OptionGroup::input) == of_input) add_used(app, use, values);
}

// ".dxf, .svg or .step"
std::string suffixes(const std::vector<const job::Artifact*>& artifacts) {
  std::string text;
  for (std::size_t i = 0; i < artifacts.size(); ++i)
    text += fmt::format("{}{}",
                        i == 0                      ? ""
                        : i + 1 == artifacts.size() ? " or "
                                                    : ", ",
                        artifacts[i]->suffix);
  return text;
}

// What is written if no output is named.
std::string default_words(const job::Catalogue& catalogue, const Maker& maker, Role role) {
  if (role == Role::mould) return {};
  const bool both = maker.makes(job::Source::folded_solid);
  const std::string other = !both ? "" : role == Role::flat ? ", without -o" : ", without --flat";
  return fmt::format("; default{}: <input>{} beside the input", other,
                     catalogue.written_by(maker, role).front()->file_end);
}

void add_outputs(CLI::App& app, const job::Catalogue& catalogue, const Maker& maker,
                 Arguments& to) {
  for (const RoleWords& role : kRoles) {
    const auto written = catalogue.written_by(maker, role.role);
    const bool folded = role.role == Role::folded && !maker.makes(job::Source::folded_solid);
    if (written.empty() || folded) continue;
    add_repeatable(app, role.option, to.outputs[role.role],
                   fmt::format("{}: {} file; may be given several times{}", role.words,
                               suffixes(written), default_words(catalogue, maker, role.role)))
        ->type_name("PATH")
        ->group("Output");
  }
}

// Makers whose inputs may hold several bodies write only the pattern, also into folders.
void add_body_outputs(CLI::App& app, const job::Catalogue& catalogue, const Maker& maker,
                      Arguments& to) {
  app.add_flag("--all", to.all,
               "unfold every different body into the folder given by -o, with summary.csv and "
               "summary.json")
      ->group("Input");
  const auto written = catalogue.written_by(maker, Role::flat);
  add_repeatable(app, "-o,--output", to.outputs[Role::flat],
                 fmt::format("{} file, or a folder; may be given several times; default: "
                             "<input>.dxf beside the input",
                             suffixes(written)))
      ->type_name("PATH")
      ->group("Output");
  const auto words = mapped(written, [&](const job::Artifact* artifact) {
    return std::string(artifact->suffix.substr(1));
  });
  const auto check = [words](const std::string& text) -> std::string {
    for (const std::string& word : between_commas(text))
      if (std::ranges::find(words, word) == words.end())
        return fmt::format("must be one of {}, not \"{}\"{}", fmt::join(words, ", "), word,
                           word == text ? "" : fmt::format(", in \"{}\"", text));
    return {};
  };
  add_repeatable(
      app, "--format", to.formats,
      fmt::format(
          "formats to write into a folder, or without -o: {}, separated by commas; default {}",
          fmt::join(words, ", "), words.front()))
      ->type_name("FORMATS")
      ->check(check)
      ->group("Output");
}

void add_report_options(CLI::App& app, Arguments& to) {
  add_text(app, "--json", to.json, "FILE", "report as JSON; - for standard output")
      ->group("Output");
  app.add_flag("--check", to.check, "do the work and report, but write no other file")
      ->group("Output");
  app.add_flag("-q,--quiet", to.quiet, "print no summary")->group("Output");
}

void add_print_rules(CLI::App& app) {
  const auto print = [&app] {
    const CLI::Option* process = app.get_option("--process");
    const bool punch = process->count() > 0 && process->results().back() == "punch";
    fmt::print("{}", shop::rules_json(rules_for(punch ? Process::punch : Process::laser)));
    throw CLI::Success();
  };
  app.add_flag_callback("--print-rules", print,
                        "print a rules file with all limits of the process, and exit")
      ->group("Checks");
}

}  // namespace

std::vector<std::string> formats_asked(const Arguments& arguments) {
  std::vector<std::string> all;
  for (const std::string& text : arguments.formats)
    for (std::string& word : between_commas(text))
      all.push_back(std::move(word));
  return all;
}

std::string_view output_option(const Maker& maker, Role role) {
  if (maker.takes("body")) return "-o";
  return role == Role::folded ? "-o" : role == Role::flat ? "--flat" : "--mould";
}

CLI::App* add_maker(CLI::App& app, const job::Catalogue& catalogue, const Maker& maker,
                    Arguments& arguments) {
  arguments.maker = &maker;
  CLI::App* command = app.add_subcommand(std::string(maker.name), std::string(maker.description));
  const std::string kind = maker.format.empty() ? "STEP file (AP203, AP214, AP242)"
                                                : maker.input_kind() + " (JSON)";
  add_text(*command, "input", arguments.input, "FILE", kind + ", or - for standard input")
      ->required();
  add_options(*command, maker, arguments.options, true);
  if (maker.takes("body"))
    add_body_outputs(*command, catalogue, maker, arguments);
  else
    add_outputs(*command, catalogue, maker, arguments);
  add_report_options(*command, arguments);
  add_options(*command, maker, arguments.options, false);
  add_limits(*command, arguments.limits);
  if (maker.takes("rules")) add_print_rules(*command);
  command->footer(std::string(maker.help));
  return command;
}

}  // namespace planish::cli
