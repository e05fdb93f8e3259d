#pragma once

#include "json_parts.hpp"

#include <planish/base/angle.hpp>
#include <planish/base/result.hpp>
#include <planish/geometry/frame.hpp>
#include <planish/io/flat_writers.hpp>

#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planish::job {

/// Numbers that are allowed, and how a message says so.
struct Allowed {
  std::string_view words;  ///< "a number above 0"
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_too = true, high_too = true;  ///< the limits themselves
};
inline constexpr Allowed kAnyNumber{"a number"};
inline constexpr Allowed kAtLeastZero{"a number of at least 0", 0.0};
inline constexpr Allowed kAboveZero{"a number above 0", 0.0,
                                    std::numeric_limits<double>::infinity(), false};
inline constexpr Allowed kShare{"a number from 0 to 1", 0.0, 1.0};

/// A JSON document while it is read. The first mistake stays, and what is read after it is empty or
/// zero, so that whoever reads asks for one thing after the other and looks for `error` at the end.
class JsonReading {
 public:
  /// `what` names the file's kind in messages ("plates file"), `name` the file itself.
  JsonReading(const std::string& text, std::string what, std::string name);
  JsonReading(const JsonReading&) = delete;
  JsonReading& operator=(const JsonReading&) = delete;

  /// `invalid_input`: `where` is name:line:column for text that is no JSON, else name and JSON
  /// pointer. None: all was well so far.
  const std::optional<Error>& error() const { return error_; }

  const Json& document() const { return document_; }
  /// What the file's lengths are given in; mm until `read_unit`.
  LengthUnit unit() const { return unit_; }
  void set_unit(LengthUnit unit) { unit_ = unit; }

  /// Enters a mistake: "<what>: <pointer> <sentence>".
  void mistake(const std::string& pointer, const std::string& sentence);

 private:
  void parse(const std::string& text);

  std::string what_, name_;
  Json document_;
  LengthUnit unit_ = LengthUnit::mm;
  std::optional<Error> error_;
};

/// A value in a document and its JSON pointer (RFC 6901); maybe one that is not there. The reading
/// must outlive it.
class JsonPlace {
 public:
  /// The whole document.
  explicit JsonPlace(JsonReading& reading) : reading_(&reading), value_(&reading.document()) {}

  const std::string& pointer() const { return pointer_; }
  bool given() const { return value_ != nullptr; }
  /// Enters a mistake about this place: "/plates/2/id" + " " + sentence.
  void mistake(const std::string& sentence) const { reading_->mistake(pointer_, sentence); }

  /// The value must be an object with all of the required keys and no others but the optional ones.
  void keys(const std::vector<std::string>& required,
            const std::vector<std::string>& optional = {}) const;
  /// Keys "format" and "version", where they are given, must be these.
  void format(const std::string& format, int version) const;
  /// Key "units": "mm", "inch" or "m", for all lengths read from then on; mm where it is missing.
  void read_unit() const;

  /// The value under a key; not given where the key is missing.
  JsonPlace operator[](const std::string& key) const;
  /// The elements of a list; a list is asked for. None of a place that is not given.
  std::vector<JsonPlace> items() const;
  /// A list of exactly n elements; empty for any other, which is a mistake. `words` says what the
  /// list is: "a point [x, y, z]".
  std::vector<JsonPlace> items(std::size_t n, std::string_view words) const;
  /// Keys and values of an object, in the order of the file.
  std::vector<std::pair<std::string, JsonPlace>> members() const;

  double number(const Allowed& allowed = kAnyNumber) const;
  /// Millimetres, from the file's unit.
  double length(const Allowed& allowed = kAnyNumber) const;
  /// From degrees.
  Angle angle(const Allowed& allowed = kAnyNumber) const;
  /// A whole number of at least 0.
  int index() const;
  /// [x, y, z] in millimetres; zero for a mistake.
  Vec3 point() const;
  /// [x, y, z], made one long; none where the place is not given, or for a mistake.
  std::optional<Vec3> direction() const;
  std::string text() const;  ///< not empty
  bool yes() const;          ///< true or false
  /// Whether it is this text, or a list; anything else is no mistake.
  bool is_text(std::string_view text) const;
  bool is_list() const;

  /// The same, none where the place is not given.
  std::optional<double> maybe_number(const Allowed& allowed = kAnyNumber) const;
  std::optional<double> maybe_length(const Allowed& allowed = kAnyNumber) const;
  std::optional<Angle> maybe_angle(const Allowed& allowed = kAnyNumber) const;

  /// One of several words, each standing for a value; `otherwise` where the place is not given.
  template <typename T>
  T choice(const std::vector<std::pair<std::string_view, T>>& words, T otherwise) const {
    if (!given()) return otherwise;
    std::vector<std::string_view> known;
    for (const auto& [word, value] : words) {
      if (is_text(word)) return value;
      known.push_back(word);
    }
    not_among(known);
    return otherwise;
  }

 private:
  JsonPlace(JsonReading* reading, const Json* value, std::string pointer)
      : reading_(reading), value_(value), pointer_(std::move(pointer)) {}
  JsonPlace child(const std::string& token, const Json* value) const;
  std::string shown() const;
  void not_among(const std::vector<std::string_view>& words) const;
  double scaled(const Allowed& allowed, double scale) const;

  JsonReading* reading_;
  const Json* value_;
  std::string pointer_;
};

}  // namespace planish::job
