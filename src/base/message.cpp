// Templates are filled by name. A sentence names a place or states a number only through a fact, so
// whatever it names is there as data too: that is what lets front ends leave the sentence alone.

#include <planish/base/message.hpp>
#include <planish/base/result.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace planish {
namespace {

/// What stands between braces: "@bend", "radius:6", "count:body/bodies".
struct Slot {
  bool is_place = false;
  std::string_view name;
  std::string_view format;
};

Slot slot_of(std::string_view inside) {
  Slot slot;
  slot.is_place = inside.starts_with('@');
  if (slot.is_place) inside.remove_prefix(1);
  const std::size_t colon = inside.find(':');
  slot.name = inside.substr(0, colon);
  if (colon != std::string_view::npos) slot.format = inside.substr(colon + 1);
  return slot;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string counted(double count, std::string_view noun) {
  const std::size_t slash = noun.find('/');
  const std::string one(noun.substr(0, slash));
  const std::string many = slash == std::string_view::npos ? one + "s"
                                                           : std::string(noun.substr(slash + 1));
  return fmt::format("{} {}", number_text(count, 12), count == 1.0 ? one : many);
}

std::string quantity_text(const Quantity& quantity, std::string_view format) {
  constexpr int kDigits = 4;
  if (!format.empty() && !is_digit(format.front())) return counted(quantity.value, format);
  const bool whole = quantity.unit.empty() && std::trunc(quantity.value) == quantity.value;
  const int digits = !format.empty() ? std::atoi(std::string(format).c_str())
                     : whole         ? 12
                                     : kDigits;
  const char* space = quantity.unit.empty() || quantity.unit == unit::degrees ? "" : " ";
  return fmt::format("{}{}{}", number_text(quantity.value, digits), space, quantity.unit);
}

std::string places_text(const std::vector<const Place*>& places) {
  if (places.size() == 1) return text_of(*places.front());
  std::vector<std::string> names;
  const PlaceKind kind = places.front()->kind;
  const bool alike = kind != PlaceKind::point && kind != PlaceKind::pointer &&
                     std::ranges::all_of(places, [&](const Place* p) { return p->kind == kind; });
  for (const Place* place : places)
    names.push_back(alike ? id_text(*place) : text_of(*place));
  return alike ? fmt::format("{}s {}", kind_name(kind), listed(names)) : listed(names);
}

std::optional<std::string> text_in(const Slot& slot, const Facts& facts) {
  std::vector<const Place*> places;
  std::vector<std::string> texts;
  for (const Fact& fact : facts) {
    if (fact.name() != slot.name) continue;
    if (fact.place()) places.push_back(fact.place());
    if (fact.quantity()) texts.push_back(quantity_text(*fact.quantity(), slot.format));
    if (fact.words()) texts.push_back(*fact.words());
  }
  if (slot.is_place) return places.empty() ? std::nullopt : std::optional(places_text(places));
  return texts.empty() ? std::nullopt : std::optional(listed(texts));
}

std::string filled(std::string_view pattern, const Facts& facts) {
  std::string text;
  for (std::size_t at = 0; at < pattern.size();) {
    const std::size_t open = pattern.find('{', at);
    const std::size_t close = pattern.find('}', open == std::string_view::npos ? at : open);
    if (open == std::string_view::npos || close == std::string_view::npos)
      return text.append(pattern.substr(at));
    text.append(pattern.substr(at, open - at));
    const Slot slot = slot_of(pattern.substr(open + 1, close - open - 1));
    const auto filling = text_in(slot, facts);
    text += filling ? *filling : std::string(pattern.substr(open, close - open + 1));
    at = close + 1;
  }
  return text;
}

/// A sentence begins with a capital, whatever its first place is.
std::string sentence(std::string text, std::string_view pattern) {
  if (pattern.starts_with("{@") && !text.empty() && text.front() >= 'a' && text.front() <= 'z')
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

std::string where_of(const std::vector<Place>& places) {
  std::vector<std::string> names;
  for (const Place& place : places) {
    if (place.kind == PlaceKind::pointer) return std::get<std::string>(place.id);
    names.push_back(text_of(place));
  }
  return listed(names);
}

}  // namespace

Told tell(std::string_view pattern, const Facts& facts) {
  Told told{sentence(filled(pattern, facts), pattern), {}, {}};
  for (const Fact& fact : facts) {
    if (fact.place()) told.places.push_back(*fact.place());
    if (fact.quantity()) told.numbers.push_back({std::string(fact.name()), *fact.quantity()});
  }
  return told;
}

std::string number_text(double value, int digits) {
  constexpr double kLeast = 1e-3, kMost = 1e5, kMostWhole = 1e12;  // shown without exponent
  if (value == 0.0) return "0";
  if (!std::isfinite(value)) return fmt::format("{}", value);
  const double size = std::abs(value);
  const bool whole = std::trunc(value) == value && size < kMostWhole;
  if (whole && size >= std::pow(10.0, digits)) return fmt::format("{:.0f}", value);
  std::string text = fmt::format("{:.{}g}", value, digits);
  if (text.find('e') == std::string::npos || size < kLeast || size >= kMost) return text;
  return fmt::format("{:.0f}", std::strtod(text.c_str(), nullptr));
}

std::string listed(std::span<const std::string> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

Error error_of(const Refusal& refusal, const Facts& facts, std::string where) {
  Told told = tell(refusal.pattern, facts);
  Error error{refusal.code, std::move(told.sentence), std::move(where), std::move(told.places),
              std::move(told.numbers)};
  if (error.where.empty()) error.where = where_of(error.places);
  const std::string change = filled(refusal.change, facts);
  if (!change.empty()) error.message += " " + change;
  if (!change.empty() || !refusal.option.empty())
    error.remedies.push_back({std::string(refusal.option), filled(refusal.value, facts), change});
  return error;
}

}  // namespace planish
