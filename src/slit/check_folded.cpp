#include "refusals.hpp"

#include <planish/base/assert.hpp>
#include <planish/slit/folded_slit_sheet.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

// The first rule that a folded slit sheet breaks: numbers are finite, a strip has one ridge more
// than quadrilaterals, facets name strips that exist, in a symmetric sheet they end in the symmetry
// line. Sheets, moulds and meshes made from it rely on this.

namespace planish {
namespace {

/// `where`: "strip 2", as files count.
std::optional<Error> folded_fault(const Refusal& rule, std::string where, const Facts& facts = {}) {
  return error_of(rule, facts, std::move(where));
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
    const std::string where = name + (" facet " + std::to_string(i));
    if (!is_finite(facet.frame) ||
        !std::ranges::all_of(facet.corners, [](const Vec2& p) { return p.allFinite(); }))
      return folded_fault(refuse::panel_not_finite, where);
    if (facet.strip < -1 || facet.strip >= std::ssize(folded.strips))
      return folded_fault(refuse::facet_of_no_strip, where);
  }
  return {};
}

std::optional<Error> fault_of(const FoldedSlitSheet& folded) {
  if (!(folded.thickness > 0.0 && std::isfinite(folded.thickness) && std::isfinite(folded.reach)))
    return folded_fault(refuse::sheet_not_finite, "sheet");
  if (auto found = fault_of(folded.panel, folded, "panel")) return found;
  if (auto found = fault_of(folded.second_panel, folded, "second panel")) return found;
  const auto ends_in_symmetry = [&](const PanelFacet& facet) {
    return facet.corners[0].x() == folded.reach && facet.corners[3].x() == folded.reach;
  };
  if (folded.symmetric && !std::ranges::all_of(folded.second_panel, ends_in_symmetry))
    return folded_fault(refuse::symmetric_second_panel, "second panel");
  for (std::size_t i = 0; i < folded.strips.size(); ++i) {
    const FoldedStrip& strip = folded.strips[i];
    const std::string where = "strip " + std::to_string(i);
    const Facts facts{{"strip", place::strip(static_cast<int>(i))}};
    if (strip.quads.empty() || strip.ridges.size() != strip.quads.size() + 1)
      return folded_fault(refuse::quads_between_ridges, where, facts);
    if (!std::ranges::all_of(strip.ridges, [](const SlitRidge& r) { return is_finite(r); }) ||
        !std::ranges::all_of(strip.quads, [](const Frame& quad) { return is_finite(quad); }))
      return folded_fault(refuse::strip_not_finite, where, facts);
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
