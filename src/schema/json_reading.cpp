#include "refusals.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/text.hpp>
#include <planish/schema/fail_at.hpp>
#include <planish/schema/json_depth.hpp>
#include <planish/schema/json_reading.hpp>

#include <set>

// A JSON document that is read through its schema. Parsing and checking happen once, in the
// constructor, and the first mistake is kept; after one every value reads as nothing, so parsers
// need no checks in between. Values that were left out read as their defaults, and lengths come in
// mm. Only keys that the schema has can be read.

namespace planish::schema {
namespace {

constexpr auto kStepMark = "ISO-10303-21;";  // with which every STEP file begins

// Finds a repeated key, of which the parser would silently keep one value.
class RepeatedKeys {
 public:
  bool operator()(Json::parse_event_t event, const Json& value) {
    if (event == Json::parse_event_t::object_start) open_.emplace_back();
    if (event == Json::parse_event_t::object_end) open_.pop_back();
    if (event == Json::parse_event_t::key &&
        !open_.back().insert(value.get<std::string>()).second) {
      if (!first_) first_ = value.get<std::string>();
    }
    return true;
  }
  const std::optional<std::string>& first() const { return first_; }

 private:
  std::vector<std::set<std::string>> open_;
  std::optional<std::string> first_;
};

}  // namespace

JsonReading::JsonReading(const std::string& text, std::string what, std::string name,
                         const Schema& schema)
    : what_(std::move(what)), name_(std::move(name)), schema_(schema) {
  parse(text);
  if (error_) return;
  read_unit();
  if (const auto wrong = first_mistake(schema_, document_, millimetres_in(unit_)))
    mistake(wrong->pointer, *wrong->refusal, wrong->facts);
}

void JsonReading::read_unit() {
  if (!document_.contains("units") || !document_["units"].is_string()) return;
  for (const auto& [word, unit] : unit_words())
    if (document_["units"].get_ref<const std::string&>() == word) unit_ = unit;
}

void JsonReading::parse(const std::string& text) {
  const std::string what = "The " + what_;
  const auto refuse_whole = [&](const Refusal& refusal, Facts facts = {}) {
    facts.emplace_back("what", what);
    error_ = error_of(refusal, facts, name_);
  };
  if (const auto byte = too_deep_at(text)) {
    error_ = too_deep(text, *byte, what, name_ + ":");
    return;
  }
  if (without_byte_order_mark(text).starts_with(kStepMark)) return refuse_whole(refuse::is_step);
  RepeatedKeys repeated;
  try {
    document_ = Json::parse(
        text, [&](int, Json::parse_event_t event, Json& value) { return repeated(event, value); });
  } catch (const Json::parse_error& error) {
    error_ = not_json(text, error.byte, what, name_ + ":");
    return;
  } catch (const Json::exception& error) {
    // The text after the name that the parser gives its error.
    const std::string said = error.what();
    const auto name_end = said.find("] ");
    return refuse_whole(
        refuse::parser_refuses,
        {{"reason", name_end == std::string::npos ? said : said.substr(name_end + 2)}});
  }
  if (repeated.first()) {
    refuse_whole(refuse::repeated_key, {{"key", shortened(*repeated.first())}});
  } else if (!document_.is_object()) {
    refuse_whole(refuse::no_object);
  }
}

void JsonReading::mistake(const std::string& pointer, const Refusal& refusal, Facts facts) {
  if (error_) return;
  error_ = error_at(refusal, pointer, std::move(facts));
  error_->where = name_ + pointer;
  if (!name_.empty()) say_before(*error_, what_ + ": ");
}

JsonPlace JsonPlace::child(const std::string& token, const Schema* schema,
                           const Json* value) const {
  return {reading_, schema, value, pointer_ + "/" + escaped_token(token)};
}

const Json& JsonPlace::content() const {
  static const Json nothing;
  if (reading_->error()) return nothing;
  return given() ? *value_ : schema_->otherwise;
}

const Schema& JsonPlace::branch() const {
  const Schema* branch = given() ? branch_for(*schema_, *value_) : schema_;
  return branch ? *branch : *schema_;
}

JsonPlace JsonPlace::operator[](const std::string& key) const {
  const Schema& own = branch();
  const Field* field = own.field(key);
  // Only keys of the schema may be read, unless the place was left out or the document is invalid.
  PLANISH_ASSERT(field || !given() || reading_->error());
  const bool there = field && given() && !reading_->error() && value_->contains(key);
  return child(key, field ? &field->value : schema_, there ? &(*value_)[key] : nullptr);
}

std::vector<JsonPlace> JsonPlace::items() const {
  std::vector<JsonPlace> all;
  if (!given() || reading_->error()) return all;
  const Schema& item = branch().parts.front();
  all.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i)
    all.push_back(child(std::to_string(i), &item, &(*value_)[i]));
  return all;
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::members() const {
  std::vector<std::pair<std::string, JsonPlace>> all;
  if (!given() || reading_->error()) return all;
  const Schema& own = branch();
  for (const auto& [key, value] : value_->items()) {
    const Field* field = own.field(key);
    all.emplace_back(key, child(key, field ? &field->value : &own.parts.front(), &value));
  }
  return all;
}

double JsonPlace::number() const {
  const Json& value = content();
  return value.is_number() ? value.get<double>() : 0.0;
}

double JsonPlace::length() const { return number() * millimetres_in(reading_->unit()); }

double JsonPlace::coordinate() const {
  constexpr double kFarthest = 1e9;  // mm: beyond, doubles no longer place what is cut
  const double value = length();
  if (std::abs(value) <= kFarthest) return value;
  mistake(refuse::too_far);
  return 0.0;
}

Angle JsonPlace::angle() const { return Angle::degrees(number()); }

int JsonPlace::whole() const { return static_cast<int>(number()); }

std::string JsonPlace::text() const {
  const Json& value = content();
  return value.is_string() ? value.get<std::string>() : std::string();
}

bool JsonPlace::yes() const {
  const Json& value = content();
  return value.is_boolean() && value.get<bool>();
}

Vec3 JsonPlace::point() const {
  const auto xyz = items();
  if (xyz.size() != 3) return Vec3::Zero();
  return {xyz[0].coordinate(), xyz[1].coordinate(), xyz[2].coordinate()};
}

Vec2 JsonPlace::plane_point() const {
  const auto xy = items();
  if (xy.size() != 2) return Vec2::Zero();
  return {xy[0].coordinate(), xy[1].coordinate()};
}

std::optional<Vec3> JsonPlace::direction() const {
  const auto xyz = items();
  if (xyz.size() != 3) return std::nullopt;
  const Vec3 v(xyz[0].number(), xyz[1].number(), xyz[2].number());
  if (!v.isZero(0.0)) return v.stableNormalized();
  mistake(refuse::no_direction);
  return std::nullopt;
}

bool JsonPlace::is_text() const { return content().is_string(); }

bool JsonPlace::is_list() const { return content().is_array(); }

std::optional<double> JsonPlace::maybe_number() const {
  return given() ? std::optional(number()) : std::nullopt;
}

std::optional<double> JsonPlace::maybe_length() const {
  return given() ? std::optional(length()) : std::nullopt;
}

std::optional<Angle> JsonPlace::maybe_angle() const {
  return given() ? std::optional(angle()) : std::nullopt;
}

}  // namespace planish::schema
