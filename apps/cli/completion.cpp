#include "completion.hpp"

#include <planish/base/text.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace planish::cli {
namespace {

constexpr auto kBashEnd = R"(  if [[ -z $kind && $cur == -* ]]; then kind=words values=$options; fi
  if [[ -z $kind ]]; then kind=$input_kind values=$input_values; fi
  case $kind in
    words) COMPREPLY=($(compgen -W "$values" -- "$cur")) ;;
    commas) _planish_commas "$cur" "$values" ;;
    files) _planish_files "$cur" $values ;;
    folders) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- "$cur") ;;
  esac
}

# CUR SUFFIX...: folders, and the files with one of the suffixes; without suffixes all files.
_planish_files() {
  local cur=${1#[\"\']} suffix
  cur=${cur//\\/}
  shift
  compopt -o filenames
  mapfile -t COMPREPLY < <(
    if (($# == 0)); then compgen -f -- "$cur"; fi
    for suffix; do
      compgen -f -X "!*$suffix" -- "$cur"
      compgen -f -X "!*${suffix^^}" -- "$cur"
    done
    if (($# > 0)); then compgen -d -- "$cur"; fi)
}

# CUR WORDS: words that are separated by commas, each once.
_planish_commas() {
  local before= word left=
  if [[ $1 == *,* ]]; then before=${1%,*},; fi
  for word in $2; do
    if [[ ,$before != *,$word,* ]]; then left+=" $word"; fi
  done
  compopt -o nospace
  COMPREPLY=($(compgen -P "$before" -W "$left" -- "${1##*,}"))
}

complete -F _planish planish
)";

constexpr auto kFishBegin = R"(# fish completion for planish, written by `planish completion fish`.

# Whether the command of the line is the first argument.
function __planish_runs
    set -l words (commandline -opc)
    test (count $words) -ge 2; and test "$words[2]" = "$argv[1]"
end

# Whether the line has no command yet.
function __planish_begins
    test (count (commandline -opc)) -eq 1
end

# Words that are separated by commas, each once.
function __planish_commas
    set -l given (string split , -- (commandline -ct))
    set -l before (string join , -- $given[1..-2])
    test -n "$before"; and set before $before,
    for word in $argv
        contains -- $word $given[1..-2]; or printf '%s%s\n' $before $word
    end
end

# The files that end so, in either case, and folders.
function __planish_files
    set -l files (complete -C "__fish_command_without_completions "(commandline -ct))
    for suffix in $argv
        string match -ri -- '.*'(string escape --style=regex -- $suffix)'$' $files
    end
    string match -r -- '.*/$' $files
end

complete -c planish -f
)";

/// A description in a few words.
std::string brief(const std::string& text) {
  constexpr std::size_t kEnough = 12;
  std::size_t end = std::min(text.find("; "), text.size());
  const auto colon = text.find(": ", kEnough);
  end = std::min({end, colon == std::string::npos ? end : colon, text.find(", in mm")});
  std::string made = text.substr(0, end);
  std::erase(made, '`');
  return made;
}

std::string escaped(const std::string& text, const std::string& characters) {
  std::string made;
  for (const char c : text) {
    if (characters.find(c) != std::string::npos) made += '\\';
    made += c;
  }
  return made;
}

std::vector<std::string> all_names(const std::vector<TableOption>& options) {
  std::vector<std::string> all;
  for (const TableOption& option : options)
    all.insert(all.end(), option.names.begin(), option.names.end());
  return all;
}

std::vector<std::string> command_names(const std::vector<TableCommand>& table) {
  std::vector<std::string> names;
  for (const TableCommand& command : table)
    if (&command != &table.front()) names.push_back(command.name);
  return names;
}

// bash

/// "files" and the suffixes, "words" and the words ... of a value.
std::pair<std::string, std::string> bash_value(const TableOption& option) {
  if (option.commas) return {"commas", fmt::format("{}", fmt::join(option.words, " "))};
  if (option.folder) return {"folders", ""};
  if (option.file) return {"files", fmt::format("{}", fmt::join(option.suffixes, " "))};
  if (!option.words.empty()) return {"words", fmt::format("{}", fmt::join(option.words, " "))};
  return {"value", ""};
}

std::string bash_command(const TableCommand& command) {
  std::string text = fmt::format("    {})\n      options='{}'\n", command.name,
                                 fmt::join(all_names(command.options), " "));
  for (const TableOption& input : command.inputs) {
    const auto [kind, values] = bash_value(input);
    text += fmt::format("      input_kind={} input_values='{}'\n", kind, values);
  }
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> by_value;
  for (const TableOption& option : command.options)
    if (!option.type.empty())
      for (const std::string& name : option.names)
        by_value[bash_value(option)].push_back(name);
  if (!by_value.empty()) {
    text += "      case $prev in\n";
    for (const auto& [value, names] : by_value)
      text += fmt::format("        {}) kind={} values='{}' ;;\n", fmt::join(names, " | "),
                          value.first, value.second);
    text += "      esac\n";
  }
  return text + "      ;;\n";
}

// zsh

std::string zsh_quoted(const std::string& text) {
  return "'" + replaced(text, {{'\'', "'\\''"}}) + "'";
}

std::string zsh_action(const TableOption& option) {
  if (option.commas) return fmt::format("_values -s , format {}", fmt::join(option.words, " "));
  if (option.folder) return "_files -/";
  if (option.file && option.suffixes.empty()) return "_files";
  if (option.file) {
    const auto ends = mapped(option.suffixes,
                             [&](const std::string& suffix) { return suffix.substr(1); });
    // One in parentheses at the end would be taken for a qualifier.
    const std::string any = fmt::format("{}", fmt::join(ends, "|"));
    return fmt::format("_files -g \"*.(#i){}\"", ends.size() == 1 ? any : "(" + any + ")");
  }
  if (!option.words.empty()) return fmt::format("({})", fmt::join(option.words, " "));
  return " ";
}

std::string zsh_option(const TableOption& option) {
  const std::string before = option.repeats ? "*"
                                            : fmt::format("({})", fmt::join(option.names, " "));
  const std::string value = option.type.empty() ? ""
                                                : fmt::format(":{}:{}", escaped(option.type, ":"),
                                                              zsh_action(option));
  const std::string said = "[" + escaped(brief(option.description), "[]\\") + "]";
  std::string text;
  for (const std::string& name : option.names) {
    const std::string sign = option.type.empty() ? "" : name.starts_with("--") ? "=" : "+";
    text += fmt::format(" \\\n        {}", zsh_quoted(before + name + sign + said + value));
  }
  return text;
}

std::string zsh_command(const TableCommand& command) {
  std::string text = fmt::format("    {})\n      _arguments", command.name);
  for (const TableOption& option : command.options)
    text += zsh_option(option);
  for (const TableOption& input : command.inputs)
    text += fmt::format(" \\\n        {}",
                        zsh_quoted(fmt::format("{}:{}:{}", input.repeats ? "*" : "1", input.type,
                                               zsh_action(input))));
  return text + "\n      ;;\n";
}

// fish

std::string fish_quoted(const std::string& text) { return "'" + escaped(text, "\\'") + "'"; }

/// How a value is completed, as options of `complete`.
std::string fish_value(const TableOption& option) {
  if (option.commas)
    return fmt::format(" -x -a '(__planish_commas {})'", fmt::join(option.words, " "));
  if (option.folder) return " -x -a '(__fish_complete_directories)'";
  if (option.file && option.suffixes.empty()) return " -r -F";
  if (option.file)
    return fmt::format(" -x -k -a '(__planish_files {})'", fmt::join(option.suffixes, " "));
  if (!option.words.empty()) return fmt::format(" -x -a '{}'", fmt::join(option.words, " "));
  return " -x";
}

std::string fish_option(const std::string& condition, const TableOption& option) {
  std::string text = fmt::format("complete -c planish -n {}", fish_quoted(condition));
  for (const std::string& name : option.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.type.empty()) text += fish_value(option);
  return text + fmt::format(" -d {}\n", fish_quoted(brief(option.description)));
}

std::string fish_input(const std::string& condition, const TableOption& input) {
  std::string value = fish_value(input);
  const auto exclusive = value.find(" -x");
  if (exclusive != std::string::npos) value.erase(exclusive, 3);
  if (const auto required = value.find(" -r"); required != std::string::npos)
    value.erase(required, 3);
  return fmt::format("complete -c planish -n {}{}\n", fish_quoted(condition), value);
}

}  // namespace

std::string bash_completion(const std::vector<TableCommand>& table) {
  std::string text = fmt::format(
      R"(# bash completion for planish, written by `planish completion bash`.

_planish() {{
  local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}}
  local kind= values= options= input_kind= input_values=
  COMPREPLY=()
  # For bash "--units=mm" is three words.
  if [[ $cur == = ]]; then cur=; elif [[ $prev == = ]]; then prev=${{COMP_WORDS[COMP_CWORD-2]}}; fi
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '{} {}' -- "$cur"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
)",
      fmt::join(command_names(table), " "), fmt::join(all_names(table.front().options), " "));
  for (const TableCommand& command : table)
    if (&command != &table.front()) text += bash_command(command);
  return text + "    *) return ;;\n  esac\n" + kBashEnd;
}

std::string zsh_completion(const std::vector<TableCommand>& table) {
  std::string text =
      "#compdef planish\n# zsh completion for planish, written by `planish completion zsh`.\n\n"
      "_planish() {\n  local curcontext=$curcontext state line\n  local -A opt_args\n"
      "  local -a commands\n  commands=(\n";
  for (const TableCommand& command : table)
    if (&command != &table.front())
      text += fmt::format("    {}\n", zsh_quoted(command.name + ":" + brief(command.description)));
  text += "  )\n  _arguments -C";
  for (const TableOption& option : table.front().options)
    text += zsh_option(option);
  text +=
      " \\\n        '1:command:->command' '*::argument:->argument'\n  case $state in\n"
      "  command) _describe command commands ;;\n  argument)\n    case $words[1] in\n";
  for (const TableCommand& command : table)
    if (&command != &table.front()) text += zsh_command(command);
  return text +
         "    esac\n    ;;\n  esac\n}\n\n"
         "if [[ $funcstack[1] == _planish ]]; then _planish \"$@\"; else compdef _planish planish; "
         "fi\n";
}

std::string fish_completion(const std::vector<TableCommand>& table) {
  std::string text = kFishBegin;
  for (const TableOption& option : table.front().options)
    text += fish_option("__planish_begins", option);
  for (const TableCommand& command : table) {
    if (&command == &table.front()) continue;
    text += fmt::format("\ncomplete -c planish -n __planish_begins -a {} -d {}\n", command.name,
                        fish_quoted(brief(command.description)));
    const std::string condition = "__planish_runs " + command.name;
    for (const TableOption& input : command.inputs)
      text += fish_input(condition, input);
    for (const TableOption& option : command.options)
      text += fish_option(condition, option);
  }
  return text;
}

}  // namespace planish::cli
