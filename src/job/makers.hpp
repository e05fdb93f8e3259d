#pragma once

#include <planish/job/maker.hpp>

#include <vector>

namespace planish::job {

/// A maker's own options, followed by those of every flat pattern: DXF, overlaps, density.
std::vector<OptionUse> with_pattern_options(std::vector<OptionUse> own);

/// The same, and those of a pattern that a press brake can bend.
std::vector<OptionUse> with_bending_options(std::vector<OptionUse> own);

}  // namespace planish::job
