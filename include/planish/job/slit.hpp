#pragma once

#include <planish/base/progress.hpp>
#include <planish/job/report.hpp>
#include <planish/job/slit_json.hpp>
#include <planish/slit/session.hpp>

#include <string>
#include <vector>

namespace planish::job {

/// Whether a report lists every ridge.
enum class Ridges { told, left_out };

/// The result of bending a slit sheet. There may be a shape even without a pattern, if some strips
/// stay out of reach.
struct SlitReport : Report {
  SlitDesign design;  ///< as solved: ridges as subdivided
  std::vector<StripState> strips;
  FoldedSlitSheet folded;
  std::optional<SlitEquilibrium> equilibrium = {};  ///< of a sheet with a material
  double gap = 0.0;                                 ///< largest of all strips, mm
  std::vector<double> leg_scales;  ///< by which each panel's leg curve was scaled to the sheet
  double flat_deviation = 0.0;     ///< largest distance of a corner of the developed sheet from its
                                   ///< place in the sheet as cut, mm
  Eigen::Isometry3d scan_motion = Eigen::Isometry3d::Identity();  ///< that aligned the scans
};

/// Solves the strips coarse to fine, lays the folded sheet flat and certifies that it is the sheet
/// that was cut. The request's rules do not apply: they are for press brakes. `where` of an error
/// is the file's name, followed by the JSON pointer of the cause. The error shows a report if
/// strips are out of reach; it shows none if the file cannot be read or is invalid: `cannot_read`,
/// those of `parse_slits`, those of `SlitSession::start` with exit status 3.
Outcome<SlitReport> slit(const Request& request, const Progress& progress = {});

/// The same for a file already read (`request.input` only names it).
Outcome<SlitReport> slit_sheet(const SlitFile& file, const Request& request,
                               const Progress& progress = {});

/// The same for a session in its current state (of `file`, only kerf, stop holes and units are
/// used).
Outcome<SlitReport> slit_solved(const SlitSession& session, const SlitFile& file,
                                const Request& request, const Progress& progress = {});

/// Report as JSON text with the keys of formats.md#report, and as text for a terminal.
std::string report_json(const SlitReport& report, Ridges ridges = Ridges::told);
std::string report_text(const SlitReport& report);

}  // namespace planish::job
