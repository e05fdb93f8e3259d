#pragma once

#include <planish/io/pages.hpp>
#include <planish/job/maker.hpp>

#include <vector>

namespace planish::job {

/// The bend plan of a report on pages to hang at the machine: the part and its flat pattern with
/// the bends numbered in order, then each stroke. `bending` is that of its request. A report
/// without strokes gives the first page alone.
std::vector<Page> bend_plan_pages(const Report& report, const Bending& bending);

enum class PageFormat { pdf, svg };
/// Those pages of all pieces, as a file. Error: `internal` (Cairo fails).
Result<std::string> bend_plan_file(const Made& made, const Bending& bending, PageFormat format);

}  // namespace planish::job
