#pragma once

#include <planish/job/maker.hpp>

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace planish::job {

struct Asked;
struct RunResult;

/// Who reads the input of a task.
enum class Reader {
  named,      ///< the maker that the request names
  by_format,  ///< the maker of the input's format
  none,       ///< the task itself; a STEP file
};

/// A key that only requests for one task have: true or false.
struct TaskFlag {
  std::string_view name, description;
};

/// An entry in the table of tasks: what a request can ask for. A new one is a row of
/// src/job/tasks.cpp and the function that it names. All texts are for people.
struct Task {
  std::string_view name = {};  ///< "bend": key "maker", subcommand, tool; empty: that of the maker
  std::string_view description = {};  ///< of a command: "show what is in a STEP file"
  std::string_view details = {};      ///< of a tool, for who has read nothing else: sentences
  Reader reader = Reader::none;
  /// A maker with the options that the task takes of what `reader` (null: none) reads.
  Maker (*taking)(const Maker* reader) = nullptr;
  /// What can be written; empty: all of the maker that the request names.
  std::optional<std::vector<std::string_view>> artifacts = {};
  bool drafts = false;  ///< whether a request may ask for less effort
  std::vector<TaskFlag> flags = {};
  /// What it asks of the maker besides what the request says; null: nothing.
  void (*ask)(Request& request) = nullptr;
  /// Errors: those of `run`.
  Outcome<RunResult> (*run)(const Asked& asked, const Progress& progress) = nullptr;
};

/// The tasks of Planish: first that of the makers, without a name, then each with one of its own.
const std::vector<Task>& tasks();

/// Options of the press brake and of the order of bends, beside those of making the sheet.
inline constexpr std::array<std::string_view, 13> kPlanOptions{
    "tools",       "springback",  "clearance",      "shortfall", "opening", "v",    "as_drawn",
    "large_radii", "chord_error", "gauge_openings", "weights",   "fix",     "first"};

/// Whether an option says how the sheet is made that is to be bent: how it bends and is laid flat,
/// not how it is written or checked. Not `material`, whose words may stand for metals.
bool is_of_sheet_to_bend(const Option& option);

/// `maker` as `planish bend` uses it: with these options, those above, and the metal's.
Maker bending_with(const Maker& maker);

}  // namespace planish::job
