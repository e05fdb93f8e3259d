#pragma once

#include <planish/sheet/flat_pattern.hpp>

namespace planish::sheet_detail {

/// The free borders of the flat sheet, chained into closed contours; the outer one first.
struct Contours {
  Contour outer;
  std::vector<Contour> openings;
  std::vector<std::pair<FeatureId, Loop>> formed;  ///< feature, outline: drawn, not cut
};

/// Walks along free borders and across joints, so that contours close by topology, not by nearness.
/// Errors: `closed_loop` if the borders do not bound one region (every border is joined); a
/// feature's own error if it reaches the outer contour.
Result<Contours> chain_contours(const Sheet& sheet, const Layout& layout,
                                const FlattenOptions& options);

/// Neighbouring curves that are one line or circle within `tolerance` joined, with their origins
/// (`merged`). Each curve has its list of origins.
Contour joined_contour(const Contour& contour, double tolerance);

}  // namespace planish::sheet_detail
