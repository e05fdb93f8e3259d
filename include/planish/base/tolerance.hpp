#pragma once

/// Numeric tolerances, each a share of the extent of what is compared (or radians, where angles
/// are): how far apart two numbers may be that would be equal without rounding. They are never
/// lengths. Model tolerances (mm) are parameters, shop tolerances are options; neither is here.
///
/// A module gives a tolerance the name of what it decides and takes the value from here:
/// `constexpr double kOnAxis = tolerance::kComputed;`.
namespace planish::tolerance {

/// A few operations on doubles of that size: 4500 ε.
inline constexpr double kRounding = 1e-12;

/// A chain of operations, a development, a solver or a root: far above their accumulated rounding,
/// far below anything drawn or cut.
inline constexpr double kComputed = 1e-9;

/// Positions read from a file: STEP writers keep about seven digits of the part's size.
inline constexpr double kFileDigits = 1e-7;

/// Numbers as people, tables and programs write them out: six digits of the largest.
inline constexpr double kWrittenDigits = 1e-6;

/// A step aside that certainly leaves a border or a corner.
inline constexpr double kAside = 1e-6;

/// The step of a central difference, at which rounding and curvature contribute about equally.
inline constexpr double kDifference = 1e-5;

/// Below every length, area or angle that can occur: keeps a division from 0/0.
inline constexpr double kTiniest = 1e-300;

}  // namespace planish::tolerance
