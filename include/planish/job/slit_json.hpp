#pragma once

#include <planish/base/result.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/named_file.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planish::job {

/// What a slit file says (formats.md#slits; docs/slit.md), lengths in mm.
struct SlitFile {
  SlitDesign design;
  int subdivisions = 0;
  bool align_scans = false;
  double kerf = 0.0;                  ///< width of the slits; 0: lines
  double stop_hole = 0.0;             ///< diameter at the ends of slits; 0: none
  LengthUnit units = LengthUnit::mm;  ///< of the file
};

/// Reads a slit file; files of scanned points are sought in `folder`, and left unread without one.
/// Errors: `invalid_input` for anything that is not JSON (`where` is name:line:column), unknown,
/// repeated and missing keys, values of another kind or outside their range (`where` is name and
/// JSON pointer), and points that cannot be read (`where` is file:line); `cannot_read` for files of
/// points. What designs must be is left to `SlitSession`.
Result<SlitFile> parse_slits(const std::string& json, const std::string& name,
                             const std::optional<std::filesystem::path>& folder);

/// The files of scanned points that a slit file names, valid or not.
std::vector<NamedFile> point_files_of(const std::string& json);

/// Points as text, "x y z" a line, blanks, tabs, commas or semicolons between; `#` begins a
/// comment, empty lines are passed over. Where blanks, tabs or semicolons stand between numbers a
/// comma in them is a decimal comma. More numbers in a line (colours, normals) are passed over too.
/// `scale`: mm in one of their units. Errors: `invalid_input` with name:line.
Result<std::vector<Vec3>> parse_points(const std::string& text, const std::string& name,
                                       double scale);

}  // namespace planish::job
