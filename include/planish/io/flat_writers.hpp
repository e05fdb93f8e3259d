#pragma once

#include <planish/base/length_unit.hpp>
#include <planish/base/result.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace planish {

enum class LayerProfile { standard, inventor, onshape, solid_edge };
enum class DxfVersion { r2000, r12 };
enum class Splines { arcs, keep };
enum class BendMarks { lines, ticks };

/// Layer names of a profile. `bend_zone` is empty where the profile has none. Inventor names a
/// layer for formed features; the other profiles get a similar one, with neither BEND nor TANGENT
/// in its name, because readers look for these words. Slits are lines that nothing closes: they
/// have a layer of their own, but where all that is cut is on one.
struct LayerNames {
  std::string outer, openings, bend_up, bend_down, bend_zone, features, slits;
};
LayerNames layer_names(LayerProfile profile);

enum class BendLinetype { dashed, continuous };

struct DxfOptions {
  LayerProfile profile = LayerProfile::standard;
  DxfVersion version = DxfVersion::r2000;
  Splines splines = Splines::arcs;  ///< `keep` is ignored with R12
  double arc_tolerance = 0.01;      ///< mm
  LengthUnit units = LengthUnit::mm;
  BendMarks bend_marks = BendMarks::lines;
  double tick_length = 5.0;    ///< mm, with `ticks`; at most a third of the bend line's length
  bool tangent_lines = false;  ///< ignored where the profile has no layer for them
  bool bend_text = false;      ///< number, direction, angle and radius beside each bend line
  bool turn_to_blank = false;  ///< the longer side of the blank along x, its corner at the origin
  std::optional<LayerNames> layers = {};  ///< in place of the profile's
  BendLinetype bend_linetype = BendLinetype::dashed;
};

/// DXF text of a flat pattern by the rules of shop-floor.md#dxf: one closed polyline (or circle)
/// per contour; bend lines with layer, colour and linetype; units in the header.
///
/// Entities come in the order of work: bend lines, tangent lines, formed features, slits (a LINE
/// or ARC each), openings, outer contour. With `keep`, a contour that holds a
/// spline is a chain of LINE, ARC and SPLINE whose ends meet within 1e-9 of the unit; all others,
/// and all with `arcs`, are closed polylines with arcs of at most half a turn. Reals are written so
/// that they read back as the same double; the enclosed area is that of the pattern, except where
/// splines become arcs (within arc_tolerance × perimeter). Colours: outer contour 7, openings 4,
/// slits 6, bend up 5, bend down 1, bend zone 8, formed features 3. With `bend_text` a TEXT at each
/// bend comes first, on the layer TEXT, colour 8, as high as its bend line has room for, at most 3
/// mm. With `turn_to_blank` the pattern is laid by `laid_by_blank`.
///
/// Errors: `bad_option` (arc_tolerance or tick_length is not positive), `internal` (a contour is
/// empty, has no extent or is not finite).
Result<std::string> dxf_text(const FlatPattern& pattern, const DxfOptions& options = {});

/// A pattern on a sheet, from its coordinates to the sheet's.
struct PlacedPattern {
  const FlatPattern* flat = nullptr;
  Isometry2 placement = Isometry2::Identity();
  std::string name;
};

/// A sheet to be cut, its corner at the origin, x along its length; mm.
struct SheetDrawing {
  double length = 0.0, width = 0.0;
  std::vector<PlacedPattern> parts;
};

/// DXF text of a sheet with parts: each as `dxf_text` writes it, moved. First come the sheet's
/// edge, a closed polyline on the layer SHEET, colour 9, and the names of the parts, a TEXT within
/// each, on the layer PART_NAMES, which is off, colour 8. Neither is to be cut. The
/// option `turn_to_blank` is ignored. Errors: those of `dxf_text`.
Result<std::string> sheet_dxf_text(const SheetDrawing& sheet, const DxfOptions& options = {});

struct SvgOptions {
  double margin = 5.0;  ///< mm
  bool labels = true;   ///< bend ids and angles beside the bend lines
  bool names = true;    ///< labels of points
  bool legend = true;   ///< scale bar, meaning of the lines, size and thickness below the pattern
};
/// Drawing of the flat pattern for people: true size in mm, y up, contours, slits, bend lines (up
/// blue dashed, down red dashed) with labels, formed features thin. Line widths and letters follow
/// the size of the part. The page grows beyond pattern and margin where a label needs it.
std::string svg_text(const FlatPattern& pattern, const SvgOptions& options = {});

/// Writes beside the target and renames, so that a half-written file never appears under its name.
/// A symbolic link is followed and its target replaced; a device or pipe is written directly.
/// Errors: `cannot_write` with the system's reason; the target is then unchanged.
Result<void> write_file(const std::filesystem::path& target, const std::string& content);

/// A file to write, its content ready.
struct OutputFile {
  std::filesystem::path path;
  std::string content;
};
/// Writes all of them or none: each beside its target, then devices and pipes, and only when all
/// of that is done, and what is to be done before they appear, are the files renamed, which hardly
/// ever fails. Errors: those of `write_file`, of the first that cannot be written; that of
/// `before_they_appear`.
Result<void> write_files(const std::vector<OutputFile>& files,
                         const std::function<Result<void>()>& before_they_appear = {});

/// `cannot_write` where `write_file` would fail for what can be known beforehand: the target is a
/// folder or write-protected, or its folder is missing or write-protected.
Result<void> check_writable(const std::filesystem::path& target);

/// Makes a folder, and those above it. Error: `cannot_write`.
Result<void> make_folder(const std::filesystem::path& folder);

/// `cannot_write` of a file or folder, for a reason.
tl::unexpected<Error> cannot_write(const std::filesystem::path& file, const std::string& reason);

}  // namespace planish
