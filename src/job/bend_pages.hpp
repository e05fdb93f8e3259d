#pragma once

#include <planish/brake/stage_pictures.hpp>
#include <planish/io/pages.hpp>
#include <planish/job/report.hpp>
#include <planish/job/request.hpp>

#include <vector>

namespace planish::job {

/// A bend plan to hang at the machine, A4 upright: the part with its flat pattern, bends numbered
/// in the order of the strokes; then each stroke with the way the sheet lies, the workpiece between
/// the tools, gauge, tools with their segments, force, and what is turned since the stroke before.
/// Requires the pictures of the plan's strokes; without a plan there is the first page alone.
std::vector<Page> bend_pages(const Report& report, const Bending& bending,
                             const std::vector<StrokePicture>& pictures);

}  // namespace planish::job
