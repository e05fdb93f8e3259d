#include <planish/sheet/flat_pattern.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish {

Place part_place(const FlatPattern& pattern, const PartId& part) {
  if (const auto* flange = std::get_if<FlangeId>(&part))
    return place::flange(index_of(*flange) + 1);
  const BendId id = std::get<BendId>(part);
  for (const FlatBend& bend : pattern.bends)
    if (bend.bend == id) return place::bend(bend.id);
  return place::bend(fmt::format("B{}", index_of(id) + 1));
}

bool has_order(const FlatPattern& pattern) {
  return std::ranges::any_of(pattern.bends,
                             [](const FlatBend& bend) { return bend.stroke.has_value(); });
}

}  // namespace planish
