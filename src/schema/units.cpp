#include <planish/base/message.hpp>
#include <planish/base/text.hpp>
#include <planish/schema/units.hpp>

#include <fmt/format.h>

namespace planish::schema {
namespace {

/// A number with so many decimals; of one that rounds to 0, without its sign.
std::string fixed_text(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text.starts_with('-') ? text.substr(1) : text;
}

}  // namespace

std::string_view Units::name() const { return word_of(unit_, {"mm", "inch", "m"}); }

std::string_view Units::symbol() const { return unit_ == LengthUnit::inch ? "in" : name(); }

int Units::decimals() const {
  return unit_ == LengthUnit::mm ? 3 : unit_ == LengthUnit::inch ? 4 : 6;
}

std::string Units::length_text(double mm) const { return fixed_text(length(mm), decimals()); }

std::string Units::area_text(double mm2) const {
  const int places = unit_ == LengthUnit::mm ? 1 : decimals();
  return fixed_text(area(mm2), places);
}

std::string Units::short_text(double mm) const { return trimmed_number(length(mm), decimals()); }

std::string Units::tiny_text(double mm) const { return number_text(length(mm), 2); }

}  // namespace planish::schema
