#include <planish/base/assert.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/slit/folded_slit_sheet.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace planish {
namespace {

std::optional<Error> folded_fault(const char* rule, std::string where) {
  return Error{code::invalid_sheet, rule, std::move(where)};
}

bool is_finite(const Frame& frame) {
  return frame.origin.allFinite() && frame.x.allFinite() && frame.y.allFinite() &&
         frame.z.allFinite();
}

bool is_finite(const SlitRidge& ridge) {
  return ridge.flat[0].allFinite() && ridge.flat[1].allFinite() && ridge.folded[0].allFinite() &&
         ridge.folded[1].allFinite() && std::isfinite(ridge.fold.radians());
}

std::optional<Error> fault_of(const std::vector<PanelFacet>& panel, const FoldedSlitSheet& folded,
                              const char* name) {
  for (std::size_t i = 0; i < panel.size(); ++i) {
    const PanelFacet& facet = panel[i];
    const std::string where = fmt::format("{} facet {}", name, i);
    if (!is_finite(facet.frame) ||
        !std::ranges::all_of(facet.corners, [](const Vec2& p) { return p.allFinite(); }))
      return folded_fault("The panel has finite sizes.", where);
    if (facet.strip < -1 || facet.strip >= std::ssize(folded.strips))
      return folded_fault("A facet of the panel names a strip of its sheet, or −1.", where);
  }
  return {};
}

std::optional<Error> fault_of(const FoldedSlitSheet& folded) {
  if (!(folded.thickness > 0.0 && std::isfinite(folded.thickness) && std::isfinite(folded.reach)))
    return folded_fault("The thickness of a sheet is a number above 0, its reach a number.",
                        "sheet");
  if (auto found = fault_of(folded.panel, folded, "panel")) return found;
  if (auto found = fault_of(folded.second_panel, folded, "second panel")) return found;
  if (folded.symmetric && !folded.second_panel.empty())
    return folded_fault("A symmetric sheet has no second panel but the mirror image of its panel.",
                        "second panel");
  for (std::size_t i = 0; i < folded.strips.size(); ++i) {
    const FoldedStrip& strip = folded.strips[i];
    const std::string where = fmt::format("strip {}", i);
    if (strip.quads.empty() || strip.ridges.size() != strip.quads.size() + 1)
      return folded_fault("A strip has quads, one between any two ridges.", where);
    if (!std::ranges::all_of(strip.ridges, [](const SlitRidge& r) { return is_finite(r); }) ||
        !std::ranges::all_of(strip.quads, [](const Frame& quad) { return is_finite(quad); }))
      return folded_fault("A strip has finite sizes.", where);
  }
  return {};
}

}  // namespace

Result<void> check(const FoldedSlitSheet& folded) {
  if (auto found = fault_of(folded)) return tl::unexpected(std::move(*found));
  return {};
}

void require_valid(const FoldedSlitSheet& folded) {
  if (const auto found = fault_of(folded)) rule_broken(found->where, found->message);
}

}  // namespace planish
