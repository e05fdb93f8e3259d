#pragma once

#include <planish/base/message.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/range.hpp>

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planish::schema {

enum class Quantity { plain, length, area, volume, angle };

struct Field;

/// What a JSON value must be. The same description serves the reader, which accepts nothing else,
/// and the JSON Schema that `planish schema` prints. Made by the functions below.
struct Schema {
  enum class Kind {
    anything,
    number,
    whole,    ///< whole number within `range`
    text,     ///< not empty, unless `may_be_empty`
    flag,     ///< true or false
    value,    ///< one of `values`
    list,     ///< of `parts[0]`, `least` to `most`
    tuple,    ///< exactly `count` of `parts[0]`
    object,   ///< `fields` and no others
    one_key,  ///< an object with exactly one of `fields`
    map,      ///< an object with any keys, each for a `parts[0]`
    by_key,   ///< `parts[0]` where the object has `key`, else `parts[1]`
    any_of,   ///< one of `parts`, told apart by their JSON types
    null,
  };
  Kind kind = Kind::anything;
  std::string words;         ///< what it must be, as messages say it: "a point [x, y, z]"
  std::string description;   ///< for people; empty: none
  Json otherwise;            ///< the default; null: none
  Range range = kAnyNumber;  ///< of lengths in mm, whatever the document's unit
  Quantity quantity = Quantity::plain;
  bool may_be_empty = false;
  std::size_t count = 0;
  std::size_t least = 0, most = std::numeric_limits<std::size_t>::max();
  std::string key;
  std::vector<Json> values;
  std::vector<Schema> parts;
  std::vector<Field> fields;

  Schema said(std::string text) const;  ///< with a description
  Schema defaulting(Json value) const;  ///< with a default
  Schema or_null() const;               ///< this, or null
  /// A list that is not of any length; `said_as`: "a list of 2 to 64 poles".
  Schema of_length(std::size_t least, std::size_t most, std::string said_as) const;
  const Field* field(std::string_view name) const;  ///< null if there is none
};

struct Field {
  std::string key;
  Schema value;
  bool required = false;
};

Field required(std::string key, Schema value);
Field optional(std::string key, Schema value);

Schema number(const Range& range = kAnyNumber);
Schema length(const Range& range = kAnyNumber);  ///< in the document's "units"
Schema area();
Schema volume();
Schema angle(const Range& range);  ///< degrees
Schema whole(int least = 0, int most = std::numeric_limits<int>::max());
Schema text();
Schema any_text();  ///< may be empty
Schema flag();
Schema words(const std::vector<std::string_view>& words);
Schema values(std::vector<Json> values, std::string said_as);
Schema list(Schema item);
Schema tuple(std::size_t count, Schema item, std::string said_as);
Schema object(std::vector<Field> fields);
Schema one_key(std::vector<Field> fields);
Schema map(Schema value);
Schema by_key(std::string key, Schema with, Schema without);
Schema any_of(std::vector<Schema> parts, std::string said_as);
Schema anything();
Schema space_point(const Range& each = kAnyNumber);  ///< [x, y, z], lengths
Schema space_direction();                            ///< [x, y, z], numbers
Schema plane_point(const Range& each = kAnyNumber);  ///< [x, y], lengths

/// "format" and "version", with which every Planish file may begin, and "units".
std::vector<Field> header_fields(const std::string& format, int version);
Schema units();

/// The part of `any_of` or `by_key` that applies to `value`; for every other kind the schema
/// itself; null if no part has the value's JSON type.
const Schema* branch_for(const Schema& schema, const Json& value);

/// A rule that a document breaks, and where: "{@field} must be a number above 0, not -1." of a
/// field by its JSON pointer (RFC 6901). What `error_at` needs.
struct Mistake {
  std::string pointer;
  const Refusal* refusal;
  Facts facts;
};
/// The first mistake. `millimetres` is one unit of the document's lengths, which must be finite in
/// mm.
std::optional<Mistake> first_mistake(const Schema& schema, const Json& document,
                                     double millimetres = 1.0);

/// JSON Schema, draft 2020-12; "quantity" beside a number says what it measures.
Json json_schema(const Schema& schema, const std::string& title, const std::string& id);

/// A value as shown in a message; lists and objects may be of any size and depth.
std::string shown(const Json& value);

}  // namespace planish::schema
