#pragma once

#include <planish/job/maker.hpp>

namespace planish::job {

/// A drawing of the part as PDF: the folded part, the facts, the flat pattern with sizes and bend
/// lines, the table of bends, warnings. Error: `cannot_draw`.
Result<std::string> part_drawing(const Made& made, int piece);

}  // namespace planish::job
