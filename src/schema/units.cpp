#include <planish/base/message.hpp>
#include <planish/schema/units.hpp>

#include <fmt/format.h>

namespace planish::schema {

std::string_view Units::name() const {
  switch (unit_) {
    case LengthUnit::inch:
      return "inch";
    case LengthUnit::m:
      return "m";
    case LengthUnit::mm:
      break;
  }
  return "mm";
}

std::string_view Units::symbol() const { return unit_ == LengthUnit::inch ? "in" : name(); }

int Units::decimals() const {
  switch (unit_) {
    case LengthUnit::inch:
      return 4;
    case LengthUnit::m:
      return 6;
    case LengthUnit::mm:
      break;
  }
  return 3;
}

std::string Units::length_text(double mm) const {
  return fmt::format("{:.{}f}", length(mm), decimals());
}

std::string Units::area_text(double mm2) const {
  const int places = unit_ == LengthUnit::mm ? 1 : decimals();
  return fmt::format("{:.{}f}", area(mm2), places);
}

std::string Units::short_text(double mm) const { return trimmed_number(length(mm), decimals()); }

std::string Units::tiny_text(double mm) const { return number_text(length(mm), 2); }

}  // namespace planish::schema
