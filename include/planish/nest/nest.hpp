#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <optional>
#include <vector>

namespace planish {

/// A part to be cut `quantity` times.
struct NestPart {
  const FlatPattern* flat = nullptr;
  int quantity = 1;
};

struct NestOptions {
  double length = 3000.0;             ///< of a sheet, along x, mm
  double width = 1500.0;              ///< along y, mm
  double gap = 5.0;                   ///< between the contours of two parts, mm
  std::optional<double> margin = {};  ///< between a contour and the edge of the sheet; the gap
  bool grain = false;                 ///< keeps the patterns' x axis along that of the sheet
};

/// A copy of a part on a sheet.
struct Placed {
  int part = 0;
  int copy = 0;  ///< from 0, over all sheets
  /// From the pattern's coordinates to the sheet's, whose corner is the origin. Never a reflection:
  /// bends up stay up.
  Isometry2 placement = Isometry2::Identity();
};

struct NestedSheet {
  std::vector<Placed> placed;  ///< by part, then copy
  double use = 0.0;            ///< share of the sheet's area that becomes parts, openings taken out
};

/// A part that no sheet of this size can bear, however it may be turned.
struct TooLarge {
  int part = 0;
  Vec2 needed;  ///< of the sheet, length and width, mm: smallest found among the allowed turns
};

struct Nesting {
  std::vector<NestedSheet> sheets;
  std::vector<TooLarge> too_large;  ///< their copies are on no sheet
};

/// Lays copies of parts on as few sheets as it finds, by libnest2d (decision 0014). A part lies
/// with the smallest rectangle around it along the sheet, in quarter turns; with `grain` as its
/// pattern is given, or turned by 180°. Parts do not lie in openings of others. Gap and margin are
/// kept between the exact contours, to within 1 µm. The same input gives the same result.
///
/// Cost: seconds for 200 different parts; quantities hardly matter, since copies of a part come in
/// blocks where there are many.
/// Errors: `bad_option` (a size or quantity that cannot be), `invalid_sheet` (a pattern without
/// outer contour), `cancelled`, `internal`.
Result<Nesting> nest(const std::vector<NestPart>& parts, const NestOptions& options,
                     const Progress& progress = {});

}  // namespace planish
