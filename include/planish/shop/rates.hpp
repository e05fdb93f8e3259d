#pragma once

#include <planish/base/result.hpp>
#include <planish/geometry/frame.hpp>

#include <map>
#include <optional>
#include <string>

namespace planish::shop {

/// What of a part costs something. Lengths in mm.
struct PricedPart {
  std::string name, material;
  int quantity = 1;
  double cut_length = 0.0;          ///< of all contours and slits
  std::size_t pierces = 0;          ///< contours and slits
  std::size_t bends = 0;            ///< of one
  Vec2 size = Vec2::Zero();         ///< smallest rectangle around it
  std::optional<double> mass = {};  ///< kg, of one
};

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

  /// Reads a rates file; `name` is the file's. Errors: `invalid_input`, `where` is name and JSON
  /// pointer.
  static Result<Rates> parse(const std::string& json, const std::string& name);

  const std::string& currency() const { return currency_; }
  /// The cost of all pieces of a part. Errors: `bad_option` for a material without rates, or a rate
  /// per kg for a part whose mass is not known.
  Result<double> cost_of(const PricedPart& part) const;

 private:
  std::string name_, currency_;
  std::map<std::string, Row> rows_;  ///< by material
};

}  // namespace planish::shop
