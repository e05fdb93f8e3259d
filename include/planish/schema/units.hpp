#pragma once

#include <planish/base/length_unit.hpp>

#include <string>
#include <string_view>

namespace planish::schema {

/// Converts lengths of a report from millimetres to its unit, as numbers and as text.
class Units {
 public:
  explicit Units(LengthUnit unit) : unit_(unit), millimetres_(millimetres_in(unit)) {}

  LengthUnit unit() const { return unit_; }
  double length(double mm) const { return mm / millimetres_; }
  double area(double mm2) const { return mm2 / (millimetres_ * millimetres_); }
  double volume(double mm3) const { return mm3 / (millimetres_ * millimetres_ * millimetres_); }

  std::string_view name() const;    ///< as formats.md#units spells it: "mm", "inch", "m"
  std::string_view symbol() const;  ///< as people write it: "mm", "in", "m"

  /// Fixed decimals, a micrometre or finer; without the symbol.
  std::string length_text(double mm) const;
  std::string area_text(double mm2) const;
  /// Trailing zeros left out: "2", "0.978".
  std::string short_text(double mm) const;
  /// For residuals: "0.0025", "1.2e-13".
  std::string tiny_text(double mm) const;

 private:
  int decimals() const;

  LengthUnit unit_;
  double millimetres_;
};

}  // namespace planish::schema
