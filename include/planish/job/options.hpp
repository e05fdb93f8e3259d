#pragma once

#include <planish/base/result.hpp>
#include <planish/job/option_value.hpp>
#include <planish/job/request.hpp>
#include <planish/schema/range.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
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

/// What options are about. In the help each has a heading.
enum class OptionGroup {
  none,
  input,
  output,
  shop,
  bends,
  joining,
  forms,
  corners,
  dxf,  ///< how a DXF is written, not what is made
  checks,
  brake,
  order,
};
/// "Press brake"; empty for `none`.
std::string_view heading(OptionGroup group);

/// An option of a request, with the same name everywhere: `name` is its key in requests; on the
/// command line it follows "--", with "-" for "_".
struct Option {
  std::string_view name;
  OptionKind kind;
  OptionGroup group = OptionGroup::none;
  std::string_view description;     ///< one line, without the default
  std::string_view otherwise = {};  ///< the default in words; empty: see `OptionUse`, or none
  schema::Range range = schema::kAnyNumber;
  std::vector<std::string_view> words = {};
  std::string_view file_type = {};  ///< "FILE.csv"
  std::string_view file_kind = {};  ///< what a file is called in messages: "bend table"
  bool on_command_line = true;
  /// Stores a value of the option's kind in the request; null: it is stored in `Request::own`.
  /// Errors: `invalid_input` for the content of files.
  Result<void> (*set)(Request& request, const OptionValue& value) = nullptr;
};

/// An option that a maker takes, and its default in words if the maker sets one.
struct OptionUse {
  std::string_view name;
  std::string_view otherwise = {};
  const Option* own = nullptr;  ///< its entry, if no other maker has it: it is not in `options()`

  const Option& entry() const;
};

/// Every option that several makers share, or that the program knows, in the order of the help.
std::span<const Option> options();
/// The option of that name, which must exist.
const Option& option(std::string_view name);

/// Values that were given, in any order.
class OptionValues {
 public:
  /// Sets a value given as text on a command line; for `by_bend` "B1=0.4", which is added to
  /// earlier ones. Flags take "true" and "false". Files are not read yet. Errors: `bad_option`,
  /// saying what the value must be; `where` is the option's name.
  Result<void> set_text(const Option& option, const std::string& text);
  void set(const Option& option, OptionValue value);

  bool given(std::string_view name) const;
  /// The text of a word, face, name or path; empty if not given.
  std::string text(std::string_view name) const;
  std::optional<double> number(std::string_view name) const;
  std::span<const std::pair<const Option*, OptionValue>> all() const { return values_; }

  /// From now on texts are no paths: nothing that `enter` finds is read from the disk.
  void read_no_files() { reads_files_ = false; }

  /// Checks options that are each valid but may contradict one another. Errors: `bad_option`,
  /// option names in backquotes; `where` is the name of one.
  Result<void> check_together() const;
  /// Stores all values in a request and reads the files whose paths were given. Errors: those of
  /// `check_together`; `cannot_read`, `invalid_input` with the place in the file, or for content
  /// given inline with the place in the option, "rules/content/k_low".
  Result<void> enter(Request& request) const;

 private:
  std::vector<std::pair<const Option*, OptionValue>> values_;
  bool reads_files_ = true;
};

/// The option that a place belongs to, "bend_k" of "bend_k/B99"; null if it belongs to none.
const Option* option_at(std::string_view where);

/// The error of a request whose options are at a JSON pointer: the place "bend_k/B99" becomes
/// "/options/bend_k/B99"; places that belong to no option stay.
Error at_pointer(Error error, const std::string& options);

/// The finite number that the whole text spells, with a decimal point; empty otherwise.
std::optional<double> parse_number(const std::string& text);

}  // namespace planish::job
