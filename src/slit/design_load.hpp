#pragma once

#include "strip_load.hpp"

#include <planish/base/result.hpp>
#include <planish/slit/slit_sheet.hpp>

namespace planish::slit_detail {

constexpr double kGravity = 9.80665;  ///< m/s²

/// Weight of the sheet, N/mm²; 0 without gravity.
double weight_per_area(const SlitDesign& design);

/// A load on the modelled strip, N: in symmetric sheets its half.
Vec3 force_on(const SlitDesign& design, const SlitLoad& load);

/// What bends a strip of a design that has been checked; nothing without weight and loads.
StripLoad load_of(const SlitDesign& design, int strip);

/// Whether two designs of the same sheet are loaded alike.
bool same_load(const SlitDesign& a, const SlitDesign& b);

/// Checks material, weight and loads. Errors: `unknown_strip`, `invalid_input` (numbers out of
/// their range, a load without a material, weight without a density, either with another objective
/// than energy, a force across the symmetry plane).
Result<void> check_load(const SlitDesign& design);

}  // namespace planish::slit_detail
