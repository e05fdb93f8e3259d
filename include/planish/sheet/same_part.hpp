#pragma once

#include <planish/sheet/flat_pattern.hpp>

#include <array>
#include <functional>
#include <map>

namespace planish {

/// How far apart two patterns of one part may lie, mm: ten times what developed curves are fitted
/// to, a tenth of what a laser cutter holds.
inline constexpr double kSamePlace = 10.0 * kImageTolerance;

/// Whether two patterns are of one part, to be cut and bent once and counted twice: of the same
/// thickness, and congruent by a motion of the plane with contours, slits, bend lines (kind, angle,
/// inside radius, up or down), bend zones and forms (kind, outlines, side); or congruent so once
/// one of them is turned over, with up and down exchanged. So a part is the same seen from either
/// side, and mirror images (a left and a right part) differ, unless the part is its own mirror
/// image.
///
/// A contour may begin anywhere; apart from that both are split into curves at the same places, as
/// `flatten` does. Names, K and labels are not compared. `tolerance`: mm, grows with the digits of
/// STEP files for parts of more than 10 m. Requires patterns that pass `check`. An empty pattern is
/// no part. O(n log n) for n curves, for each turn that could map one pattern to the other.
bool is_same_part(const FlatPattern& a, const FlatPattern& b, double tolerance = kSamePlace);

/// Parts sorted into groups of equal ones, in the order in which they come: each joins the first
/// group whose first part it equals, or begins one. Only a few numbers are kept of each group; the
/// pattern of its first part is asked for when it is to be compared.
class PartGroups {
 public:
  /// The pattern of the first part of a group; an empty one if it is not to be had.
  using First = std::function<FlatPattern(std::size_t group)>;
  explicit PartGroups(First first, double tolerance = kSamePlace)
      : first_(std::move(first)), tolerance_(tolerance) {}

  /// The group of the part, from 0; `size() - 1` of those before it if it began one. O(log groups)
  /// and a comparison with each first part of the same sizes.
  std::size_t add(const FlatPattern& pattern);
  std::size_t size() const { return count_; }

 private:
  /// What equal parts have equally, whatever is done to them.
  using Counts = std::array<std::size_t, 5>;
  struct Sizes {
    double thickness = 0.0, perimeter = 0.0, bend_length = 0.0, bend_angle = 0.0;
    std::size_t group = 0;
  };
  static Counts counts_of(const FlatPattern& pattern);
  static Sizes sizes_of(const FlatPattern& pattern);
  bool may_equal(const Sizes& a, const Sizes& b, double slack) const;

  First first_;
  double tolerance_;
  std::size_t count_ = 0;
  std::map<Counts, std::multimap<double, Sizes>> groups_;  ///< by area
};

}  // namespace planish
