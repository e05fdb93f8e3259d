#include "manual.hpp"

#include <planish/base/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace planish::cli {
namespace {

constexpr auto kProgramExitStatus = R"(.TP
.B 0
Done, possibly with warnings.
.TP
.B 1
Internal error, or cancelled.
.TP
.B 2
Wrong usage.
.TP
.B 3
A file cannot be read, is invalid, crashes the CAD kernel or cannot be written.
.TP
.B 4
Refused: the input is understood, but has no flat pattern, or none within the limits.
)";

constexpr auto kProgramFiles = R"(.SH FILES
.TP
.I /usr/share/doc/planish/docs
What the help refers to as docs/, if Planish was installed as a package.
.TP
.I /usr/share/doc/planish/examples
Parts and files to try.
)";

/// What man(7) must not take for an instruction; \& hides a dot at the beginning of a line.
std::string roff(std::string_view text) {
  std::string made;
  for (const char c : text) {
    const bool at_start = made.empty() || made.back() == '\n';
    if (at_start && (c == '.' || c == '\'')) made += "\\&";
    made += replaced({&c, 1}, {{'\\', "\\e"},
                               {'-', "\\-"},
                               {'\'', "\\(aq"},
                               {'`', "\\(ga"},
                               {'^', "\\(ha"},
                               {'~', "\\(ti"}});
  }
  return made;
}

/// Running text: what is between backquotes is bold.
std::string prose(std::string_view text) {
  std::string made;
  bool bold = false;
  while (!text.empty()) {
    const auto quote = text.find('`');
    const std::string part = roff(text.substr(0, quote));
    // Within a line a dot is a dot.
    made += !made.empty() && part.starts_with("\\&") ? part.substr(2) : part;
    if (quote == std::string_view::npos) break;
    bold = !bold;
    made += bold ? "\\fB" : "\\fR";
    text.remove_prefix(quote + 1);
  }
  return made;
}

/// A description as a sentence; units and keys at its beginning ("kg/dm³", "json:") stay small.
std::string sentence_of(const std::string& text) {
  std::string made = prose(text);
  if (made.empty()) return made;
  const std::string first = text.substr(0, text.find_first_of(" ,"));
  const bool is_word = std::ranges::all_of(first, [](unsigned char c) { return std::isalpha(c); });
  if (is_word) made = capitalized(std::move(made));
  return made.ends_with('.') ? made : made + ".";
}

std::string in_capitals(std::string_view text) {
  std::string made(text);
  std::ranges::transform(made, made.begin(), [](unsigned char c) { return std::toupper(c); });
  return made;
}

std::string as_written(std::string_view lines) {
  return fmt::format(".nf\n{}{}.fi\n", roff(lines), lines.ends_with('\n') ? "" : "\n");
}

/// The end of a help: what stands under "Examples:" and "Exit status:", and the rest.
struct Footer {
  std::string examples, exit_status, notes;
};

Footer footer_of(const std::string& text) {
  constexpr std::string_view kExit = "Exit status:", kExample = "Examples:";
  Footer made;
  std::string* section = &made.notes;
  for (std::size_t from = 0, to = 0; from < text.size(); from = to + 1) {
    to = std::min(text.find('\n', from), text.size());
    std::string line = text.substr(from, to - from);
    const bool indented = line.starts_with("  ");
    if (!indented) section = &made.notes;
    if (line.ends_with(kExit) || line == kExample) {
      section = line == kExample ? &made.examples : &made.exit_status;
      line.erase(line.size() - (line == kExample ? kExample : kExit).size());
      if (!line.empty()) made.notes += line + "\n";
    } else if (!line.empty()) {
      *section += (indented ? line.substr(2) : line) + "\n";
    }
  }
  return made;
}

std::string option_names(const TableOption& option) {
  std::string text;
  for (const std::string& name : option.names)
    text += fmt::format("{}\\fB{}\\fR", text.empty() ? "" : ", ", roff(name));
  if (!option.type.empty()) text += fmt::format(" \\fI{}\\fR", roff(option.type));
  return text;
}

std::string options_section(const TableCommand& command) {
  std::vector<std::string> groups;
  for (const TableOption& option : command.options)
    if (std::ranges::find(groups, option.group) == groups.end()) groups.push_back(option.group);
  std::string text = ".SH OPTIONS\n";
  for (const std::string& group : groups) {
    if (group != "Options") text += fmt::format(".SS {}\n", roff(group));
    for (const TableOption& option : command.options)
      if (option.group == group)
        text += fmt::format(".TP\n{}\n{}\n", option_names(option), sentence_of(option.description));
  }
  return text;
}

std::string synopsis(const std::vector<TableCommand>& table, const TableCommand& command) {
  const std::string& program = table.front().name;
  std::string text = ".SH SYNOPSIS\n";
  if (&command == &table.front())
    return text + fmt::format(
                      ".B {0}\n.I COMMAND\n.RI [ options ]\n.RI [ INPUT ...]\n.br\n"
                      ".B {0}\n.RB [ \\-\\-help | \\-\\-version | \\-\\-formats ]\n",
                      program);
  text += fmt::format(".B {} {}\n.RI [ options ]\n", program, command.name);
  for (const TableOption& input : command.inputs) {
    const std::string type = roff(input.type) + (input.repeats ? "\\fR..." : "");
    text += input.required ? fmt::format(".I {}\n", type) : fmt::format(".RI [ {} ]\n", type);
  }
  return text;
}

std::string description_section(const std::vector<TableCommand>& table,
                                const TableCommand& command) {
  std::string text = fmt::format(".SH DESCRIPTION\n{}\n", sentence_of(command.description));
  for (const TableOption& input : command.inputs)
    text += fmt::format(".TP\n.I {}\n{}\n", roff(input.type), sentence_of(input.description));
  if (&command != &table.front()) return text;
  text += ".SH COMMANDS\nEach has a manual page of its own.\n";
  for (const TableCommand& one : table)
    if (&one != &table.front())
      text += fmt::format(".TP\n.BR {}\\-{} (1)\n{}\n", command.name, one.name,
                          sentence_of(one.description));
  return text;
}

std::string closing_sections(const std::vector<TableCommand>& table, const TableCommand& command) {
  const bool program = &command == &table.front();
  const Footer footer = footer_of(command.footer);
  std::string text;
  if (program)
    text += std::string(".SH \"EXIT STATUS\"\n") + kProgramExitStatus;
  else if (!footer.exit_status.empty())
    text += ".SH \"EXIT STATUS\"\n" + as_written(footer.exit_status);
  if (!footer.notes.empty()) text += ".SH NOTES\n" + prose(footer.notes);
  if (!footer.examples.empty()) text += ".SH EXAMPLES\n" + as_written(footer.examples);
  if (program) text += kProgramFiles;
  return text;
}

std::string see_also(const std::vector<TableCommand>& table, const TableCommand& command) {
  std::vector<std::string> pages;
  for (const TableCommand& other : table)
    if (&other != &command) pages.push_back(roff(page_name(table, other)));
  std::ranges::sort(pages);
  std::string text = ".SH \"SEE ALSO\"\n";
  for (const std::string& page : pages)
    text += fmt::format(".BR {} (1){}\n", page, &page == &pages.back() ? "" : ",");
  return text;
}

}  // namespace

std::string page_name(const std::vector<TableCommand>& table, const TableCommand& command) {
  const std::string& program = table.front().name;
  return &command == &table.front() ? program : program + "-" + command.name;
}

std::string manual_page(const std::vector<TableCommand>& table, const TableCommand& command,
                        std::string_view date, std::string_view version) {
  const std::string name = page_name(table, command);
  std::string text = fmt::format(".TH {} 1 {} \"{} {}\" \"User Commands\"\n.nh\n",
                                 roff(in_capitals(name)), date, table.front().name, version);
  const std::string summary = &command == &table.front() ? "lay sheet metal flat"
                                                         : command.description;
  text += fmt::format(".SH NAME\n{} \\- {}\n", roff(name), prose(summary));
  text += synopsis(table, command) + description_section(table, command);
  return text + options_section(command) + closing_sections(table, command) +
         see_also(table, command);
}

}  // namespace planish::cli
