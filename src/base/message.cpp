// Templates are filled by name. A sentence names a place or states a number only through a fact, so
// whatever it names is there as data too: that is what lets front ends leave the sentence alone.

#include <planish/base/message.hpp>
#include <planish/base/result.hpp>
#include <planish/base/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

/// A text and what it names; a template with its slots filled.
struct Filled {
  std::string text;
  std::vector<Named> named = {};
};

constexpr int kShownDigits = 4;

/// As `named` shows its quantity, with the value and unit of another.
std::string quantity_text(const Named& named, const Quantity& quantity) {
  if (!named.shows_unit) return number_text(quantity.value, named.digits);
  const char* space = quantity.unit.empty() || quantity.unit == unit::degrees ? "" : " ";
  return fmt::format("{}{}{}", number_text(quantity.value, named.digits), space, quantity.unit);
}

Filled filled(const Quantity& quantity, std::string_view format) {
  const bool bare = format == "number", digits = !format.empty() && is_digit(format.front());
  if (!format.empty() && !digits && !bare) return {counted(quantity.value, format)};
  const bool whole = quantity.unit.empty() && std::trunc(quantity.value) == quantity.value;
  Named named{.quantity = quantity, .shows_unit = !bare};
  named.digits = digits ? std::atoi(std::string(format).c_str()) : whole ? 12 : kShownDigits;
  named.text = quantity_text(named, quantity);
  Filled filling{named.text};
  if (!quantity.unit.empty()) filling.named.push_back(std::move(named));
  return filling;
}

/// A quantity of lengths in another unit; any other as it is.
Quantity in_unit(const Quantity& quantity, LengthUnit unit) {
  using Spellings = std::array<std::string_view, 3>;  // of the length, its square and its cube
  constexpr Spellings kMillimetres{unit::mm, unit::mm2, unit::mm3}, kInches{"in", "in²", "in³"},
      kMetres{"m", "m²", "m³"};
  const auto found = std::ranges::find(kMillimetres, quantity.unit);
  if (found == kMillimetres.end() || unit == LengthUnit::mm) return quantity;
  const auto power = found - kMillimetres.begin();
  const Spellings& spelled = unit == LengthUnit::inch ? kInches : kMetres;
  return {quantity.value / std::pow(millimetres_in(unit), power + 1), spelled.at(power)};
}

/// A part of a sentence in another unit; nothing if it has none.
std::optional<std::string> in_unit(const Named& named, LengthUnit unit) {
  if (named.quantity) return quantity_text(named, in_unit(*named.quantity, unit));
  if (named.place.kind != PlaceKind::point || named.place.at.empty()) return std::nullopt;
  Place point = named.place;
  for (double& x : point.at)
    x /= millimetres_in(unit);
  return text_of(point);
}

std::string places_text(const std::vector<const Place*>& places, std::string_view format) {
  const bool bare = format == "id";
  if (places.size() == 1) return bare ? id_text(*places.front()) : text_of(*places.front());
  std::vector<std::string> names;
  const PlaceKind kind = places.front()->kind;
  const bool alike = kind != PlaceKind::point && kind != PlaceKind::pointer &&
                     std::ranges::all_of(places, [&](const Place* p) { return p->kind == kind; });
  for (const Place* place : places)
    names.push_back(alike || bare ? id_text(*place) : text_of(*place));
  const std::string many = kind == PlaceKind::body ? "bodies" : fmt::format("{}s", kind_name(kind));
  return alike && !bare ? fmt::format("{} {}", many, listed(names)) : listed(names);
}

/// With the names in it moved to behind `before`.
void append_named(std::vector<Named>& to, const std::vector<Named>& named, std::size_t before) {
  for (Named one : named) {
    one.at += before;
    to.push_back(std::move(one));
  }
}

std::string_view between(std::size_t i, std::size_t count) {
  return i == 0 ? "" : i + 1 == count ? " and " : ", ";
}

Filled list_of(const std::vector<Filled>& all) {
  Filled list;
  for (std::size_t i = 0; i < all.size(); ++i) {
    list.text += between(i, all.size());
    append_named(list.named, all[i].named, list.text.size());
    list.text += all[i].text;
  }
  return list;
}

std::optional<Filled> filled(const Slot& slot, const Facts& facts) {
  std::vector<const Place*> places;
  std::vector<Filled> texts;
  for (const Fact& fact : facts) {
    if (fact.name() != slot.name) continue;
    if (fact.place()) places.push_back(fact.place());
    if (fact.quantity()) texts.push_back(filled(*fact.quantity(), slot.format));
    if (fact.words()) texts.push_back({fact.words()->sentence, fact.words()->named});
  }
  if (!slot.is_place) return texts.empty() ? std::nullopt : std::optional(list_of(texts));
  if (places.empty()) return std::nullopt;
  Filled filling{places_text(places, slot.format)};
  if (places.size() == 1) filling.named.push_back({0, filling.text, {}, *places.front()});
  return filling;
}

class Filling {
 public:
  explicit Filling(const Facts& facts) : facts_(facts) {}

  Filled fill(std::string_view pattern) && {
    for (std::size_t at = 0; at < pattern.size();) {
      const std::size_t mark = std::min(pattern.find_first_of("{`", at), pattern.size());
      text_.append(pattern.substr(at, mark - at));
      at = mark == pattern.size() ? mark : pattern[mark] == '`' ? tick(mark) : slot(pattern, mark);
    }
    return {std::move(text_), std::move(named_)};
  }

 private:
  /// A backtick opens the name of an option or closes it.
  std::size_t tick(std::size_t at) {
    constexpr std::string_view kOfOptions = "abcdefghijklmnopqrstuvwxyz_0123456789";
    text_ += '`';
    if (!open_) {
      open_ = text_.size() - 1;
      return at + 1;
    }
    const std::string quoted = text_.substr(*open_);
    const std::string name = quoted.substr(1, quoted.size() - 2);
    if (!name.empty() && name.find_first_not_of(kOfOptions) == std::string::npos)
      named_.push_back({*open_, quoted, name});
    open_.reset();
    return at + 1;
  }

  std::size_t slot(std::string_view pattern, std::size_t open) {
    const std::size_t close = std::min(pattern.find('}', open), pattern.size() - 1);
    const Slot slot = slot_of(pattern.substr(open + 1, close - open - 1));
    const auto filling = filled(slot, facts_);
    if (filling) append_named(named_, filling->named, text_.size());
    text_ += filling ? filling->text : std::string(pattern.substr(open, close - open + 1));
    return close + 1;
  }

  const Facts& facts_;
  std::string text_;
  std::vector<Named> named_;
  std::optional<std::size_t> open_;  // backtick
};

Filled filled(std::string_view pattern, const Facts& facts) { return Filling(facts).fill(pattern); }

/// Whether a part still stands where it was; not where someone has written the sentence anew.
bool stands(const Named& named, std::string_view text) {
  return named.at <= text.size() && text.substr(named.at, named.text.size()) == named.text;
}

/// Spells parts of a sentence in another way, where `spelled` knows one.
template <typename Spell>
void respell(std::string& sentence, std::vector<Named>& all, const Spell& spelled) {
  std::size_t grown = 0;  // of the sentence so far; may wrap, and back again
  for (Named& named : all) {
    named.at += grown;
    const std::optional<std::string> text = spelled(named);
    if (!text) continue;
    sentence.replace(named.at, named.text.size(), *text);
    grown += text->size() - named.text.size();
    named.text = *text;
  }
}

/// A sentence begins with a capital, whatever its first place is.
std::string sentence(std::string text, std::string_view pattern) {
  return pattern.starts_with("{@") ? capitalized(std::move(text)) : text;
}

std::vector<Piece> pieces_of(std::string_view text, const std::vector<Named>& all) {
  std::vector<Piece> pieces;
  std::size_t done = 0;
  const auto plain_until = [&](std::size_t at) {
    if (at > done) pieces.push_back({std::string(text.substr(done, at - done))});
    done = at;
  };
  for (const Named& named : all) {
    if (named.quantity || named.at < done || !stands(named, text)) continue;
    plain_until(named.at);
    done += named.text.size();
    pieces.push_back({named.text, named.option});
    if (named.option.empty()) pieces.back().place = named.place;
  }
  plain_until(text.size());
  return pieces;
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

std::string flag_of(std::string_view option) {
  std::string flag = fmt::format("--{}", option);
  std::ranges::replace(flag, '_', '-');
  return flag;
}

Told tell(std::string_view pattern, const Facts& facts) {
  Filled filling = filled(pattern, facts);
  Told told{sentence(std::move(filling.text), pattern), {}, {}, std::move(filling.named)};
  for (Named& named : told.named)
    named.text = told.sentence.substr(named.at, named.text.size());
  for (const Fact& fact : facts) {
    if (fact.place()) told.places.push_back(*fact.place());
    if (fact.quantity()) told.numbers.push_back({std::string(fact.name()), *fact.quantity()});
  }
  return told;
}

std::string number_text(double value, int digits) {
  constexpr double kLeast = 1e-3, kMost = 1e9, kMostWhole = 1e12;  // shown without exponent
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
  for (std::size_t i = 0; i < words.size(); ++i)
    text.append(between(i, words.size())).append(words[i]);
  return text;
}

Error error_of(const Refusal& refusal, const Facts& facts, std::string where) {
  Told told = tell(refusal.pattern, facts);
  Error error{refusal.code,           std::move(told.sentence), std::move(where),
              std::move(told.places), std::move(told.numbers),  {},
              std::move(told.named)};
  if (error.where.empty()) error.where = where_of(error.places);
  const auto [change, named] = filled(refusal.change, facts);
  if (!change.empty()) {
    append_named(error.named, named, error.message.size() + 1);
    error.message += " " + change;
  }
  if (!change.empty() || !refusal.option.empty())
    error.remedies.push_back(
        {std::string(refusal.option), filled(refusal.value, facts).text, change, named});
  return error;
}

std::vector<Piece> wording(const Told& told) { return pieces_of(told.sentence, told.named); }
std::vector<Piece> wording(const Error& error) { return pieces_of(error.message, error.named); }

void say_before(Error& error, const Told& words) {
  std::vector<Named> named = words.named;
  append_named(named, error.named, words.sentence.size());
  error.named = std::move(named);
  error.message.insert(0, words.sentence);
}
void say_before(Error& error, std::string_view text) { say_before(error, Told{std::string(text)}); }

void rename_place(Error& error, const Place& from, const Place& to) {
  respell(error.message, error.named, [&](Named& named) -> std::optional<std::string> {
    if (!named.option.empty() || named.quantity || named.place != from) return std::nullopt;
    named.place = to;
    return text_of(to);
  });
}

void say_in(LengthUnit unit, std::string& sentence, std::vector<Named>& named) {
  respell(sentence, named, [&](const Named& one) {
    return stands(one, sentence) ? in_unit(one, unit) : std::nullopt;
  });
}

Told in_units(Told told, LengthUnit unit) {
  say_in(unit, told.sentence, told.named);
  return told;
}

Error in_units(Error error, LengthUnit unit) {
  say_in(unit, error.message, error.named);
  for (Remedy& remedy : error.remedies)
    say_in(unit, remedy.change, remedy.named);
  return error;
}

Told words_of(const Error& error) { return {error.message, {}, {}, error.named}; }

void say_after(Told& told, std::string_view between, const Told& more) {
  told.sentence += between;
  append_named(told.named, more.named, told.sentence.size());
  told.sentence += more.sentence;
  told.places.insert(told.places.end(), more.places.begin(), more.places.end());
  told.numbers.insert(told.numbers.end(), more.numbers.begin(), more.numbers.end());
}

void say_after(Error& error, const Told& more) {
  append_named(error.named, more.named, error.message.size() + 1);
  error.message += " " + more.sentence;
}
void say_after(Error& error, const Error& more) { say_after(error, words_of(more)); }

}  // namespace planish
