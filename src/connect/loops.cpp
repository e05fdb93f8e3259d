#include "loops.hpp"

#include "orientation.hpp"

#include <planish/base/union_find.hpp>
#include <planish/connect/codes.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/layout.hpp>

#include <fmt/format.h>

namespace planish::connect_detail {
namespace {

// The first bend between plates that others join already.
std::optional<int> closing_bend(const Parts& parts) {
  UnionFind groups(static_cast<int>(parts.plates.size()));
  for (int bend = 0; bend < static_cast<int>(parts.fits.size()); ++bend) {
    const std::vector<int>& plates = parts.fits[bend].report.plates;
    if (plates.size() == 2 && !groups.unite(plates[0], plates[1])) return bend;
  }
  return std::nullopt;
}

Error loop_error(const Parts& parts, int bend, const std::string& why) {
  const std::vector<int>& plates = parts.fits[bend].report.plates;
  return {code::bend_loop,
          fmt::format("the bend between \"{}\" and \"{}\" closes a loop, as they are joined "
                      "already, and {}: leave it out, so that the sheet is open there",
                      parts.ids[plates[0]], parts.ids[plates[1]], why),
          fmt::format("/bends/{}", bend)};
}

}  // namespace

Result<void> check_loops(const Parts& parts, const Assembled& made, double k_factor) {
  const auto bend = closing_bend(parts);
  if (!bend) return {};
  if (!has_two_sides(parts))
    return tl::unexpected(loop_error(parts, *bend, "the loop turns the sheet over"));
  FlattenOptions options;
  options.allowance = ConstantK{k_factor};
  options.root = made.root;
  const auto layout = lay_out(made.sheet, options);
  if (layout || layout.error().code != code::closed_loop) return {};
  return tl::unexpected(loop_error(parts, *bend, "this loop does not lie flat"));
}

}  // namespace planish::connect_detail
