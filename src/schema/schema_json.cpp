#include <planish/base/text.hpp>
#include <planish/schema/schema.hpp>

#include <cmath>

// A schema as JSON Schema (draft 2020-12). What that language cannot say, such as the unit of a
// length, stands in keys of its own (cli.md#schema), which other validators ignore.

namespace planish::schema {
namespace {

using Kind = Schema::Kind;

Json schema_value(const Schema& schema);

std::string_view quantity_name(Quantity quantity) {
  return word_of(quantity, {"", "length", "area", "volume", "degrees"});
}

Json limit_json(double limit) {
  return std::floor(limit) == limit ? Json(static_cast<std::int64_t>(limit)) : Json(limit);
}

void add_range(Json& json, const Schema& schema) {
  const Range& range = schema.range;
  if (std::isfinite(range.low))
    json[range.low_too ? "minimum" : "exclusiveMinimum"] = limit_json(range.low);
  if (std::isfinite(range.high))
    json[range.high_too ? "maximum" : "exclusiveMaximum"] = limit_json(range.high);
  if (schema.quantity != Quantity::plain) json["quantity"] = quantity_name(schema.quantity);
}

void add_object(Json& json, const Schema& schema) {
  json["type"] = "object";
  json["properties"] = Json::object();
  Json required = Json::array();
  for (const Field& field : schema.fields) {
    json["properties"][field.key] = schema_value(field.value);
    if (field.required) required.push_back(field.key);
  }
  if (!required.empty()) json["required"] = std::move(required);
  json["additionalProperties"] = false;
  if (schema.kind == Kind::one_key) json["minProperties"] = json["maxProperties"] = 1;
}

void add_parts(Json& json, const Schema& schema) {
  if (schema.kind == Kind::by_key) {
    json["if"]["required"] = Json::array({schema.key});
    json["then"] = schema_value(schema.parts[0]);
    json["else"] = schema_value(schema.parts[1]);
    return;
  }
  json["anyOf"] = Json::array();
  for (const Schema& part : schema.parts)
    json["anyOf"].push_back(schema_value(part));
}

void add_list(Json& json, const Schema& schema) {
  json["type"] = "array";
  json["items"] = schema_value(schema.parts.front());
  if (schema.kind == Kind::tuple) json["minItems"] = json["maxItems"] = schema.count;
  if (schema.least > 0) json["minItems"] = schema.least;
  if (schema.most < std::numeric_limits<std::size_t>::max()) json["maxItems"] = schema.most;
}

void add_kind(Json& json, const Schema& schema) {
  switch (schema.kind) {
    case Kind::number:
    case Kind::whole:
      json["type"] = schema.kind == Kind::number ? "number" : "integer";
      return add_range(json, schema);
    case Kind::text:
      json["type"] = "string";
      if (!schema.may_be_empty) json["minLength"] = 1;
      return;
    case Kind::flag:
      json["type"] = "boolean";
      return;
    case Kind::value:
      json["enum"] = schema.values;
      return;
    case Kind::list:
    case Kind::tuple:
      return add_list(json, schema);
    case Kind::object:
    case Kind::one_key:
      return add_object(json, schema);
    case Kind::map:
      json["type"] = "object";
      json["additionalProperties"] = schema_value(schema.parts.front());
      return;
    case Kind::by_key:
    case Kind::any_of:
      return add_parts(json, schema);
    case Kind::null:
      json["type"] = "null";
      return;
    case Kind::anything:
      return;
  }
}

Json schema_value(const Schema& schema) {
  Json json = Json::object();
  if (!schema.description.empty()) json["description"] = schema.description;
  add_kind(json, schema);
  if (!schema.otherwise.is_null()) json["default"] = schema.otherwise;
  return json;
}

}  // namespace

Json json_schema(const Schema& schema, const std::string& title, const std::string& id) {
  Json json;
  json["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  json["$id"] = id;
  json["title"] = title;
  json.update(schema_value(schema));
  return json;
}

}  // namespace planish::schema
