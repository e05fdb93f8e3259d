#pragma once

#include <planish/base/result.hpp>
#include <planish/job/range.hpp>
#include <planish/job/request.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace planish::job {

enum class OptionKind {
  flag,
  number,   ///< within `range`
  whole,    ///< within `range`
  word,     ///< one of `words`
  face,     ///< one of `words`, or the number of a face
  name,     ///< a text, or a whole number of at least 1
  file,     ///< the path of a text file, or its content
  by_bend,  ///< numbers within `range` by ids of bends
};

/// The content of an option's file; `name` is for messages and reports.
struct OptionFile {
  std::string name, text;
};

using OptionValue = std::variant<bool, double, std::string, OptionFile,
                                 std::vector<std::pair<std::string, double>>>;

/// One thing that can be asked of makers, under one name everywhere: `name` is its key in requests,
/// and on a command line its "_" are "-" behind "--".
struct Option {
  std::string_view name;
  OptionKind kind;
  std::string_view group;           ///< heading in the help: "Bends"
  std::string_view description;     ///< one line, without the default
  std::string_view otherwise = {};  ///< the default in words; empty: see `OptionUse`, or none
  Range range = kAnyNumber;
  std::vector<std::string_view> words = {};
  std::string_view file_type = {};  ///< "FILE.csv"
  bool on_command_line = true;
  /// Enters a value of the option's kind. Errors: `invalid_input` for the content of files.
  Result<void> (*set)(Request& request, const OptionValue& value) = nullptr;
};

/// An option that a maker takes, and its default in words where the maker decides that.
struct OptionUse {
  std::string_view name;
  std::string_view otherwise = {};
};

/// Every option of the built-in makers, in the order in which help lists them.
std::span<const Option> options();
/// Requires that there is one.
const Option& option(std::string_view name);

/// Values that were given, in any order.
class OptionValues {
 public:
  /// One value as text, as a command line has it; of `by_bend` "B1=0.4", added to those before.
  /// Flags take "true" and "false". Files stay unread. Errors: `bad_option` with what the value
  /// must be; `where` is the option's name.
  Result<void> set_text(const Option& option, const std::string& text);
  void set(const Option& option, OptionValue value);

  bool given(std::string_view name) const;
  /// The text of a word, face, name or path; empty where it was not given.
  std::string text(std::string_view name) const;
  std::optional<double> number(std::string_view name) const;

  /// What is wrong with options that are each right by themselves: `bad_option`, names of options
  /// between backquotes; `where` is the name of one.
  Result<void> check_together() const;
  /// Enters all in a request, and reads the files whose paths were given. Errors: those of
  /// `check_together`; `cannot_read`, `invalid_input` with the place in the file, of content that
  /// was given behind "rules/content".
  Result<void> enter(Request& request) const;

 private:
  std::vector<std::pair<const Option*, OptionValue>> values_;
};

/// The option that a place is of, "bend_k" of "bend_k/B99"; null where it is of none.
const Option* option_at(std::string_view where);

/// The error of a request whose options stand at a JSON pointer: of the place "bend_k/B99" it makes
/// "/options/bend_k/B99"; places that are no option's stay.
Error at_pointer(Error error, const std::string& options);

/// A finite number, the whole text and nothing else, with a decimal point.
std::optional<double> parse_number(const std::string& text);

}  // namespace planish::job
