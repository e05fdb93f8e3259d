#pragma once

#include "part_list.hpp"
#include "stock.hpp"

#include <planish/io/pages.hpp>

#include <string>
#include <vector>

namespace planish::pack {

/// The drawing of one part.
std::vector<Page> drawing_of(const PackPart& part);

/// The cover of a pack: its groups with their parts, a small picture each, sums, the sheets of
/// stock, and what was refused.
std::vector<Page> cover_of(const PartList& list, const StockSheets& stock, const std::string& title,
                           const std::string& currency);

}  // namespace planish::pack
