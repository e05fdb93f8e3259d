#pragma once

#include <planish/job/options.hpp>

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace planish::cli {

/// A message of the library with the options that it names spelled as on the command line.
std::string spelled(const Error& error);

/// An option as its row says, of any kind but flags: what it is given is checked and entered in
/// `values`, which must outlive `app`, as must the row. `type` stands for the value in the help.
CLI::Option* add_option(CLI::App& app, const job::Option& option, const std::string& description,
                        const std::string& type, job::OptionValues& values);

/// An option of any kind, flags too, in the group that its row names.
void add_grouped(CLI::App& app, const job::Option& option, const std::string& description,
                 job::OptionValues& values);

/// A check that says what a value must be, as the option's row says: its kind, range and words.
std::function<std::string(const std::string&)> check_of(job::Option option);

/// A limit of time in seconds, at most a day, and a number of processes.
inline const job::Option kTimeLimit{.name = "time_limit",
                                    .kind = job::OptionKind::number,
                                    .description = {},
                                    .range = {"a number from 0.001 to 86400", 0.001, 86400.0}};
inline const job::Option kJobs{.name = "jobs",
                               .kind = job::OptionKind::whole,
                               .description = {},
                               .range = {"a whole number from 1 to 4096", 1.0, 4096.0}};

/// What stands for an option's value in the help: "N", "mm|inch|m".
std::string type_name(const job::Option& option);

/// "dxf", "" and "svg" of "dxf,,svg".
std::vector<std::string> between_commas(const std::string& text);

/// An option whose value may be any text but the empty one; `type` stands for it in the help.
CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& target,
                      const std::string& type, const std::string& description);

/// The STEP file that a command reads.
void add_step_input(CLI::App& app, std::string& target);

/// An option that may be given several times, each time with one value, so that an input may
/// follow it.
CLI::Option* add_repeatable(CLI::App& app, const std::string& name,
                            std::vector<std::string>& target, const std::string& description);

/// A check for options: an error message for an empty value, "" for any other.
std::string not_empty(const std::string& text);

}  // namespace planish::cli
