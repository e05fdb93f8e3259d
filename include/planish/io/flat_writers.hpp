#pragma once

#include <filesystem>
#include <planish/base/result.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <string>

namespace planish {

enum class LengthUnit { mm, inch, m };
/// Millimetres in one unit.
double millimetres_in(LengthUnit unit);

enum class LayerProfile { standard, inventor, onshape, solid_edge };
enum class DxfVersion { r2000, r12 };
enum class Splines { arcs, keep };
enum class BendMarks { lines, ticks };

struct DxfOptions {
  LayerProfile profile = LayerProfile::standard;
  DxfVersion version = DxfVersion::r2000;
  Splines splines = Splines::arcs;   ///< `keep` is ignored with R12
  double arc_tolerance = 0.01;       ///< mm
  LengthUnit units = LengthUnit::mm;
  BendMarks bend_marks = BendMarks::lines;
  bool tangent_lines = false;
};

/// DXF text of a flat pattern by the rules of SHOPFLOOR: one closed polyline (or circle) per
/// contour, bend lines with layer, colour and DASHED linetype at once, units in the header.
Result<std::string> dxf_text(const FlatPattern& pattern, const DxfOptions& options = {});

struct SvgOptions {
  double margin = 5.0;  ///< mm
  bool labels = true;   ///< bend ids and angles beside the bend lines
};
/// Drawing of the flat pattern for people: true size in mm, y up, contours, bend lines (up solid
/// blue-ish dashed, down red dashed) with labels, formed features thin.
std::string svg_text(const FlatPattern& pattern, const SvgOptions& options = {});

/// Writes beside the target and renames, so that no half-written file is ever seen under the name.
/// Errors: `cannot_write` with the reason of the system.
Result<void> write_file(const std::filesystem::path& target, const std::string& content);

/// Layer names of a profile.
struct LayerNames {
  std::string outer, openings, bend_up, bend_down, bend_zone;
};
LayerNames layer_names(LayerProfile profile);

}  // namespace planish
