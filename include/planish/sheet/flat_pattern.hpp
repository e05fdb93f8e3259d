#pragma once

#include <planish/sheet/layout.hpp>

namespace planish {

/// Where a contour curve came from: the borders of the sheet that it covers, in order.
struct Origin {
  BorderRef border;
  bool gap = false;  ///< a segment across a sharp bend, not given by a border
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
  std::vector<Segment> lines;          ///< bend line or press lines, interrupted where there is no
                                       ///< material
  std::vector<Angle> line_angles;      ///< by which the sheet is bent at each of `lines`
  std::vector<Segment> tangent_lines;  ///< limits of the bend zone, interrupted likewise
  double length = 0.0;  ///< sum of the lengths of `lines`; for press lines, which lie side by side,
                        ///< their mean
  std::optional<int> stroke = {};  ///< number of the first that presses it, from 1, if it is known
};

/// A formed feature in the flat pattern: outlines. What is cut within them stands among the
/// pattern's openings and slits.
struct FlatFeature {
  std::string kind;
  FormSide side = FormSide::both;
  std::vector<Loop> outlines;
  int uncut_openings = 0;         ///< openings of the solid within it that the pattern does not cut
  std::vector<Vec2> pilots = {};  ///< middles of openings that are cut smaller than they will be
  std::vector<Vec2> along = {};   ///< middles of the borders that it follows
  std::optional<double> beyond_cut = {};  ///< FormedFeature::beyond_cut
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
  std::vector<Curve2> slits;  ///< cuts without width, each once; see `cut_slits` in slots.hpp
  std::vector<FlatBend> bends;
  std::vector<FlatFeature> features;
  std::vector<FlatLabel> labels;
  double area = 0.0;       ///< of one skin, without openings, mm²
  double perimeter = 0.0;  ///< all cutting length, slits once, mm
  double closure = 0.0;    ///< largest mismatch met where joints close a cycle, mm
  FaceId root{};           ///< the face around which the rest was laid…
  Isometry2 root_placement = Isometry2::Identity();  ///< …and where its developed plane lies
};

/// Checks what everything that writes or measures a pattern relies on: sizes are numbers in range,
/// contours and outlines have regular curves, each line of a bend has its angle. An empty pattern
/// is one. Error: `invalid_sheet`, with the rule that is broken; `where` names the item ("opening
/// 3"), the place is its path in the value ("/openings/3"), or the bend.
Result<void> check(const FlatPattern& pattern);
/// Stops at an assertion that names the rule and the item: for functions that return no `Result`.
void require_valid(const FlatPattern& pattern);

/// A part as a place: flanges are counted from 1, bends have the names of the pattern.
Place part_place(const FlatPattern& pattern, const PartId& part);

/// Whether it is known in which order its bends are pressed.
bool has_order(const FlatPattern& pattern);

/// Sides of the smallest rectangle, at any angle, that contains the pattern, longer first, mm; zero
/// for an empty pattern. Curves are measured to 1e-4 mm.
Vec2 blank_size(const FlatPattern& pattern);

/// The turn and shift that lay the pattern along its blank: the blank's longer side on the x axis,
/// its corner at the origin. Identity for an empty pattern.
Isometry2 laid_by_blank(const FlatPattern& pattern);

/// A sheet laid flat: how its faces lie, and the pattern in the same coordinates.
struct FlatSheet {
  Layout layout;
  FlatPattern pattern;
};

/// Lays the sheet out, chains its free borders to contours and orients the result as the options
/// say. Errors: those of `lay_out`, `unsupported_shape` (a sharp bend whose faces are too narrow to
/// be set back), and that of a formed feature that reaches the outer contour.
Result<FlatSheet> flat_sheet(const Sheet& sheet, const FlattenOptions& options = {});

/// The pattern of `flat_sheet`.
Result<FlatPattern> flatten(const Sheet& sheet, const FlattenOptions& options = {});

}  // namespace planish
