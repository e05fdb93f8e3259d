#pragma once

#include <planish/base/result.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/named_file.hpp>
#include <planish/slit/mould.hpp>
#include <planish/slit/slit_sheet.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planish::job {

/// The content of a slit file (formats.md#slits; docs/slit.md), lengths in mm.
struct SlitFile {
  SlitDesign design;
  int subdivisions = 0;
  bool align_scans = false;
  MouldOptions mould;
  double kerf = 0.0;                  ///< width of the slits; 0: lines
  double stop_hole = 0.0;             ///< diameter at the ends of slits; 0: none
  LengthUnit units = LengthUnit::mm;  ///< of the file
};

/// Reads a slit file; files of scanned points and of a material are sought in `folder`, and not
/// read without one. Errors: `invalid_input` for anything that is not JSON (`where` is
/// name:line:column), unknown, repeated and missing keys, values of the wrong type or out of range
/// (`where` is name and JSON pointer), and points that cannot be read (`where` is file:line);
/// `cannot_read` for these files. `SlitSession` checks the design itself.
Result<SlitFile> parse_slits(const std::string& json, const std::string& name,
                             const std::optional<std::filesystem::path>& folder);

/// The files of scanned points and of a material that a slit file refers to, valid or not.
std::vector<NamedFile> slit_files_of(const std::string& json);

/// Points as text, "x y z" on each line, separated by blanks, tabs, commas or semicolons; `#`
/// begins a comment, empty lines are skipped. A comma in numbers separated by blanks, tabs or
/// semicolons is a decimal comma. Further numbers on a line (colours, normals) are skipped too.
/// `scale`: mm per unit. Errors: `invalid_input` with name:line.
Result<std::vector<Vec3>> parse_points(const std::string& text, const std::string& name,
                                       double scale);

}  // namespace planish::job
