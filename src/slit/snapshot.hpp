#pragma once

#include "joined_ends.hpp"
#include "nearest_points.hpp"
#include "strip_problem.hpp"
#include "strip_system.hpp"

#include <planish/slit/session.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace planish::slit_detail {

/// The state of a strip. Never changed once it is in a snapshot.
struct Slot {
  StripParameters p;  ///< empty until it is first solved
  std::vector<Inequality> inequalities;
  std::shared_ptr<const ScannedSurface> scan;
  StripState state;
  Eigen::AlignedBox3d box;  ///< of the folded strip
  bool touches = false;     ///< others keep it where it is
  double undivided = 0.0;   ///< objective before its quads were divided; 0: not since it changed
};

/// Where strips of the sheet press each other, as they were last parted.
struct Pressing {
  std::vector<Contact> contacts;  ///< multipliers are what a penalty would add, and more than 0
  double penalty = 0.0;
  double unit = 0.0;  ///< in which contacts count, mm
};

/// The state of a session. Copies share large data.
struct Snapshot {
  std::shared_ptr<const SlitDesign> design;
  std::shared_ptr<const std::vector<PanelFacet>> panel;
  std::shared_ptr<const std::vector<PanelFacet>> second_panel;  ///< empty if there is none
  std::shared_ptr<const BezierSearch> seat;
  std::shared_ptr<const std::vector<Vec2>> seat_places;  ///< left and right of each strip
  std::vector<std::shared_ptr<const Slot>> slots;
  Pressing pressing = {};
  /// Of each run of joined strips; `placed` once the facets of `second_panel` are theirs.
  std::vector<JoinedEnds> joined = {};
  bool placed = false;

  const Slot& slot(int strip) const { return *slots[strip]; }
  int count() const { return static_cast<int>(slots.size()); }
};

/// The fixed data of a strip.
StripBase base_of(const Snapshot& now, int strip);

/// Sets the seat curve of a design, and the strips' places on it: evenly spaced from its start to
/// its end; a single strip in its middle.
void take_seat_curve(Snapshot& now, const SlitDesign& design);

/// The facet of the second panel, or of the uncut sheet beyond its slits, at which a strip ends;
/// null without one.
const PanelFacet* far_facet_of(const Snapshot& now, int strip);

/// Puts joined ends where they are said to lie.
void take_joined(Snapshot& now, std::vector<JoinedEnds> joined);

/// What a placed end says.
std::vector<EndCondition> conditions_of(const StripEnd& end);

/// Where a strip must end: as placed, or at the second panel.
StripEnd end_of(const Snapshot& now, int strip);

/// Sign of x on the modelled half.
double half_sign(const Snapshot& now);

/// Height above which a strip's middle surface must stay: half the thickness, or that of its panel
/// where this lies level with the ground; empty if it may go anywhere.
std::optional<double> least_height(const Snapshot& now, int strip);

/// The problem to be solved for a strip.
StripProblem problem_of(const Snapshot& now, int strip);

/// A strip in its present shape; flat until it is first solved.
FoldedStrip folded_of(const Snapshot& now, int strip);

/// The whole sheet in its present shape.
FoldedSlitSheet folded_sheet(const Snapshot& now);

/// Marks a strip as not solved since.
void reopen(Snapshot& now, int strip);

/// A strip with every quad divided in its middle by a ridge that does not fold
/// (math.md#subdivision).
StripParameters subdivided(const StripBase& base, const StripParameters& p);

/// Null without points.
std::shared_ptr<const ScannedSurface> scan_of(std::vector<Vec3> points);

}  // namespace planish::slit_detail
