#pragma once

#include "workpiece.hpp"

#include <cstdint>

namespace planish::brake_detail {

inline constexpr double kSameLength = 1e-3;  ///< mm: sums of segments that are one length

/// The ears of a punch, by the end of a row at which they stand. Above their foot the body stands
/// back from that end.
struct RowEars {
  double lo = 0.0, hi = 0.0;  ///< lengths, mm; 0: none at that end
  double reach = 0.0;         ///< by which the body stands back, mm
  int count() const { return (lo > 0.0 ? 1 : 0) + (hi > 0.0 ? 1 : 0); }
  bool any() const { return count() > 0; }
  RowEars turned() const { return {hi, lo, reach}; }
};

/// Where the body stands of what stands there with its feet; may end before it begins.
Interval stood_back(const Interval& feet, const RowEars& ears);

/// Segments of a tool standing side by side.
struct ToolRow {
  double from = 0.0;             ///< along the bend line, mm
  std::vector<double> segments;  ///< ears included
  RowEars ears = {};
  double length() const;
  std::vector<double> plain() const;  ///< without the ears
};
/// The same, seen from the other side.
ToolRow turned(ToolRow row);
/// As it is reported, beginning there.
SegmentRow row_of(const ToolRow& row, double from);
Interval extent(const ToolRow& row);
/// Where the whole section of the tool stands: without what is only the foot of an ear.
Interval body(const ToolRow& row);

/// What a row must cover of a piece of the bend line, of which so much may be missing at each end.
Interval covered(const Interval& piece, double shortfall);

struct RowRequest {
  std::vector<Interval> pieces;   ///< of the bend line, from the lowest x on
  double shortfall = 0.0;         ///< may be missing at each end of a piece, mm
  std::vector<Interval> blocked;  ///< where a tool may not stand, apart and from the lowest x on
  double longest = 0.0;           ///< row that the machine takes, mm
  RowEars ears = {};              ///< that there are
  std::vector<Interval> blocked_foot = {};  ///< where not even the foot of an ear may stand
  bool from_last = false;  ///< between walls the last row chooses its segments first
  bool shortest = false;   ///< rows, though they stand on ears that longer ones do without
};

/// The lengths that segments add up to: each with one way to do it, with few segments. Of more than
/// 64 segments the longest 64 count.
class SegmentSums {
 public:
  using Chosen = std::uint64_t;  ///< bit i: segment i
  struct Sum {
    double length = 0.0;
    Chosen chosen = 0;
  };

  /// Without those in `used`.
  explicit SegmentSums(const std::vector<double>& segments, Chosen used = 0);
  /// By length, above 0.
  const std::vector<Sum>& sums() const { return sums_; }
  const std::vector<double>& segments() const { return segments_; }
  Chosen used() const { return used_; }
  std::vector<double> chosen(Chosen chosen) const;

 private:
  std::vector<double> segments_;  ///< longest first
  Chosen used_ = 0;
  std::vector<Sum> sums_;
};

/// Whether there is room for rows, had the tool segments of every length besides its ears.
bool has_room(const RowRequest& request);

/// Rows of segments that together press every piece: one row where nothing is in its way, else one
/// for each stretch between what blocks. Each row is as short as it can be, with as few ears as
/// there need be, in the middle of what it presses as far as there is room. Ears are segments like
/// others but stand at the outer ends, and can be pushed together from below what is above their
/// feet. Empty: no choice of segments does it.
std::vector<ToolRow> tool_rows(const SegmentSums& segments, const RowRequest& request);

}  // namespace planish::brake_detail
