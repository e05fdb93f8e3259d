#include "json_reading.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>

namespace planish::job {
namespace {

constexpr std::size_t kShownBytes = 40;  // of a value in a message

// A token of a JSON pointer.
std::string escaped(const std::string& key) {
  std::string text;
  for (const char c : key) {
    if (c == '~')
      text += "~0";
    else if (c == '/')
      text += "~1";
    else
      text += c;
  }
  return text;
}

// Line and column, 1-based, of a byte offset.
std::string position(const std::string& text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const auto last_break = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
  return fmt::format("{}:{}", line, std::max<std::ptrdiff_t>(1, end - last_break));
}

// A parser keeps one of two values under one key and says nothing; the key it happened to, if any.
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

bool holds(const Allowed& allowed, double x) {
  const bool above = allowed.low_too ? x >= allowed.low : x > allowed.low;
  const bool below = allowed.high_too ? x <= allowed.high : x < allowed.high;
  return above && below;
}

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

}  // namespace

JsonReading::JsonReading(const std::string& text, std::string what, std::string name)
    : what_(std::move(what)), name_(std::move(name)) {
  parse(text);
}

void JsonReading::parse(const std::string& text) {
  const auto no_json = [&](const std::string& why, const std::string& place) {
    error_ = Error{ErrorCode::invalid_input, fmt::format("the {} is not JSON: {}", what_, why),
                   name_ + place};
  };
  RepeatedKeys repeated;
  try {
    document_ = Json::parse(
        text, [&](int, Json::parse_event_t event, Json& value) { return repeated(event, value); });
  } catch (const Json::parse_error& error) {
    const std::string place = position(text, error.byte);
    return no_json(fmt::format("mistake at line:column {}", place), ":" + place);
  } catch (const Json::exception& error) {
    // Behind the name that the parser gives its error.
    const std::string said = error.what();
    const auto name_end = said.find("] ");
    return no_json(name_end == std::string::npos ? said : said.substr(name_end + 2), "");
  }
  if (repeated.first()) {
    error_ = Error{ErrorCode::invalid_input,
                   fmt::format("{}: the key \"{}\" stands twice in one object: leave one of them",
                               what_, *repeated.first()),
                   name_};
  } else if (!document_.is_object()) {
    error_ = Error{ErrorCode::invalid_input, fmt::format("the {} must hold one JSON object", what_),
                   name_};
  }
}

void JsonReading::mistake(const std::string& pointer, const std::string& sentence) {
  if (error_) return;
  error_ = Error{ErrorCode::invalid_input, fmt::format("{}: {} {}", what_, pointer, sentence),
                 name_ + pointer};
}

JsonPlace JsonPlace::child(const std::string& token, const Json* value) const {
  return {reading_, value, pointer_ + "/" + escaped(token)};
}

// A value in a message: lists and objects may be of any size and depth.
std::string JsonPlace::shown() const {
  if (value_->is_array()) return "a list";
  if (value_->is_object()) return "an object";
  std::string text = value_->dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > kShownBytes) text = text.substr(0, kShownBytes) + "…";
  return text;
}

void JsonPlace::keys(const std::vector<std::string>& required,
                     const std::vector<std::string>& optional) const {
  if (!given() || reading_->error()) return;
  if (!value_->is_object()) return mistake(fmt::format("must be an object, not {}", shown()));
  for (const auto& [key, value] : value_->items()) {
    if (contains(required, key) || contains(optional, key)) continue;
    std::vector<std::string> known = required;
    known.insert(known.end(), optional.begin(), optional.end());
    return child(key, &value)
        .mistake(fmt::format("is no known key; known here are {}", fmt::join(known, ", ")));
  }
  for (const std::string& key : required) {
    if (!value_->contains(key)) return child(key, nullptr).mistake("is missing");
  }
}

void JsonPlace::format(const std::string& format, int version) const {
  const JsonPlace kind = (*this)["format"];
  if (kind.given() && !kind.is_text(format))
    kind.mistake(fmt::format("must be \"{}\", not {}", format, kind.shown()));
  const JsonPlace number = (*this)["version"];
  if (number.given() && *number.value_ != version)
    number.mistake(fmt::format("must be {}, not {}", version, number.shown()));
}

void JsonPlace::read_unit() const {
  reading_->set_unit((*this)["units"].choice<LengthUnit>(
      {{"mm", LengthUnit::mm}, {"inch", LengthUnit::inch}, {"m", LengthUnit::m}}, LengthUnit::mm));
}

JsonPlace JsonPlace::operator[](const std::string& key) const {
  const bool there = given() && value_->is_object() && value_->contains(key);
  return child(key, there ? &(*value_)[key] : nullptr);
}

std::vector<JsonPlace> JsonPlace::items() const {
  std::vector<JsonPlace> all;
  if (!given() || reading_->error()) return all;
  if (!value_->is_array()) {
    mistake(fmt::format("must be a list, not {}", shown()));
    return all;
  }
  for (std::size_t i = 0; i < value_->size(); ++i)
    all.push_back(child(std::to_string(i), &(*value_)[i]));
  return all;
}

std::vector<JsonPlace> JsonPlace::items(std::size_t n, std::string_view words) const {
  if (!given() || reading_->error()) return {};
  if (!value_->is_array()) {
    mistake(fmt::format("must be {}, not {}", words, shown()));
    return {};
  }
  if (value_->size() == n) return items();
  mistake(fmt::format("must be {}, not a list of {}", words, value_->size()));
  return {};
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::members() const {
  std::vector<std::pair<std::string, JsonPlace>> all;
  if (!given() || reading_->error()) return all;
  if (!value_->is_object()) {
    mistake(fmt::format("must be an object, not {}", shown()));
    return all;
  }
  for (const auto& [key, value] : value_->items())
    all.emplace_back(key, child(key, &value));
  return all;
}

double JsonPlace::scaled(const Allowed& allowed, double scale) const {
  if (!given() || reading_->error()) return 0.0;
  const double value = value_->is_number() ? value_->get<double>() : std::nan("");
  if (std::isfinite(value * scale) && holds(allowed, value)) return value * scale;
  mistake(fmt::format("must be {}, not {}", allowed.words, shown()));
  return 0.0;
}

double JsonPlace::number(const Allowed& allowed) const { return scaled(allowed, 1.0); }

double JsonPlace::length(const Allowed& allowed) const {
  return scaled(allowed, millimetres_in(reading_->unit()));
}

Angle JsonPlace::angle(const Allowed& allowed) const { return Angle::degrees(number(allowed)); }

int JsonPlace::index() const {
  if (!given() || reading_->error()) return 0;
  if (value_->is_number_unsigned() &&
      value_->get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<int>::max())) {
    return value_->get<int>();
  }
  mistake(fmt::format("must be a whole number of at least 0, not {}", shown()));
  return 0;
}

Vec3 JsonPlace::point() const {
  const auto xyz = items(3, "a point [x, y, z]");
  if (xyz.empty()) return Vec3::Zero();
  return {xyz[0].length(), xyz[1].length(), xyz[2].length()};
}

std::optional<Vec3> JsonPlace::direction() const {
  if (!given()) return std::nullopt;
  const auto xyz = items(3, "a direction [x, y, z]");
  if (xyz.empty()) return std::nullopt;
  const Vec3 v(xyz[0].number(), xyz[1].number(), xyz[2].number());
  if (v.norm() > 0.0) return v.normalized();
  mistake("is [0, 0, 0], which is no direction");
  return std::nullopt;
}

std::string JsonPlace::text() const {
  if (!given() || reading_->error()) return {};
  if (value_->is_string() && !value_->get_ref<const std::string&>().empty())
    return value_->get<std::string>();
  mistake(fmt::format("must be a text that is not empty, not {}", shown()));
  return {};
}

bool JsonPlace::yes() const {
  if (!given() || reading_->error()) return false;
  if (value_->is_boolean()) return value_->get<bool>();
  mistake(fmt::format("must be true or false, not {}", shown()));
  return false;
}

std::optional<double> JsonPlace::maybe_number(const Allowed& allowed) const {
  return given() ? std::optional(number(allowed)) : std::nullopt;
}

std::optional<double> JsonPlace::maybe_length(const Allowed& allowed) const {
  return given() ? std::optional(length(allowed)) : std::nullopt;
}

std::optional<Angle> JsonPlace::maybe_angle(const Allowed& allowed) const {
  return given() ? std::optional(angle(allowed)) : std::nullopt;
}

bool JsonPlace::is_text(std::string_view text) const {
  return value_->is_string() && value_->get_ref<const std::string&>() == text;
}

bool JsonPlace::is_list() const { return given() && value_->is_array(); }

void JsonPlace::not_among(const std::vector<std::string_view>& words) const {
  mistake(fmt::format("must be one of {}, not {}", fmt::join(words, ", "), shown()));
}

}  // namespace planish::job
