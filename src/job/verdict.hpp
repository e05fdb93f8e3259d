#pragma once

#include <planish/job/report.hpp>

#include <optional>
#include <vector>

namespace planish::job {

/// Warnings about residuals above their bounds, each with its place in the pattern.
std::vector<Finding> doubts(const Certificate& certificate, const FlatPattern& flat,
                            double solid_volume, const CertificateBounds& bounds);

/// `pattern_wrong` where a residual is beyond belief, or could not be measured although the solid
/// has a volume to measure against.
std::optional<Error> disbelief(const Certificate& certificate, double solid_volume,
                               const CertificateBounds& bounds);

/// `overlap`: what `find_overlaps` found, as a refusal. None for no findings.
std::optional<Error> overlap_refusal(const std::vector<Finding>& overlaps);

}  // namespace planish::job
