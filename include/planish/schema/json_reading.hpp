#pragma once

#include <planish/base/angle.hpp>
#include <planish/base/id_vector.hpp>
#include <planish/base/length_unit.hpp>
#include <planish/base/result.hpp>
#include <planish/geometry/frame.hpp>
#include <planish/schema/schema.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planish::schema {

/// Words of a JSON document, each standing for a value: the schema accepts them, the reader
/// converts them.
template <typename T>
using Words = std::vector<std::pair<std::string_view, T>>;

template <typename T>
Schema words(const Words<T>& meanings) {
  const auto known = mapped(meanings, [&](const auto& row) { return row.first; });
  return words(known);
}

inline const Words<LengthUnit>& unit_words() {
  static const Words<LengthUnit> words{
      {"mm", LengthUnit::mm}, {"inch", LengthUnit::inch}, {"m", LengthUnit::m}};
  return words;
}

/// A JSON document checked against its schema. Its values are read place by place; the first
/// mistake is kept, and values read from an invalid document are empty or zero.
class JsonReading {
 public:
  /// `what` names the file's kind in messages ("plates file"), `name` the file itself. `schema`
  /// must outlive the reading.
  JsonReading(const std::string& text, std::string what, std::string name, const Schema& schema);
  JsonReading(const JsonReading&) = delete;
  JsonReading& operator=(const JsonReading&) = delete;

  /// `invalid_input`: `where` is name:line:column for text that is not JSON or nested too deep,
  /// else name and JSON pointer. Empty if there is no mistake.
  const std::optional<Error>& error() const { return error_; }

  const Json& document() const { return document_; }
  const Schema& schema() const { return schema_; }
  /// The unit of the file's lengths: its "units", else mm.
  LengthUnit unit() const { return unit_; }

  /// Records a mistake: "<what>: <sentence>" of a file, the sentence alone of what has no name.
  /// The sentence calls the place `field`.
  void mistake(const std::string& pointer, const Refusal& refusal, Facts facts = {});

 private:
  void parse(const std::string& text);
  void read_unit();

  std::string what_, name_;
  const Schema& schema_;
  Json document_;
  LengthUnit unit_ = LengthUnit::mm;
  std::optional<Error> error_;
};

/// A value in a checked document, with its schema and its JSON pointer (RFC 6901); it may have been
/// left out. The reading must outlive it.
class JsonPlace {
 public:
  /// The whole document.
  explicit JsonPlace(JsonReading& reading)
      : reading_(&reading), schema_(&reading.schema()), value_(&reading.document()) {}

  const std::string& pointer() const { return pointer_; }
  bool given() const { return value_ != nullptr; }
  /// Records a mistake about this place, which the sentence calls `field`.
  void mistake(const Refusal& refusal, Facts facts = {}) const {
    reading_->mistake(pointer_, refusal, std::move(facts));
  }

  /// The value under a key that the schema knows.
  JsonPlace operator[](const std::string& key) const;
  /// The elements of a list; none if it was left out.
  std::vector<JsonPlace> items() const;
  /// Keys and values of an object, in the order of the file.
  std::vector<std::pair<std::string, JsonPlace>> members() const;

  /// The value, or the schema's default if it was left out.
  double number() const;
  double length() const;
  /// A length of a point, mm; a mistake beyond 1,000 km.
  double coordinate() const;  ///< mm, from the file's unit
  Angle angle() const;        ///< from degrees
  int whole() const;
  std::string text() const;
  bool yes() const;
  Vec3 point() const;        ///< [x, y, z] in mm
  Vec2 plane_point() const;  ///< [x, y] in mm
  /// [x, y, z], normalised; empty if it was left out. [0, 0, 0] is a mistake.
  std::optional<Vec3> direction() const;
  bool is_text() const;
  bool is_list() const;
  const Json& json() const { return *value_; }

  /// The same; empty if it was left out.
  std::optional<double> maybe_number() const;
  std::optional<double> maybe_length() const;
  std::optional<Angle> maybe_angle() const;

  /// The value that the word stands for.
  template <typename T>
  T choice(const Words<T>& words) const {
    const std::string word = text();
    for (const auto& [known, value] : words)
      if (known == word) return value;
    return words.front().second;
  }

 private:
  JsonPlace(JsonReading* reading, const Schema* schema, const Json* value, std::string pointer)
      : reading_(reading), schema_(schema), value_(value), pointer_(std::move(pointer)) {}
  JsonPlace child(const std::string& token, const Schema* schema, const Json* value) const;
  /// The value or the default; null for neither, and in an invalid document.
  const Json& content() const;
  /// The schema of the value, chosen among alternatives.
  const Schema& branch() const;

  JsonReading* reading_;
  const Schema* schema_;
  const Json* value_;
  std::string pointer_;
};

}  // namespace planish::schema
