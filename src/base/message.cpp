// Templates are filled by name. A sentence names a place or states a number only through a fact, so
// whatever it names is there as data too: that is what lets front ends leave the sentence alone.

#include <planish/base/message.hpp>
#include <planish/base/result.hpp>
#include <planish/base/text.hpp>

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

std::optional<std::string> text_in(const Slot& slot, const Facts& facts) {
  std::vector<const Place*> places;
  std::vector<std::string> texts;
  for (const Fact& fact : facts) {
    if (fact.name() != slot.name) continue;
    if (fact.place()) places.push_back(fact.place());
    if (fact.quantity()) texts.push_back(quantity_text(*fact.quantity(), slot.format));
    if (fact.words()) texts.push_back(*fact.words());
  }
  if (slot.is_place)
    return places.empty() ? std::nullopt : std::optional(places_text(places, slot.format));
  return texts.empty() ? std::nullopt : std::optional(listed(texts));
}

/// The only place of a name.
const Place* one_place(std::string_view name, const Facts& facts) {
  const Place* found = nullptr;
  for (const Fact& fact : facts) {
    if (fact.name() != name || !fact.place()) continue;
    if (found) return nullptr;
    found = fact.place();
  }
  return found;
}

/// A template with its slots filled, and what it names.
struct Filled {
  std::string text;
  std::vector<Named> named;
};

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
    const auto filling = text_in(slot, facts_);
    const Place* place = slot.is_place && filling ? one_place(slot.name, facts_) : nullptr;
    if (place) named_.push_back({text_.size(), *filling, {}, *place});
    text_ += filling ? *filling : std::string(pattern.substr(open, close - open + 1));
    return close + 1;
  }

  const Facts& facts_;
  std::string text_;
  std::vector<Named> named_;
  std::optional<std::size_t> open_;  // backtick
};

Filled filled(std::string_view pattern, const Facts& facts) { return Filling(facts).fill(pattern); }

/// With the names in it moved to behind `before`.
void append_named(std::vector<Named>& to, const std::vector<Named>& named, std::size_t before) {
  for (Named one : named) {
    one.at += before;
    to.push_back(std::move(one));
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
    // A message that someone has written anew has no such parts any more.
    if (named.at < done || named.at > text.size() ||
        text.substr(named.at, named.text.size()) != named.text)
      continue;
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
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
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
        {std::string(refusal.option), filled(refusal.value, facts).text, change});
  return error;
}

std::vector<Piece> wording(const Told& told) { return pieces_of(told.sentence, told.named); }
std::vector<Piece> wording(const Error& error) { return pieces_of(error.message, error.named); }

void say_before(Error& error, std::string_view text) {
  error.message.insert(0, text);
  for (Named& named : error.named)
    named.at += text.size();
}

void rename_place(Error& error, const Place& from, const Place& to) {
  std::size_t grown = 0;  // of the sentence so far
  for (Named& named : error.named) {
    named.at += grown;
    if (!named.option.empty() || named.place != from) continue;
    const std::string name = text_of(to);
    error.message.replace(named.at, named.text.size(), name);
    grown += name.size() - named.text.size();  // may wrap, and back again
    named.text = name;
    named.place = to;
  }
}

void say_after(Told& told, std::string_view between, const Told& more) {
  told.sentence += between;
  append_named(told.named, more.named, told.sentence.size());
  told.sentence += more.sentence;
  told.places.insert(told.places.end(), more.places.begin(), more.places.end());
  told.numbers.insert(told.numbers.end(), more.numbers.begin(), more.numbers.end());
}

void say_after(Error& error, const Error& more) {
  append_named(error.named, more.named, error.message.size() + 1);
  error.message += " " + more.message;
}

}  // namespace planish
