// Bend allowance by rule or by table (math.md#bend-allowance). Every row of a table becomes a
// K-factor with its own radius, thickness and angle, and K alone is interpolated: one dimension
// after the other, between the nearest coordinate below and above. So tables of K, BA and BD are
// read by the same code, and outside a table K stays as it is at its rim. Whatever the rule, 0 ≤ K
// ≤ 1 holds, or it is refused.

#include "refusals.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/sheet/allowance.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

// K, allowance and deduction of a bend (math.md#bend-allowance). Every rule is brought to K, also
// rows of BA and BD, each with its own radius, thickness and angle, so that they can be
// interpolated at all. A table is read dimension by dimension: thickness, angle, then radius, the
// nearest rows below and above blended and constant beyond; the rows that took part are named as
// the source.

namespace planish {
namespace {

/// A K-factor and where it came from.
struct SourcedK {
  double k = 0.0;
  std::string source;
};

/// The bend whose allowance is wanted.
struct BendSize {
  double thickness = 0.0;
  double radius = 0.0;
  Angle angle;
};

constexpr double kGivenForAngle = 90.0;  // degrees: the angle of a BA or BD given without one

// How far a K that was computed from BA or BD may leave [0, 1] by rounding.
constexpr double kBeyond = tolerance::kComputed;

double k_of_allowance(double allowance, const BendSize& bend) {
  return (allowance / bend.angle.radians() - bend.radius) / bend.thickness;
}

// Tables.

/// A row as a K-factor at a point of the table's up to three dimensions.
struct TablePoint {
  std::array<double, 3> at;  // thickness, angle, radius (or R/T); 0 where the table has no such
                             // column
  double k = 0.0;
  int row = 0;
};

struct TableReading {
  double k = 0.0;
  std::set<int> rows;
  bool beyond = false;  // outside the table in some dimension
};

double k_of_row(const BendTable& table, const BendTable::Row& row) {
  const Angle angle = Angle::degrees(table.by_angle ? row.angle : kGivenForAngle);
  const BendSize bend{row.thickness, row.radius, angle};
  switch (table.value) {
    case BendTable::Value::k_factor:
      return row.value;
    case BendTable::Value::allowance:
      return k_of_allowance(row.value, bend);
    case BendTable::Value::deduction: {
      const double setback = outside_setback(row.radius, row.thickness, angle);
      return k_of_allowance(2.0 * setback - row.value, bend);
    }
  }
  return std::nan("");
}

std::vector<TablePoint> points_of(const BendTable& table) {
  std::vector<TablePoint> points;
  for (const BendTable::Row& row : table.rows) {
    const double thickness = table.by_ratio ? 0.0 : row.thickness;
    const double angle = table.by_angle ? row.angle : 0.0;
    points.push_back({{thickness, angle, row.radius},
                      k_of_row(table, row),
                      static_cast<int>(points.size()) + 1});
  }
  return points;
}

/// Equal along one dimension: tables write 0.0598 where CAD has 0.05980001.
bool same(double a, double b) {
  constexpr double kRelative = tolerance::kWrittenDigits;
  return std::abs(a - b) <= kRelative * std::max(std::abs(a), std::abs(b));
}

TableReading blended(const TableReading& low, const TableReading& high, double share) {
  TableReading result = low;
  result.k += share * (high.k - low.k);
  result.rows.insert(high.rows.begin(), high.rows.end());
  result.beyond |= high.beyond;
  return result;
}

/// Reads the table at `at`, dimension by dimension: points that share the nearest coordinate below,
/// and above, are read in the remaining dimensions, and the two readings blended.
TableReading read(const std::vector<TablePoint>& points, const std::array<double, 3>& at,
                  size_t dimension) {
  if (dimension == at.size()) return {points.front().k, {points.front().row}, false};
  const double x = at[dimension];
  const auto coordinate = [&](const TablePoint& p) { return p.at[dimension]; };
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  for (const TablePoint& p : points) {
    const double c = same(coordinate(p), x) ? x : coordinate(p);
    if (c <= x) low = std::max(low, c);
    if (c >= x) high = std::min(high, c);
  }
  const auto read_at = [&](double c) {
    std::vector<TablePoint> there;
    std::copy_if(points.begin(), points.end(), std::back_inserter(there),
                 [&](const TablePoint& p) { return same(coordinate(p), c); });
    return read(there, at, dimension + 1);
  };
  if (std::isfinite(low) && std::isfinite(high)) {
    if (low == high) return read_at(low);
    return blended(read_at(low), read_at(high), (x - low) / (high - low));
  }
  TableReading reading = read_at(std::isfinite(low) ? low : high);
  reading.beyond = true;
  return reading;
}

std::string rows_text(const std::set<int>& rows) {
  std::string text = rows.size() == 1 ? "row " : "rows ";
  size_t left = rows.size();
  for (const int row : rows) {
    text += fmt::format("{}{}", row, left > 2 ? ", " : left == 2 ? " and " : "");
    --left;
  }
  return text;
}

std::string place_text(const BendTable& table, const BendSize& bend) {
  std::string text = table.by_ratio
                         ? fmt::format("R/T {:.4g}", bend.radius / bend.thickness)
                         : fmt::format("R {:.4g} mm, T {:.4g} mm", bend.radius, bend.thickness);
  if (table.by_angle) text += fmt::format(", {:.4g}°", bend.angle.degrees());
  return text;
}

/// Which of the two readings of BD the rows went through, empty when they do not differ.
std::string deduction_text(const BendTable& table, const std::set<int>& rows) {
  if (table.value != BendTable::Value::deduction || !table.by_angle) return {};
  double largest = 0.0;
  for (const int row : rows)
    largest = std::max(largest, table.rows[static_cast<size_t>(row) - 1].angle);
  if (largest <= kGivenForAngle) return {};
  return largest < 180.0 ? "; BD to the outer mould line" : "; BD from 180° to the tangent plane";
}

Result<SourcedK> k_of(const BendTable& table, const BendSize& bend) {
  const std::string name = table.name.empty() ? "bend table" : "table " + table.name;
  if (table.rows.empty()) return fail(refuse::table_without_rows, {{"table", name}}, table.name);
  if (table.by_ratio && table.value != BendTable::Value::k_factor) {
    return fail(refuse::lengths_by_ratio, {{"table", name}}, table.name);
  }
  const double radius = table.by_ratio ? bend.radius / bend.thickness : bend.radius;
  const double thickness = table.by_ratio ? 0.0 : bend.thickness;
  const TableReading reading = read(
      points_of(table), {thickness, table.by_angle ? bend.angle.degrees() : 0.0, radius}, 0);
  return SourcedK{reading.k, fmt::format("{}, {} ({}{}){}", name, rows_text(reading.rows),
                                         place_text(table, bend),
                                         reading.beyond ? ", held constant beyond the table" : "",
                                         deduction_text(table, reading.rows))};
}

// The other rules.

Result<SourcedK> k_of(const ConstantK& rule, const BendSize&) {
  return SourcedK{rule.k, rule.source};
}

Result<SourcedK> k_of(const Din6935&, const BendSize& bend) {
  const double k = din6935_k(bend.radius, bend.thickness) / 2.0;
  return SourcedK{k, k > 0.0 ? "DIN 6935" : "DIN 6935 (k held at 0, R/T is below 0.05)"};
}

Result<SourcedK> k_of(const MaterialCurves& material, const BendSize& bend) {
  if (auto fine = check(material); !fine) return pass_on(fine);
  const double ratio = bend.radius / bend.thickness;
  const double k = plastic_k(material, ratio);
  const BendStrains strains = bend_strains(k, ratio);
  std::string source = "material " + material.name;
  for (const auto& [curve, strain, side] :
       {std::tuple{&material.tension, strains.tension, "tension"},
        std::tuple{&material.compression, strains.compression, "compression"}})
    if (strain > known_to(*curve))
      source += fmt::format(", {} held from strain {:.4g} to {:.4g}", side, known_to(*curve),
                            strain);
  return SourcedK{k, std::move(source)};
}

}  // namespace

Result<BendAllowance> bend_allowance(const AllowanceRule& rule, double thickness,
                                     double inside_radius, Angle angle) {
  // Negated comparisons, so that NaN is refused too.
  if (!(thickness > 0.0 && std::isfinite(thickness)))
    return fail(refuse::bend_thickness, {{"thickness", thickness, unit::mm}});
  if (!(inside_radius >= 0.0 && std::isfinite(inside_radius)))
    return fail(refuse::bend_radius, {{"radius", inside_radius, unit::mm}});
  if (!(angle.radians() >= 0.0 && std::isfinite(angle.radians())))
    return fail(refuse::bend_angle, {{"angle", angle.degrees(), unit::degrees}});

  const BendSize bend{thickness, inside_radius, angle};
  const auto found = std::visit([&](const auto& r) { return k_of(r, bend); }, rule);
  if (!found) return pass_on(found);
  if (!(found->k >= -kBeyond && found->k <= 1.0 + kBeyond)) {
    return fail(refuse::k_out_of_range,
                {{"k", found->k, unit::none},
                 {"source", found->source},
                 {"angle", angle.degrees(), unit::degrees},
                 {"radius", inside_radius, unit::mm},
                 {"thickness", thickness, unit::mm}},
                found->source);
  }
  BendAllowance result;
  result.k_factor = std::clamp(found->k, 0.0, 1.0);
  result.allowance = angle.radians() * (inside_radius + result.k_factor * thickness);
  result.deduction = 2.0 * outside_setback(inside_radius, thickness, angle) - result.allowance;
  result.source = found->source;
  return result;
}

double outside_setback(double inside_radius, double thickness, Angle angle) {
  constexpr double kNearly = tolerance::kWrittenDigits;  // rad: of a hem in a CAD file
  constexpr double kHalfTurn = std::numbers::pi - kNearly;
  const double outside_radius = inside_radius + thickness;
  return angle.radians() < kHalfTurn ? outside_radius * std::tan(angle.radians() / 2.0)
                                     : outside_radius;
}

double din6935_k(double inside_radius, double thickness) {
  const double ratio = inside_radius / thickness;
  if (ratio >= 5.0) return 1.0;
  return ratio > 0.0 ? std::max(0.0, 0.65 + 0.5 * std::log10(ratio)) : 0.0;
}

}  // namespace planish
