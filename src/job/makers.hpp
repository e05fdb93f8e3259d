#pragma once

#include <planish/job/maker.hpp>

#include <vector>

namespace planish::job {

/// The rows of the table of makers.
Maker unfold_maker();
Maker connect_maker();
Maker transition_maker();
Maker slit_maker();

/// A maker's own options, and behind them those that every flat pattern has: what the DXF is like,
/// overlaps, the density.
std::vector<OptionUse> with_pattern_options(std::vector<OptionUse> own);

}  // namespace planish::job
