#pragma once

#include "part_list.hpp"

#include <map>

namespace planish::pack {

/// What a shop asks, in its own currency (formats.md#pack).
class Rates {
 public:
  /// Of one material.
  struct Row {
    double cut = 0.0;     ///< per mm of cutting length
    double pierce = 0.0;  ///< each
    double bend = 0.0;    ///< each
    double setup = 0.0;   ///< for each distinct part
    double kg = 0.0;      ///< of the blank's mass: material
    double area = 0.0;    ///< per mm² of the smallest rectangle around it: material
  };

  /// Errors: `invalid_input`, `where` is the JSON pointer.
  static Result<Rates> parse(const GivenFile& file);

  const std::string& currency() const { return currency_; }
  /// Enters the cost of all parts. Errors: `bad_option` for a material without rates, or a rate per
  /// kg for a part whose mass is not known.
  Result<void> apply(PartList& list) const;

 private:
  std::string name_, currency_;
  std::map<std::string, Row> rows_;  ///< by material
};

}  // namespace planish::pack
