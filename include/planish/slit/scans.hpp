#pragma once

#include <planish/slit/folded_slit_sheet.hpp>
#include <planish/slit/session.hpp>

#include <Eigen/Geometry>

#include <limits>
#include <vector>

namespace planish {

/// Points measured on a whole sheet, by the strips on which they lie: each by the strip that it is
/// nearest to. Points nearest to a panel, or farther than `farthest` (mm) from the sheet, lie on
/// none. Of a symmetric sheet the half that is not modelled counts as the one that is. More than
/// 200,000 points are thinned out evenly. Requires a valid sheet (`check`).
std::vector<SlitScan> by_strip(const std::vector<Vec3>& cloud, const FoldedSlitSheet& sheet,
                               double farthest = std::numeric_limits<double>::infinity());

/// Solves a session of a design whose scans name no strip, or lie only roughly where the sheet is
/// (`align`; not both at once): strips are solved, points are given to the strips that they are
/// nearest to, or scans moved rigidly to the strips (ICP), in turn, until all are still, at most 30
/// times. Returns how the scans were moved. Errors: those of `SlitSession`; `empty_scan` (no point
/// is near a strip).
Result<Eigen::Isometry3d> follow_scans(SlitSession& session, SlitDesign design, bool align,
                                       const SlitSolveOptions& options = {},
                                       const Progress& progress = {});

/// Whether points have still to be given to strips.
bool has_cloud(const SlitDesign& design);
/// These points.
std::vector<Vec3> cloud_of(const SlitDesign& design);
/// The design with scans of strips in their place.
SlitDesign with_shares(SlitDesign design, const std::vector<SlitScan>& shares);

}  // namespace planish
