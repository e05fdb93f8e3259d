#include <planish/schema/schema.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

// The parts that schemas are made of, each with the words that a message says of it: "must be a
// whole number of at least 1". One description serves reading, checking and the printed JSON
// Schema, so they cannot disagree.

namespace planish::schema {
namespace {

using Kind = Schema::Kind;

Schema of_kind(Kind kind, std::string said_as = {}, std::vector<Schema> parts = {}) {
  Schema schema;
  schema.kind = kind;
  schema.words = std::move(said_as);
  schema.parts = std::move(parts);
  return schema;
}

Schema with_fields(Kind kind, std::vector<Field> fields) {
  Schema schema = of_kind(kind, "an object");
  schema.fields = std::move(fields);
  return schema;
}

Schema measured(Schema schema, Quantity quantity) {
  schema.quantity = quantity;
  return schema;
}

}  // namespace

Schema Schema::said(std::string text) const {
  Schema copy = *this;
  copy.description = std::move(text);
  return copy;
}

Schema Schema::defaulting(Json value) const {
  Schema copy = *this;
  copy.otherwise = std::move(value);
  return copy;
}

Schema Schema::or_null() const {
  Schema either = any_of({*this, of_kind(Kind::null, "null")}, words + " or null");
  either.description = description;
  either.parts.front().description.clear();
  return either;
}

Schema Schema::of_length(std::size_t fewest, std::size_t longest, std::string said_as) const {
  Schema copy = *this;
  copy.least = fewest;
  copy.most = longest;
  copy.words = std::move(said_as);
  return copy;
}

const Field* Schema::field(std::string_view name) const {
  const auto found = std::ranges::find(fields, name, &Field::key);
  return found == fields.end() ? nullptr : &*found;
}

Field required(std::string key, Schema value) { return {std::move(key), std::move(value), true}; }
Field optional(std::string key, Schema value) { return {std::move(key), std::move(value), false}; }

Schema number(const Range& range) {
  Schema schema = of_kind(Kind::number, std::string(range.words));
  schema.range = range;
  return schema;
}

Schema length(const Range& range) { return measured(number(range), Quantity::length); }
Schema area() { return measured(number(), Quantity::area); }
Schema volume() { return measured(number(), Quantity::volume); }
Schema angle(const Range& range) { return measured(number(range), Quantity::angle); }

Schema whole(int least, int most) {
  Schema schema = of_kind(Kind::whole);
  schema.range = {"", static_cast<double>(least), static_cast<double>(most)};
  schema.words = most == std::numeric_limits<int>::max()
                     ? fmt::format("a whole number of at least {}", least)
                     : fmt::format("a whole number from {} to {}", least, most);
  return schema;
}

Schema text() { return of_kind(Kind::text, "a text that is not empty"); }

Schema any_text() {
  Schema schema = of_kind(Kind::text, "a text");
  schema.may_be_empty = true;
  return schema;
}

Schema flag() { return of_kind(Kind::flag, "true or false"); }

Schema words(const std::vector<std::string_view>& words) {
  Schema schema = of_kind(Kind::value, fmt::format("one of {}", fmt::join(words, ", ")));
  for (const std::string_view word : words)
    schema.values.emplace_back(std::string(word));
  return schema;
}

Schema values(std::vector<Json> values, std::string said_as) {
  Schema schema = of_kind(Kind::value, std::move(said_as));
  schema.values = std::move(values);
  return schema;
}

Schema list(Schema item) { return of_kind(Kind::list, "a list", {std::move(item)}); }

Schema tuple(std::size_t count, Schema item, std::string said_as) {
  Schema schema = of_kind(Kind::tuple, std::move(said_as), {std::move(item)});
  schema.count = count;
  return schema;
}

Schema object(std::vector<Field> fields) { return with_fields(Kind::object, std::move(fields)); }
Schema one_key(std::vector<Field> fields) { return with_fields(Kind::one_key, std::move(fields)); }
Schema map(Schema value) { return of_kind(Kind::map, "an object", {std::move(value)}); }

Schema by_key(std::string key, Schema with, Schema without) {
  Schema schema = of_kind(Kind::by_key, "an object", {std::move(with), std::move(without)});
  schema.key = std::move(key);
  return schema;
}

Schema any_of(std::vector<Schema> parts, std::string said_as) {
  return of_kind(Kind::any_of, std::move(said_as), std::move(parts));
}

Schema anything() { return of_kind(Kind::anything, "anything"); }

Schema space_point(const Range& each) { return tuple(3, length(each), "a point [x, y, z]"); }
Schema space_direction() { return tuple(3, number(), "a direction [x, y, z]"); }
Schema plane_point(const Range& each) { return tuple(2, length(each), "a point [x, y]"); }

Schema units() {
  return words({"mm", "inch", "m"}).defaulting("mm").said("what all lengths are given in");
}

std::vector<Field> header_fields(const std::string& format, int version) {
  return {optional("format", values({format}, fmt::format("\"{}\"", format))),
          optional("version", values({version}, fmt::format("{}", version)))};
}

}  // namespace planish::schema
