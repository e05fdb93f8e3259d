#pragma once

#include "workpiece.hpp"

#include <cstdint>

namespace planish::brake_detail {

inline constexpr double kSameLength = 1e-3;  ///< mm: sums of segments that are one length

/// Segments of a tool standing side by side.
struct ToolRow {
  double from = 0.0;  ///< along the bend line, mm
  std::vector<double> segments;
  double length() const;
};

/// What a row must cover of a piece of the bend line, of which so much may be missing at each end.
Interval covered(const Interval& piece, double shortfall);

struct RowRequest {
  std::vector<Interval> pieces;   ///< of the bend line, from the lowest x on
  double shortfall = 0.0;         ///< may be missing at each end of a piece, mm
  std::vector<Interval> blocked;  ///< where a tool may not stand, apart and from the lowest x on
  double longest = 0.0;           ///< row that the machine takes, mm
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
  std::vector<double> chosen(Chosen chosen) const;

 private:
  std::vector<double> segments_;  ///< longest first
  std::vector<Sum> sums_;
};

/// Rows of segments that together press every piece: one row where nothing is in its way, else one
/// for each stretch between what blocks. Each row is as short as it can be, in the middle of what
/// it presses as far as there is room. Empty: no choice of segments does it.
std::vector<ToolRow> tool_rows(const SegmentSums& segments, const RowRequest& request);

}  // namespace planish::brake_detail
