#pragma once

#include "nearest_points.hpp"
#include "strip_problem.hpp"

#include <planish/slit/session.hpp>

#include <memory>
#include <vector>

namespace planish::slit_detail {

/// How a strip stands. Never changed once it is in a snapshot.
struct Slot {
  StripParameters p;  ///< empty until it is solved for the first time
  std::vector<Inequality> inequalities;
  std::shared_ptr<const ScannedSurface> scan;
  StripState state;
  Eigen::AlignedBox3d box;  ///< of the folded strip
};

/// How a session stands. Copies share what is large.
struct Snapshot {
  std::shared_ptr<const SlitDesign> design;
  std::shared_ptr<const std::vector<PanelFacet>> panel;
  std::shared_ptr<const BezierSearch> seat;
  std::shared_ptr<const std::vector<Vec2>> seat_places;  ///< left and right of each strip
  std::vector<std::shared_ptr<const Slot>> slots;

  const Slot& slot(int strip) const { return *slots[strip]; }
  int count() const { return static_cast<int>(slots.size()); }
};

/// What a strip starts from.
StripBase base_of(const Snapshot& now, int strip);

/// The seat curve of a design, and the strips' places on it: side by side, evenly apart from its
/// start to its end, one alone in its middle.
void take_seat_curve(Snapshot& now, const SlitDesign& design);

/// Sign of x on the modelled half.
double half_sign(const Snapshot& now);

/// What a strip is to be solved for.
StripProblem problem_of(const Snapshot& now, int strip);

/// A strip as it is; flat until it is solved for the first time.
FoldedStrip folded_of(const Snapshot& now, int strip);

/// Marks a strip as not solved since.
void reopen(Snapshot& now, int strip);

/// A strip with every quad divided in its middle by a ridge that does not fold
/// (math.md#subdivision).
StripParameters subdivided(const StripBase& base, const StripParameters& p);

/// Null where there are no points.
std::shared_ptr<const ScannedSurface> scan_of(std::vector<Vec3> points);

}  // namespace planish::slit_detail
