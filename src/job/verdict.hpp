#pragma once

#include <planish/job/report.hpp>

#include <optional>
#include <vector>

namespace planish::job {

/// Warnings about residuals above their bounds, each with its place in the pattern.
std::vector<Finding> doubts(const Certificate& certificate, const FlatPattern& flat,
                            double solid_volume, const CertificateBounds& bounds);

/// `pattern_wrong` if a residual exceeds its refusal bound, or could not be measured although the
/// solid's volume is known.
std::optional<Error> disbelief(const Certificate& certificate, double solid_volume,
                               const CertificateBounds& bounds);

/// What `find_overlaps` found, as a refusal `overlap`; empty without findings.
std::optional<Error> overlap_refusal(const std::vector<Finding>& overlaps);

/// A question about a size that no shop has: most likely the input states another unit than it was
/// drawn in.
std::optional<Finding> size_doubt(double thickness, double blank_length);

/// The errors among the findings as a refusal with the code of the first: a part cut so would be
/// scrap. Overlaps have a refusal of their own. Empty if there are none, and if the files are to be
/// written all the same.
std::optional<Error> error_refusal(const std::vector<Finding>& findings,
                                   const PatternChecks& checks);

}  // namespace planish::job
