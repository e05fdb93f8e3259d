#pragma once

#include <planish/base/angle.hpp>
#include <planish/slit/bezier.hpp>

#include <array>
#include <optional>
#include <vector>

namespace planish {

/// The flat sheet lies in coordinates (along, across), mm: along from the panel's free edge (0)
/// towards the strips, across from the sheet's left edge (0). Folded, y is up and the ground plane
/// is (x, z).
///
/// A strip as cut. Left is where across is smaller.
struct SlitStrip {
  double width = 0.0;
  double gap = 0.0;  ///< to the previous strip, or to the sheet's edge; the panel continues behind
                     ///< it
  /// Where the slits on its left and on its right begin, along the sheet; default: the panel's
  /// height. The strip's first ridge joins both.
  std::optional<double> left_start = {}, right_start = {};
  std::optional<double> end = {};  ///< where it ends, along; default: panel height + half-length.
                                   ///< Not in symmetric sheets
  /// Where the slits on its left and on its right end, along the sheet; default: where the strip
  /// ends, or the other one ends. The strip's last ridge joins both; from there on the sheet is
  /// uncut, and joins it to its neighbours.
  std::optional<double> left_end = {}, right_end = {};
  /// Its left and right edge where that is a curve, as a chain of lines from the slit's start to
  /// its end; empty: a line along the sheet. With curves `width` is that at the start.
  std::array<std::vector<Vec2>, 2> edges = {};
  friend bool operator==(const SlitStrip&, const SlitStrip&) = default;
};

/// The sheet, or in symmetric sheets the half of it up to the symmetry plane x = 0
/// (math.md#slit-model).
struct SlitSheet {
  double thickness = 0.0;  ///< mm
  double panel_height = 0.0;
  double half_length = 0.0;  ///< of the strips, from the panel to the symmetry plane or to the free
                             ///< end
  std::vector<SlitStrip> strips;
  double margin = 0.0;  ///< between the last strip and the sheet's right edge
  bool symmetric = true;
  double min_inside_radius = 0.0;  ///< the smallest that the material allows, mm
  /// Width across, that from the first strip to the last where they end, and the largest along.
  double width() const;
  double breadth() const;
  double reach() const;
  /// Where strips end, along, that have no end of their own.
  double far_line() const { return panel_height + half_length; }
  bool has_strip(int strip) const { return strip >= 0 && strip < std::ssize(strips); }
  /// Whether the uncut sheet beyond the end of the slit on its right joins a strip to the next.
  bool joins_next(int strip) const;
  /// Of strip i: across of its left edge, start and end of both slits, and the later end.
  double left_of(int strip) const;
  std::array<double, 2> start_of(int strip) const;
  std::array<double, 2> ends_of(int strip) const;
  double end_of(int strip) const;
  /// Across of both edges where it ends, how long they are, and the area between them.
  std::array<double, 2> sides_at_end(int strip) const;
  std::array<double, 2> edge_lengths(int strip) const;
  double area_of(int strip) const;
  double width_at_end(int strip) const;
  /// Smallest radius of the mid-surface that the material allows.
  double min_radius() const { return min_inside_radius + 0.5 * thickness; }
  friend bool operator==(const SlitSheet&, const SlitSheet&) = default;
};

/// `count` equal strips side by side.
std::vector<SlitStrip> equal_strips(int count, double width);

/// The panel at the far ends of the strips of a sheet that is not symmetric. Its leg curve runs
/// from the sheet's left side like that of the first panel.
struct SecondPanel {
  BezierCurve leg_curve;
  double height = 0.0;  ///< from the strips' ends to its free edge; of strips with an own `end`
                        ///< the rest of the sheet
  Angle lean;           ///< as `SlitDesign::lean`
  bool fit = false;     ///< as `SlitDesign::fit`
  friend bool operator==(const SecondPanel&, const SecondPanel&) = default;
};

/// The two ends of a ridge, and the two long edges of a strip.
enum class StripEdge { left, right };

/// A place that one end of a ridge should be near. Ridges count from 0 (on the panel) to the
/// strip's end.
struct SlitAnchor {
  int strip = 0;
  int ridge = 0;
  StripEdge side = StripEdge::left;
  Vec3 at = Vec3::Zero();
  friend bool operator==(const SlitAnchor&, const SlitAnchor&) = default;
};

/// Where the free end of a strip must be (not in symmetric sheets); members not given are free.
struct StripEnd {
  std::optional<Vec3> position = {};   ///< of the middle of the last ridge
  std::optional<Vec3> direction = {};  ///< in which the strip ends: away from the panel, along its
                                       ///< long edges
  std::optional<Vec3> across = {};     ///< of the last ridge, from left to right
  friend bool operator==(const StripEnd&, const StripEnd&) = default;
};

/// Points measured on a strip of a model, in the coordinates of the folded sheet. Several scans of
/// one strip add up. Those that name no strip a session leaves out until `by_strip` has given their
/// points to strips.
struct SlitScan {
  std::optional<int> strip = {};
  std::vector<Vec3> points;
};

/// What a sheet is made of, as far as it is elastic.
struct SlitMaterial {
  double young = 0.0;                  ///< N/mm²
  double poisson = 0.3;                ///< at least 0, below 0.5
  std::optional<double> density = {};  ///< kg/dm³
  std::optional<double> yield = {};    ///< N/mm²

  /// Flexural rigidity of a sheet, E t³ / 12 (1 − ν²), N mm.
  double rigidity(double thickness) const;
  /// Bending stress at the skin of a sheet, N/mm², at a curvature of its middle surface.
  double stress(double thickness, double curvature) const;
  /// Curvature that is left when a sheet bent that far is let go: 0 below the yield stress, beyond
  /// it that of an elastic, perfectly plastic sheet (math.md#standing). Needs the yield stress.
  double kept_curvature(double thickness, double curvature) const;
  friend bool operator==(const SlitMaterial&, const SlitMaterial&) = default;
};

/// A force on a strip, N. In symmetric sheets it stands on both halves of the strip together.
struct SlitLoad {
  int strip = 0;
  std::optional<double> at = {};  ///< share of the strip's length, from the panel; spread over the
                                  ///< strip without it
  Vec3 force = Vec3::Zero();
  friend bool operator==(const SlitLoad&, const SlitLoad&) = default;
};

/// How the strips meet the symmetry plane. `right_angle`: the last quad is perpendicular to it, so
/// that both halves join smoothly. `level`: (v_M−1 − v_M)·y = 0, the end term of the paper [slits
/// 3]; equivalent, except that it constrains nothing if the last ridge is upright. `free`: the
/// halves may meet in a fold.
enum class EndAngle { right_angle, level, free };

/// What a strip minimises besides its wishes.
enum class SlitObjective {
  energy,  ///< its bending energy: the shape that a sheet takes by itself (math.md#bending-energy)
  smooth,  ///< second differences of the fold angles [slits 3]
};

/// The weights of the objective (math.md#strip-conditions). Lengths count in thirtieths of the
/// strip's length, angles in radians, so a form does not depend on unit or size; sums over ridges
/// are weighted so that subdivision preserves them.
struct SlitWeights {
  double smooth = 0.04;   ///< second differences of the fold angles [slits 3]
  double spacing = 0.01;  ///< barrier that keeps ridges apart [slits 4]
  double anchors = 0.03;  ///< distance to anchors [slits 5]
  double seat = 0.03;     ///< distance of the strips' ends to the seat curve [slits 5]
  /// Distance of the strips' ends to their places on the seat curve, evenly spaced from one end to
  /// the other in the order of the strips. Without it strips leave gaps where their neighbours
  /// crowd.
  double spread = 0.003;
  double scan = 0.03;  ///< distance of the ridges' ends to scanned points [slits 6]
  friend bool operator==(const SlitWeights&, const SlitWeights&) = default;
};

/// What strips have to do with each other besides that none runs into another: all of them are
/// solved together, and an edit of one moves others.
struct SlitCoupling {
  double smooth = 0.003;  ///< weight of second differences from strip to strip: the middles of
                          ///< corresponding ridges of three neighbours should lie evenly
  std::optional<std::array<double, 2>> gap = {};  ///< least and most, mm: from corner to corner
                                                  ///< where neighbours end
  friend bool operator==(const SlitCoupling&, const SlitCoupling&) = default;
};

/// A slit sheet and the form that it shall take: the content of a file (formats.md#slits).
struct SlitDesign {
  SlitSheet sheet;
  BezierCurve leg_curve;  ///< (x, z): what the panel stands over, from the sheet's left side
  /// By how much the panel is turned about the line through the ends of its leg curve, away from
  /// the sheet's front as by a positive fold; from −90° to 90°, where it is level with the ground.
  Angle lean;
  bool fit = false;  ///< the leg curve is scaled about its start until the sheet fits it
  std::optional<SecondPanel> second_panel;  ///< not in symmetric sheets, and not with `ends`
  std::optional<BezierCurve> seat_curve;    ///< (y, z): section wanted in the symmetry plane
  bool fit_seat = false;                    ///< it is scaled about its start to their breadth
  int ridges = 10;                          ///< of each strip at the start; there are as many quads
  EndAngle end_angle = EndAngle::right_angle;
  SlitObjective objective = SlitObjective::energy;
  SlitWeights weights;
  std::optional<SlitMaterial> material = {};  ///< needed for what follows
  bool gravity = false;                       ///< the sheet's own weight bends it
  std::vector<SlitLoad> loads = {};
  std::optional<SlitCoupling> coupling = {};  ///< with `SlitObjective::energy` only
  bool ground = false;  ///< nothing goes below y = 0, the middle surface stays half a thickness
                        ///< above
  std::vector<SlitAnchor> anchors;
  std::vector<StripEnd> ends;  ///< by strip; missing ones are free. Not in symmetric sheets
  std::vector<SlitScan> scans;
};

}  // namespace planish
