#pragma once

#include <planish/job/report.hpp>

#include <string>

namespace planish::job {

/// The bend plan of a report as a PDF to hang at the machine: the part and its flat pattern with
/// the bends numbered in order, then each stroke. `bending` is that of its request. Errors:
/// `bad_option` (the report has no strokes), those of `pages_pdf`.
Result<std::string> bend_plan_pdf(const Report& report, const Bending& bending);

/// The same as SVG, its pages below one another.
Result<std::string> bend_plan_svg(const Report& report, const Bending& bending);

}  // namespace planish::job
