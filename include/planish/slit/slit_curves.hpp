#pragma once

#include <planish/base/result.hpp>
#include <planish/slit/bezier.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <vector>

namespace planish {

/// Corners of a chain of lines on a Bézier curve, first and last point included, from which it is
/// nowhere farther away than `chord`, mm.
std::vector<Vec2> chain_on(const BezierCurve& curve, double chord);

/// Slits that are curves, as chains of lines (along, across), and the corners of the sheet's
/// outline in turn; without an outline it is a rectangle of a width.
struct CurvedSlits {
  std::vector<std::vector<Vec2>> slits;
  std::vector<Vec2> outline;
  double width = 0.0;
};

/// The strips between slits, in a sheet of which all but the strips is given. Slits may be in any
/// order and run either way; each begins and ends anywhere. Beside a strip whose other slit ends
/// earlier, a slit or the outline is straight along from there on. The outline is straight at the
/// panel: along both sides from 0 to the panel's height and across its ends. Errors:
/// `invalid_input` where a slit or the outline does not do so, where they cross, lie one behind the
/// other, or where a strip has no width; `where` is `/slits/2`.
Result<std::vector<SlitStrip>> strips_between(const SlitSheet& sheet, const CurvedSlits& curves);

}  // namespace planish
