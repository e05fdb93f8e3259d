#pragma once

#include <planish/base/angle.hpp>
#include <planish/base/result.hpp>
#include <planish/sheet/material.hpp>

#include <string>
#include <variant>
#include <vector>

namespace planish {

/// The length of flat sheet that a bend takes, and the source of the number
/// (math.md#bend-allowance). Lengths in mm. Beyond 90° the deduction is measured to the outer mould
/// line (where the outside faces would meet), not to the tangent plane (r + t); at 180°, where
/// there is no mould line, to the tangent plane.
struct BendAllowance {
  double k_factor = 0.0;   ///< neutral surface at k·t from the inside face
  double allowance = 0.0;  ///< BA = α (r + k t)
  double deduction = 0.0;  ///< BD = 2·outside_setback − BA
  std::string source;  ///< e.g. "constant", "DIN 6935", "table steel.csv, rows 3 and 4 (R/T 1.5)"
};

struct ConstantK {
  double k = 0.44;
  std::string source = "default";
};

struct Din6935 {};

/// A bend table (shop-floor.md#bend-tables): K by R/T, or K, BA or BD by radius, thickness, angle.
/// BA and BD without angles are for 90° bends; BD as defined at `BendAllowance`.
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

using AllowanceRule = std::variant<ConstantK, Din6935, BendTable, MaterialCurves>;

/// Allowance of one bend. Each row of a BA or BD table is converted to K with its own radius,
/// thickness and angle. K is interpolated linearly between the two nearest thicknesses, within each
/// between the two nearest angles, and within these between the two nearest radii; outside it is
/// constant. A thickness that agrees within 1e-6 is used alone. `source` names the rows, counted
/// from 1. Of a material K is that of `plastic_k`; `source` says where the bend strains it beyond
/// what its curves hold. Errors: `bad_option` when the thickness is not positive, radius or angle
/// are negative, the table is empty, a material's curve is wrong, or the resulting K is not finite
/// or outside [0, 1]. The result depends on (thickness, inside radius, angle) only, so a bend has
/// the same K seen from either side of the sheet.
Result<BendAllowance> bend_allowance(const AllowanceRule& rule, double thickness,
                                     double inside_radius, Angle angle);

/// OSSB = (r + t) tan(α/2) for α < 180°, r + t (to the tangent plane) from there on. An angle
/// within 1e-6 rad of 180° counts as 180°: a hem in a CAD file is seldom more exact, and the
/// tangent has no meaning there.
double outside_setback(double inside_radius, double thickness, Angle angle);

/// DIN 6935 k (refers to t/2): 0.65 + 0.5 log10(r/t), 1 from r/t = 5 on (math.md#din-6935), and 0
/// for r/t < 0.0501, where the formula is negative. At r/t = 5 the standard's table has 1, its
/// formula 0.9995.
double din6935_k(double inside_radius, double thickness);

/// Reads a CSV bend table: one material, rows in any order. The header row names the columns, in
/// any order and case: `r/t` or `r` and `t`, optional `angle`, and one of `k`, `ba`, `bd`. Long
/// names
/// ("Inside radius", "K-factor", "Bend deduction"), DIN's k, the Y-factor and opening angles are
/// accepted too; other columns are skipped. Units may follow in brackets (mm, inch, deg,
/// rad). Fields are separated by commas, semicolons or tabs and may be quoted; `#` starts a
/// comment; a comma within a field is a decimal comma. Errors: `invalid_input`, `where` is
/// name:line.
Result<BendTable> parse_bend_table(const std::string& csv, const std::string& name);

}  // namespace planish
