#include "loops.hpp"

#include "orientation.hpp"
#include "refusals.hpp"

#include <planish/base/union_find.hpp>
#include <planish/connect/codes.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/sheet/layout.hpp>

#include <string>

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

tl::unexpected<Error> loop_error(const Parts& parts, int bend, const char* why) {
  Facts facts = plates_of(parts, bend);
  facts.emplace_back("bend", place::pointer("/bends/" + std::to_string(bend)));
  facts.emplace_back("why", why);
  return fail(refuse::closes_loop, facts);
}

}  // namespace

Result<void> check_loops(const Parts& parts, const Assembled& made, double k_factor) {
  const auto bend = closing_bend(parts);
  if (!bend) return {};
  if (!has_two_sides(parts)) return loop_error(parts, *bend, "the loop turns the sheet over");
  const FlattenOptions options{.allowance = ConstantK{k_factor}, .root = made.root};
  const auto layout = lay_out(made.sheet, options);
  if (layout || layout.error().code != code::closed_loop) return {};
  return loop_error(parts, *bend, "the loop does not lie flat");
}

}  // namespace planish::connect_detail
