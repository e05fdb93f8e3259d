#pragma once

#include <planish/job/maker.hpp>

#include <vector>

namespace planish::job {

/// A maker's own options, followed by those of every flat pattern: DXF, overlaps, density.
std::vector<OptionUse> with_pattern_options(std::vector<OptionUse> own);

/// The same, and those of a pattern that a press brake can bend.
std::vector<OptionUse> with_bending_options(std::vector<OptionUse> own);

/// Schemas of the makers' input files; the parsers accept nothing else.
const schema::Schema& plates_schema();
const schema::Schema& transition_schema();
const schema::Schema& slits_schema();

}  // namespace planish::job
