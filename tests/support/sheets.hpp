#pragma once

#include "support/sheet_builder.hpp"

#include <planish/geometry/general_cone.hpp>
#include <planish/sheet/certificate.hpp>

#include <random>
#include <variant>
#include <vector>

// Sheets in closed form, made without a kernel. Every sheet has edges numbered from 1, their
// lengths, and the volume of its solid. "Flat length" below is Σ L + Σ α (r + k t) over the parts
// of a strip, k as chosen when flattening.

namespace planish::test {

/// A straight piece of a strip.
struct Straight {
  double length = 0.0;
};
using StripPart = std::variant<Straight, Turn, ConeTurn, Crease>;

/// A strip along +x with its width along +y (0 … width), the reference skin up (+z) at the start:
/// the first part lies at z = 0. Parts follow each other; one straight piece is one flange, its
/// frame the global axes for the first. Bends may follow each other and may end the strip.
/// Flat: flat length × width, less what conical parts turn aside.
Sheet strip(const std::vector<StripPart>& parts, double width, double thickness);

/// Flat length of a strip whose bends all have the K-factor k; creases count α k t from the skin
/// that is sharp inside, −2 t tan(α/2) + α k t where the reference skin is outside.
double flat_length(const std::vector<StripPart>& parts, double thickness, double k);

/// 50 | 90° up r 3 | 30, width 40, t 2.
Sheet l_bracket();
/// The L bent downwards: the same solid mirrored, the reference skin outside.
Sheet l_bracket_down();
/// 30 | 90° up r 2 | 40 | 90° up r 2 | 30, width 25, t 1.5.
Sheet u_channel();
/// 30 | 90° up r 1 | 20 | 90° down r 1 | 30, width 25, t 1.
Sheet z_profile();
/// n steps of 20, each 90° up r 1 then 90° down r 1, width 30, t 1: 2n + 1 flanges.
Sheet staircase(int n);
/// 40 | 180° up r 0.5 | 15, width 20, t 1.
Sheet hem();
/// A base of 100 x 80 x 1 with two flaps of 40 x 30 on one edge, 20 apart and bent alike by 90°,
/// r 1.
Sheet two_flaps();
/// 40 | 250° up r 8 | 4, width 20, t 1.
Sheet turn_of_250();
/// 6 | 270° up r 10 | 60 | 270° up r 10 | 6, width 20, t 1: both ends curled the same way.
Sheet two_turns_of_270();
/// A bend of 300° r 20 alone, width 50, t 1.5: no flange.
Sheet rolled();

/// Open box: base with four walls bent up 90°, square notches of `relief` at the base's corners.
/// `length` × `width` is the base between the tangent lines of opposite bends, walls are `height`
/// long from tangent line to rim and narrower than the base by two reliefs.
/// Flat: (length + 2 (height + π/2 (r + k t))) × the same with width; four corners of
/// relief + height + π/2 (r + k t) squared are missing.
struct BoxSize {
  double length = 80.0, width = 50.0, height = 25.0;
  double thickness = 1.5, inside_radius = 2.0, relief = 2.0;
};
Sheet box(const BoxSize& size = {}, BendDirection direction = BendDirection::up);

/// Flange `first` long | conical bend | flange `second` long, both flanges rectangles as wide as
/// the bend. Flat: two rectangles and a sector of angle U sin ω between them.
struct ConeJoint {
  ConeTurn turn{Angle::degrees(70), Angle::degrees(20), 60.0, BendDirection::up};
  double width = 50.0, first = 40.0, second = 30.0, thickness = 1.5;
};
Sheet cone_joined(const ConeJoint& joint = {});

/// A cone frustum rolled from sheet, open along a gap: outside radii r1 < r2 at the ends of
/// `height` along the axis, azimuth range `sweep`. The reference skin is outside (sense +1), no
/// flange. Flat at K = ½: annular sector of angle sweep·sin ω, radii s + (t/2)·(1 − 2) / tan ω
/// at both ends, s = r / sin ω, tan ω = (r2 − r1) / height.
Sheet truncated_cone(double r1, double r2, double height, Angle sweep, double thickness);

/// Two plates like those of a transition at one of its corners, triangles with the corner at `apex`
/// cut off, tangent to the oblique cone between them: the cone over the conic arc from p0 to p1.
/// Both plates are `width` wide at the arc, all three end at `near` of the way from the apex. The
/// outward normal of the reference skin is that of c′ × (c − apex): turn p0 and p1 round for the
/// other skin.
struct LoftedCorner {
  Vec3 apex{0, 0, 100};
  Vec3 p0{60, -20, 0}, tangent_point{62, 34, 0}, p1{10, 45, 0};
  double near = 0.4, width = 50.0, thickness = 1.5;
  SpaceCurve arc() const { return conic_arc(p0, tangent_point, p1); }
};
Sheet lofted_corner(const LoftedCorner& corner = {});
/// The same with the reference skin on the other side.
LoftedCorner other_side(LoftedCorner corner);

/// 100 × 60 plate, t 3, with holes: Ø10 at (20, 30), Ø6.6 at (80, 15), obround 20 × 8 at (60, 40)
/// turned by 30°.
Sheet plate_with_holes();
/// A full disc of radius r with a concentric hole: every border a circle.
Sheet ring(double outer_radius, double inner_radius, double thickness);

/// How an opening meets the bend of a strip `first | turn | second`.
struct Opened {
  double first = 40.0, second = 30.0, width = 60.0, thickness = 2.0;
  Turn turn{Angle::degrees(90), 4.0, BendDirection::up};
};
/// A rectangular slot of width `slot` (in y, centred) from 8 mm before the bend to 8 mm behind it:
/// the bend is two faces, four joints in all.
Sheet slot_across_bend(double slot = 12.0, const Opened& part = {});
/// The same slot ending half-way round the bend: one bend face, two joints on the first side, one
/// on the other.
Sheet slot_into_bend(double slot = 12.0, const Opened& part = {});
/// A circle of `diameter` in the flat pattern made with `k`, centred on the bend line and within
/// the bend zone: an opening of the bend face, its border a spline in (u, v).
Sheet hole_in_bend(double diameter, double k, const Opened& part = {});
/// A circle in the flat pattern made with `k`, centred on the bend line and wider than the bend
/// zone: arcs on both flanges, splines on two bend faces.
Sheet hole_across_bend(double diameter, double k, const Opened& part = {});

/// A random tree of `bends` bends (fewer where no place is left): rectangular and trapezoid flanges
/// as wide as the side they sit on or narrower, bends of 5°–150°, radii of 0.3–5 t, up and down,
/// openings in the flanges. Neither the folded solid nor the flat pattern covers itself; this is
/// checked on sampled points, and drawn again where it fails.
Sheet random_sheet(std::mt19937& random, int bends);

/// Moves the sheet in space; its flat pattern must not care.
Sheet moved(Sheet sheet, const Eigen::Isometry3d& motion);
/// Multiplies every length.
Sheet scaled(Sheet sheet, double factor);

/// The same sheet with its cylinders and cones given as general developables, knots at most `step`
/// of azimuth apart; positions agree to about radius · step⁴ / 384.
Sheet as_ruled(Sheet sheet, Angle step);

/// Distance from a point to an edge of the reference skin by its number, accurate to 1e-9 of the
/// edge's size, for `certify`.
EdgeDistance edge_distance(const Sheet& sheet);

/// The part of an ellipse that a circle of the flat pattern becomes in the (u, v) of a cylinder:
/// center + (radius_u cos φ, radius_v sin φ), φ from start to start + sweep. As good as the cubic
/// pieces are: within 1e-8 of the radii.
CubicSpline elliptic_arc(const Vec2& center, double radius_u, double radius_v, double start,
                         double sweep);

}  // namespace planish::test
