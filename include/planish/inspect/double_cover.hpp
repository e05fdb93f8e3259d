#pragma once

#include <planish/geometry/region.hpp>
#include <planish/inspect/findings.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <string>
#include <vector>

namespace planish {

/// A place that two parts of the sheet cover when it lies flat.
struct DoubleCover {
  std::vector<Place> parts;  ///< bends and flanges: all that meet there
  std::string who;           ///< the same in words: "bend B1 and flange 3"
  double area = 0.0;         ///< mm²
  Vec2 middle = Vec2::Zero();
  Vec2 along = Vec2::UnitX();  ///< its smallest rectangle: unit vector along its longer side
  Vec2 size = Vec2::Zero();    ///< and the sides, longer first, mm
};

/// Every such place by itself, those that meet as one; `find_overlaps` gives one finding for each
/// pair of parts.
std::vector<DoubleCover> double_covers(const Sheet& sheet, const Layout& layout,
                                       const FlatPattern& pattern);

/// Where contours of the pattern as written cross themselves, with the depth of `find_overlaps`.
std::vector<Finding> contour_crossings(const FlatPattern& pattern);

/// The area of the sheet's faces and sharp bends in the pattern, by polygons and without the
/// pattern's contours: to check what was cut from them.
class SheetArea {
 public:
  SheetArea(const Sheet& sheet, const Layout& layout, const FlatPattern& pattern);
  /// mm² within a closed loop and outside of others; what is covered twice counts twice. O(faces)
  /// and the corners of those that meet the loop.
  double within(const Loop& loop, const std::vector<Loop>& without = {}) const;

 private:
  double within(Polygon loop, const Box2& box) const;

  double chord_ = 0.0;
  std::vector<Polygon> polygons_;
  std::vector<Box2> boxes_;
};

}  // namespace planish
