#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/connect/edge_search.hpp>
#include <planish/connect/plates.hpp>
#include <planish/sheet/sheet.hpp>

#include <array>
#include <optional>
#include <vector>

namespace planish {

/// The axes of slope, offset and apex of a bend (math.md#bend-fitting): the intersection line of
/// the plates' planes runs through `origin` along `d`; side i lies along e[i]. Parallel planes do
/// not meet: then e[0] = e[1], and `rise` leads from the plane of side 0 to that of side 1.
struct BendFrame {
  Vec3 origin = Vec3::Zero();
  Vec3 d = Vec3::UnitX();
  std::array<Vec3, 2> e{Vec3::UnitY(), Vec3::UnitY()};
  Vec3 rise = Vec3::Zero();
  Angle beta;  ///< between e[0] and e[1]; 0 for parallel planes

  bool parallel() const { return beta == Angle(); }
  Vec3 side_origin(int side) const { return side == 0 ? origin : Vec3(origin + rise); }
  Vec2 local(int side, const Vec3& p) const {
    return {(p - origin).dot(d), (p - side_origin(side)).dot(e[side])};
  }
  Vec3 point(int side, const Vec2& xy) const {
    return side_origin(side) + xy.x() * d + xy.y() * e[side];
  }
};

/// Another way to join the same plates, as the request for it.
struct BendAlternative {
  BendRequest request;
  BendKind kind = BendKind::cylinder;
  EdgeKind edge_kind = EdgeKind::facing;
  double width = 0.0, span = 0.0;
};

/// A shorter bend than the one that was taken, which the search had found first, and why it does
/// not hold.
struct PassedOver {
  std::array<std::vector<int>, 2> edges;  ///< by plate, ascending
  double span = 0.0;                      ///< math.md#widest-bend
  Error why;
};

/// A further stretch of an interrupted bend: the edges that it joins, and how wide it is.
struct BendStretch {
  std::array<std::vector<int>, 2> edges;  ///< by plate, ascending
  double width = 0.0;                     ///< mm
};

/// A fitted bend, with everything that was chosen. Lengths on the mid-surface, mm.
struct FittedBend {
  BendRequest request;                    ///< as it was given
  std::vector<int> plates;                ///< indices into the structure's plates: two, one or none
  std::array<std::vector<int>, 2> edges;  ///< by plate, ascending
  std::vector<BendStretch> stretches;     ///< besides that of `edges`
  EdgeKind edge_kind = EdgeKind::facing;
  BendKind kind = BendKind::cylinder;
  BendFrame frame;
  TangentLine line;
  std::optional<double> apex;            ///< x₀ of cones
  Angle angle;                           ///< through which the sheet is turned from plate to plate
  double inside_radius = 0.0;            ///< of cones at mid-length
  std::array<double, 2> inside_radii{};  ///< at the left (lower x) and at the right end
  std::optional<Angle> half_angle;       ///< of cones
  LateralBoundary lateral = LateralBoundary::straight;
  double width = 0.0, span = 0.0;  ///< of the edges, math.md#widest-bend
  double reach = 0.0;              ///< the span without the shift of its ends
  double joined = 0.0;             ///< of all stretches together, along the tangent line
  std::array<double, 2> unused{};  ///< by plate, what its edges on the tangent line leave free
  /// How far both plates' joints lie beside each other along the tangent line; empty if they have
  /// some width in common.
  std::optional<double> beside = {};
  double extension_area = 0.0;                ///< math.md#least-extension, at `line`
  std::vector<BendAlternative> alternatives;  ///< the other efficient bends, the widest first
  std::optional<PassedOver> passed_over;
  BendId bend{};  ///< index into the sheet's bends
};

/// A plate that was cut back where it touches others.
struct TrimmedPlate {
  int plate = 0;
  double by = 0.0;  ///< at most, mm
};

/// A stretch of an edge that two plates have in common, or a corner (`from` = `to`).
struct SharedEdge {
  std::array<int, 2> plates{};
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
};

/// Joined plates: a sheet whose flange i is plate i, extended, and how they were joined.
struct Connection {
  PlateStructure structure;
  Sheet sheet;
  std::vector<FittedBend> bends;
  std::vector<FaceId> plate_faces;  ///< by plate
  FaceId root{};                    ///< face of the root plate; without plates, of the first bend
  std::vector<TrimmedPlate> trimmed = {};
  std::vector<SharedEdge> left_open = {};  ///< along which plates touch without being joined there
};

struct ConnectOptions {
  /// Neutral surface of bends, at k·t from the inside: a straight lateral boundary is straight
  /// there.
  double k_factor = 0.44;
  /// Cones of a smaller slope become cylinders.
  double smallest_slope = 1e-3;
  /// The largest number of other ways to join the same two plates that each bend reports.
  int alternatives = 12;
  double planarity = 1e-3;  ///< how far a corner may lie off its plate's plane, mm
};

/// Joins plates by bends and chooses what is not given of them (math.md#bend-fitting). To join the
/// same plates again after one has moved, give the requests of the bends that were found. `where`
/// of an error is the place of its cause in the structure, written as a JSON pointer
/// (formats.md#plates): "/plates/2/outline/3", "/bends/0/inside_radius".
/// Errors (exit status 3): `invalid_input` (numbers not finite, thickness not positive),
/// `too_few_corners`, `repeated_corner`, `not_planar`, `self_crossing`, `unknown_plate`,
/// `unknown_edge`, `bend_loop` (a loop of the bends given does not lie flat), `not_connected` (they
/// leave a plate unconnected).
/// Errors (exit status 4): `plates_intersect`, `plates_touch`, `plates_coplanar`, `plates_offset`
/// (parallel planes that no half-turn joins), `no_bend_fits` (with the feasible range of what was
/// given), `radius_too_small` (thickness too large for the radius), `apex_in_span`,
/// `no_common_width`, `too_far_apart` (beyond the largest span), `overlap` (the extensions of a
/// plate run into each other or over it).
/// Error (exit status 1): `cancelled`.
Result<Connection> connect(const PlateStructure& structure, const ConnectOptions& options = {},
                           const Progress& progress = {});

/// The sheet with its seam open for a solid: the ends of a section that closes on itself are set
/// 0.01 mm apart, since a solid may not touch itself. Other sheets are unchanged.
Sheet with_open_seam(const Sheet& sheet);

}  // namespace planish
