#pragma once

#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/sheet.hpp>

#include <optional>
#include <vector>

namespace planish::test {

/// A bend about a circular cylinder.
struct Turn {
  Angle angle;
  double inside_radius = 0.0;
  BendDirection direction = BendDirection::up;
};

/// A bend about a right cone. `near_distance` is the distance from the cone's apex to the nearer
/// end of the rim, on the reference skin; the apex lies on the rim's line, before its start.
struct ConeTurn {
  Angle azimuth;     ///< azimuth range U on the cone
  Angle half_angle;  ///< ω
  double near_distance = 0.0;
  BendDirection direction = BendDirection::up;
};

/// A bend of no radius: the reference skin is sharp, the other one mitred.
struct Crease {
  Angle angle;
  BendDirection direction = BendDirection::up;
};

/// A straight border where the sheet goes on. The frame's origin is the start of the border, x
/// points away from the material in the tangent plane, y runs along the border, z is the outward
/// normal of the reference skin.
struct Rim {
  Frame frame;
  double length = 0.0;
  std::optional<BorderRef> border;  ///< empty at the very start of a strip
  std::optional<BendId> sharp;      ///< the crease that is crossed when the sheet goes on here
};

/// Assembles a Sheet face by face in closed form, without a kernel. "Up" is towards the outward
/// normal of the reference skin: an up bend has the reference skin on its inside.
class SheetBuilder {
 public:
  explicit SheetBuilder(double thickness);

  /// A new flange of one face. Loops are (x, y) in the frame: outer first, counter-clockwise.
  FaceId flange(const Frame& frame, const std::vector<Loop>& loops);
  /// A flange behind a rim: its local x runs against the rim's y with the origin at the rim's end,
  /// y away from the rim. Border 0 of the outer loop must be the segment (0,0) → (rim.length,0).
  FaceId flange_behind(const Rim& rim, const std::vector<Loop>& loops);

  /// A cylindrical or conical bend behind a rim, as wide as the rim; returns its far rim.
  Rim bend(const Rim& rim, const Turn& turn);
  Rim bend(const Rim& rim, const ConeTurn& turn);
  /// The rim turned by a crease: the next flange is folded sharply.
  Rim crease(const Rim& rim, const Crease& fold);

  /// Another face of bend `id`, loops in the (u, v) of its surface.
  FaceId bend_face(BendId id, const Developable& surface, int sense,
                   const std::vector<Loop>& loops);
  BendId new_bend(const Bend& bend);
  void join(const BorderRef& a, const BorderRef& b, std::optional<BendId> sharp = {});

  /// The rim along a straight border of a flange's outer loop, or of another of its loops.
  Rim rim(FaceId flange_face, int border, int loop = 0) const;

  /// The finished sheet: edges numbered from 1 (a joint's two borders share theirs) with their
  /// lengths on the reference skin, and the volume of the solid between the skins.
  Sheet finish();

 private:
  FaceId add_face(Face face, const std::vector<Loop>& loops);
  void continue_from(const Rim& rim, FaceId face);
  double sharp_volume() const;

  Sheet sheet_;
};

/// The cylinder of a bend behind a rim: azimuth 0 at the rim, growing away from it. Its axis runs
/// with the rim for down bends (v from the rim's start), against it for up bends (v from its end).
Cylinder cylinder_behind(const Rim& rim, const Turn& turn, double thickness);
/// The rim after the turn.
Frame turned(const Frame& rim, const Turn& turn, double thickness);

/// Segments through the points and back to the first.
Loop polygon(const std::vector<Vec2>& points);
/// (0,0) → (width,0) → (width,height) → (0,height).
Loop rectangle(double width, double height);
/// A full circle as an opening (clockwise), one arc.
Loop circular_opening(const Vec2& center, double radius);
/// An obround opening: two arcs of the radius, centres half of `straight` from the middle along
/// the direction `angle`.
Loop obround_opening(const Vec2& center, double straight, double radius, Angle angle);

/// Length of a border on the reference skin, by Gauss quadrature (relative error below 1e-12 for
/// smooth borders).
double skin_length(const Face& face, const Curve2& uv);
/// Volume between a face of the reference skin and the skin `thickness` below it, side walls
/// along the normals: the area of the surface half-way, developed, times the thickness.
double volume_under(const Face& face, double thickness);

}  // namespace planish::test
