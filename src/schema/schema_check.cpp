#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/schema/schema.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

// The first mistake in a JSON value, found depth first, with its pointer. Where a schema has
// branches, the value chooses one by its type or key and only that one complains, so the message
// fits what was meant. Unknown keys are told before missing ones, because a misspelt key is why
// another is missing. Limits of lengths are in mm, values in the unit of the file.

namespace planish::schema {
namespace {

using Kind = Schema::Kind;

constexpr std::size_t kShownBytes = 40;  // of a value in a message

/// JSON has one type of numbers: 1, 1.0 and -1 are kept differently, and are not told apart.
bool same_type(const Json& a, const Json& b) {
  return a.is_number() ? b.is_number() : a.type() == b.type();
}

/// Whether a value is of the JSON type that a schema asks for, whatever else the schema says.
bool is_of_type(const Schema& schema, const Json& value) {
  switch (schema.kind) {
    case Kind::anything:
      return true;
    case Kind::number:
    case Kind::whole:
      return value.is_number();
    case Kind::text:
      return value.is_string();
    case Kind::flag:
      return value.is_boolean();
    case Kind::value:
      return std::ranges::any_of(schema.values,
                                 [&](const Json& one) { return same_type(one, value); });
    case Kind::list:
    case Kind::tuple:
      return value.is_array();
    case Kind::object:
    case Kind::one_key:
    case Kind::map:
    case Kind::by_key:
      return value.is_object();
    case Kind::any_of:
      return std::ranges::any_of(schema.parts,
                                 [&](const Schema& part) { return is_of_type(part, value); });
    case Kind::null:
      break;
  }
  return value.is_null();
}

/// Looks for the first mistake; the keys on the way to the current value form its pointer.
class Check {
 public:
  explicit Check(double millimetres) : millimetres_(millimetres) {}

  bool passes(const Schema& schema, const Json& value) {
    const Schema* branch = branch_for(schema, value);
    if (!branch) return must_be(schema, value);
    switch (branch->kind) {
      case Kind::number:
      case Kind::whole:
        return is_number_of(*branch, value) || must_be(*branch, value);
      case Kind::text:
        return is_text_of(*branch, value) || must_be(*branch, value);
      case Kind::flag:
      case Kind::null:
        return is_of_type(*branch, value) || must_be(*branch, value);
      case Kind::value:
        return std::ranges::count(branch->values, value) > 0 || must_be(*branch, value);
      case Kind::list:
      case Kind::tuple:
        return list_passes(*branch, value);
      case Kind::object:
      case Kind::one_key:
        return object_passes(*branch, value);
      case Kind::map:
        return map_passes(*branch, value);
      default:
        return true;
    }
  }

  const std::optional<Mistake>& mistake() const { return mistake_; }

 private:
  bool is_number_of(const Schema& schema, const Json& value) const {
    if (!value.is_number()) return false;
    const double x = value.get<double>();
    const double scale = schema.quantity == Quantity::length ? millimetres_ : 1.0;
    if (!std::isfinite(x * scale) || !schema.range.holds(x * scale)) return false;
    return schema.kind == Kind::number || std::floor(x) == x;
  }

  static bool is_text_of(const Schema& schema, const Json& value) {
    return value.is_string() &&
           (schema.may_be_empty || !value.get_ref<const std::string&>().empty());
  }

  bool list_passes(const Schema& schema, const Json& value) {
    const bool tuple = schema.kind == Kind::tuple;
    if (!value.is_array())
      return tuple ? must_be(schema, value)
                   : wrong(refuse::must_be_list, {{"value", shown(value)}});
    if (tuple ? value.size() != schema.count
              : value.size() < schema.least || value.size() > schema.most)
      return wrong(refuse::wrong_length, {{"wanted", schema.words}, {"count", value.size()}});
    for (std::size_t i = 0; i < value.size(); ++i)
      if (!child_passes(std::to_string(i), schema.parts.front(), value[i])) return false;
    return true;
  }

  bool map_passes(const Schema& schema, const Json& value) {
    if (!value.is_object()) return must_be(schema, value);
    for (const auto& [key, one] : value.items())
      if (!child_passes(key, schema.parts.front(), one)) return false;
    return true;
  }

  // Unknown keys first: a misspelt key is why another is missing.
  bool object_passes(const Schema& schema, const Json& value) {
    if (!value.is_object()) return must_be(schema, value);
    for (const auto& [key, one] : value.items())
      if (!schema.field(key)) return unknown_key(schema, key);
    for (const Field& field : schema.fields)
      if (field.required && !value.contains(field.key))
        return wrong_below(field.key, refuse::key_missing);
    if (schema.kind == Kind::one_key && value.size() != 1)
      return wrong(refuse::must_be_one_of, keys_of(schema));
    for (const Field& field : schema.fields)
      if (value.contains(field.key) && !child_passes(field.key, field.value, value[field.key]))
        return false;
    return true;
  }

  static Facts keys_of(const Schema& schema) {
    std::vector<std::string> all;
    for (const bool required : {true, false})  // required keys are reported first
      for (const Field& field : schema.fields)
        if (field.required == required) all.push_back(field.key);
    return {{"keys", fmt::format("{}", fmt::join(all, ", "))}};
  }

  bool unknown_key(const Schema& schema, const std::string& key) {
    return wrong_below(key, refuse::unknown_key, keys_of(schema));
  }

  bool child_passes(const std::string& token, const Schema& schema, const Json& value) {
    tokens_.push_back(token);
    if (!passes(schema, value)) return false;
    tokens_.pop_back();
    return true;
  }

  bool must_be(const Schema& schema, const Json& value) {
    return wrong(refuse::must_be, {{"wanted", schema.words}, {"value", shown(value)}});
  }

  bool wrong_below(const std::string& token, const Refusal& refusal, Facts facts = {}) {
    tokens_.push_back(token);
    return wrong(refusal, std::move(facts));
  }

  bool wrong(const Refusal& refusal, Facts facts) {
    std::string pointer;
    for (const std::string& token : tokens_)
      pointer += "/" + escaped_token(token);
    mistake_ = Mistake{std::move(pointer), &refusal, std::move(facts)};
    return false;
  }

  double millimetres_;
  std::vector<std::string> tokens_;
  std::optional<Mistake> mistake_;
};

}  // namespace

const Schema* branch_for(const Schema& schema, const Json& value) {
  if (schema.kind == Kind::by_key)
    return branch_for(schema.parts[value.is_object() && value.contains(schema.key) ? 0 : 1], value);
  if (schema.kind != Kind::any_of) return &schema;
  for (const Schema& part : schema.parts)
    if (is_of_type(part, value)) return branch_for(part, value);
  return nullptr;
}

std::optional<Mistake> first_mistake(const Schema& schema, const Json& document,
                                     double millimetres) {
  Check check(millimetres);
  check.passes(schema, document);
  return check.mistake();
}

std::string shown(const Json& value) {
  if (value.is_array()) return "a list";
  if (value.is_object()) return "an object";
  return shortened(value.dump(-1, ' ', false, Json::error_handler_t::replace), kShownBytes);
}

}  // namespace planish::schema
