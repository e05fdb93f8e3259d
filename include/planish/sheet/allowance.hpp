#pragma once

#include <planish/base/angle.hpp>
#include <planish/base/result.hpp>
#include <string>
#include <variant>
#include <vector>

namespace planish {

/// What a bend takes of the flat sheet, and where the number came from (MATH 1). Lengths in mm.
struct BendAllowance {
  double k_factor = 0.0;   ///< neutral surface at k·t from the inside face
  double allowance = 0.0;  ///< BA = α (r + k t)
  double deduction = 0.0;  ///< BD = 2·OSSB − BA; OSSB to the outer mould line for α < π, else to the
                           ///< tangent plane (r + t), as many shops do beyond 180°
  std::string source;      ///< e.g. "constant", "DIN 6935", "table row 3–4 (R/T 1.5)"
};

struct ConstantK {
  double k = 0.44;
  std::string source = "default";
};

struct Din6935 {};

/// A bend table (SHOPFLOOR, "Bend tables"): K by R/T, or K, BA or BD by radius, thickness, angle.
struct BendTable {
  enum class Value { k_factor, allowance, deduction };
  struct Row {
    double radius = 0.0;     ///< mm, or R/T when `by_ratio`
    double thickness = 0.0;  ///< mm; unused when `by_ratio`
    double angle = 0.0;      ///< degrees; unused when not `by_angle`
    double value = 0.0;
  };
  Value value = Value::k_factor;
  bool by_ratio = true;
  bool by_angle = false;
  std::vector<Row> rows;
  std::string name;  ///< file name, for the source
};

using AllowanceRule = std::variant<ConstantK, Din6935, BendTable>;

/// Allowance of one bend. Tables are interpolated linearly and held constant outside; a table of BA
/// or BD is turned into the K that gives it. Errors: `bad_option` when the resulting K is not
/// finite or outside [0, 1]. The result depends on (thickness, inside radius, angle) only, so the
/// same bend has the same K whichever side of the sheet is looked at.
Result<BendAllowance> bend_allowance(const AllowanceRule& rule, double thickness, double inside_radius, Angle angle);

/// DIN 6935 k (refers to t/2): 0.65 + 0.5 log10(r/t), at most 1 (MATH 1), and not below 0.
double din6935_k(double inside_radius, double thickness);

/// Reads a CSV bend table. Header row names the columns, any order, case-insensitive:
/// `r/t` or `r`,`t`, optional `angle`, and one of `k`, `ba`, `bd`. Comma or semicolon separated,
/// `#` comments, decimal commas with semicolons. Errors: `invalid_input` with the line number.
Result<BendTable> parse_bend_table(const std::string& csv, const std::string& name);

}  // namespace planish
