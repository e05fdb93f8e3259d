#pragma once

#include <planish/sheet/allowance.hpp>
#include <planish/sheet/sheet.hpp>

namespace planish {

/// Where a contour curve came from: border pieces of the sheet it covers, in order.
struct Origin {
  BorderRef border;
  bool gap = false;  ///< a straight piece across a sharp bend, which no border gives
  Curve2 image;      ///< exact image in the pattern, before recognition and merging
};

/// A closed contour of the pattern. origins[i] belongs to loop[i].
struct Contour {
  Loop loop;
  std::vector<std::vector<Origin>> origins;
};

enum class BendDirection { up, down };

/// A bend in the flat pattern, seen from the side that faces up.
struct FlatBend {
  std::string id;  ///< "B1", …
  BendId bend{};
  BendKind kind = BendKind::cylinder;
  Angle angle;
  double inside_radius = 0.0;
  BendAllowance allowance;
  BendDirection direction = BendDirection::up;
  std::vector<Segment> lines;          ///< bend line or press lines, cut where there is no material
  std::vector<Angle> line_angles;      ///< what the sheet is bent by at each of `lines`
  std::vector<Segment> tangent_lines;  ///< limits of the bend zone, cut likewise
  double length = 0.0;  ///< sum of the lengths of `lines`; of press lines, side by side, their mean
};

/// A formed feature in the flat pattern: outlines only.
struct FlatFeature {
  std::string kind;
  std::vector<Loop> outlines;
};

/// A named point of the flat pattern.
struct FlatLabel {
  Vec2 at;
  std::string text;
};

/// The flat pattern. Coordinates in mm, the chosen side facing up (towards +z).
struct FlatPattern {
  double thickness = 0.0;
  Contour outer;
  std::vector<Contour> openings;
  std::vector<Segment> slits;  ///< cuts without width, each once; see `cut_slits` in slots.hpp
  std::vector<FlatBend> bends;
  std::vector<FlatFeature> features;
  std::vector<FlatLabel> labels;
  std::vector<Isometry2> placement;    ///< by face: developed plane → pattern
  std::vector<double> neutral_offset;  ///< by face: neutral surface from the reference skin along
                                       ///< the surface normal
  std::vector<Loop> face_outlines;     ///< by face: image of loops[0] (for overlap checks)
  std::vector<std::vector<Loop>> face_openings;  ///< by face: images of loops[1…]
  double area = 0.0;                             ///< of one side, openings taken out, mm²
  double perimeter = 0.0;                        ///< all cutting length, slits once, mm
  double closure = 0.0;  ///< largest mismatch met where joints close a cycle, mm
};

/// Sides of the smallest rectangle, in any direction, that the pattern is cut from, longer first,
/// mm; zero for an empty pattern. Curves are measured to 1e-4 mm.
Vec2 blank_size(const FlatPattern& pattern);

enum class UpSide { automatic, reference, other };

struct FlattenOptions {
  AllowanceRule allowance = ConstantK{};
  std::vector<std::pair<BendId, double>> bend_k = {};  ///< K of single bends, before `allowance`
  std::optional<FaceId> root = std::nullopt;  ///< face that stays where it is; default: largest
                                              ///< flange face
  /// The pattern stays in the coordinates of the root face; else it is laid along the axes, the
  /// longest bend line along x, its lower left corner at the origin.
  bool keep_root = false;
  UpSide up = UpSide::automatic;    ///< automatic: the side from which more bends go up
  double curve_tolerance = 1e-4;    ///< mm: image of curves that are neither lines nor arcs
  double merge_tolerance = 1e-5;    ///< mm: recognition of lines, arcs, circles
  double closure_tolerance = 0.01;  ///< mm: cycles of joints that close within this are no loop
};

/// Lays the sheet flat: unfolding tree over the joints (longest first), each face developed at its
/// neutral surface and placed by border trihedrons (MATH 4.2), free borders chained to contours.
/// Errors: `closed_loop` (a cycle of joints does not close; the message proposes the rip),
/// `not_a_sheet` (faces not connected), errors of `bend_allowance`.
Result<FlatPattern> flatten(const Sheet& sheet, const FlattenOptions& options = {});

}  // namespace planish
