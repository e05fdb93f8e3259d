#include "mould_strips.hpp"

#include "mould_body.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

// The strips as the mould carries them: from panel to panel, through the symmetry plane where they
// meet there, with the facets of panels that a mould in one body goes on below.

namespace planish::slit_detail {
namespace {

WholeStrip whole_strip(const FoldedStrip& strip, double sign) {
  WholeStrip whole;
  for (const SlitRidge& ridge : strip.ridges)
    whole.ridges.push_back(ridge.folded);
  for (const Frame& quad : strip.quads)
    whole.towards_mould.push_back(sign * quad.z);
  return whole;
}

/// The image of a panel's facet in x = 0, run as it is.
WholeStrip image_of_facet(WholeStrip facet) {
  for (auto& ridge : facet.ridges)
    ridge = {mirrored(ridge[0]), mirrored(ridge[1])};
  for (Vec3& normal : facet.towards_mould)
    normal = mirrored(normal);
  return facet;
}

/// The image in x = 0, run from the symmetry plane to the other panel.
WholeStrip image_of(const WholeStrip& strip) {
  WholeStrip image;
  for (auto ridge = strip.ridges.rbegin(); ridge != strip.ridges.rend(); ++ridge)
    image.ridges.push_back({mirrored((*ridge)[0]), mirrored((*ridge)[1])});
  for (auto normal = strip.towards_mould.rbegin(); normal != strip.towards_mould.rend(); ++normal)
    image.towards_mould.push_back(mirrored(*normal));
  return image;
}

/// Up to the symmetry plane, also where the sheet is uncut there.
WholeStrip half_strip(const FoldedSlitSheet& folded, int number, double sign) {
  WholeStrip half = whole_strip(folded.strips[number], sign);
  if (!folded.symmetric) return half;
  const auto facet = std::ranges::find(folded.second_panel, number, &PanelFacet::strip);
  if (facet == folded.second_panel.end()) return half;
  half.ridges.push_back(
      {facet->frame.point(facet->corners[0]), facet->frame.point(facet->corners[3])});
  half.towards_mould.push_back(sign * facet->frame.z);
  return half;
}

/// Both halves, as one strip where they meet.
std::vector<WholeStrip> whole_strips(const FoldedSlitSheet& folded, int number, double sign) {
  const WholeStrip half = half_strip(folded, number, sign);
  if (!folded.symmetric) return {half};
  WholeStrip image = image_of(half);
  constexpr double kMeets = 1e-6;  // of the length: a strip that reached its end meets this
  const double gap = std::max((half.ridges.back()[0] - image.ridges.front()[0]).norm(),
                              (half.ridges.back()[1] - image.ridges.front()[1]).norm());
  if (gap > kMeets * folded.reach) {
    image.first = static_cast<int>(half.towards_mould.size());
    return {half, image};
  }
  WholeStrip whole = half;
  whole.ridges.insert(whole.ridges.end(), image.ridges.begin() + 1, image.ridges.end());
  whole.towards_mould.insert(whole.towards_mould.end(), image.towards_mould.begin(),
                             image.towards_mould.end());
  return {whole};
}

/// The facet of a panel at which a strip ends, as a quad before or behind its own.
std::optional<WholeStrip> facet_below(const std::vector<PanelFacet>& panel, int strip, double sign,
                                      const Vec3& up) {
  const auto facet = std::ranges::find(panel, strip, &PanelFacet::strip);
  if (facet == panel.end()) return std::nullopt;
  const Vec3 normal = sign * facet->frame.z;
  if (std::abs(normal.dot(up)) <= kUprightPanel) return std::nullopt;
  const auto at = [&](std::size_t corner) { return facet->frame.point(facet->corners[corner]); };
  return WholeStrip{{{at(0), at(3)}, {at(1), at(2)}}, {normal}, 0};
}

void put_before(WholeStrip& strip, const WholeStrip& facet) {
  strip.ridges.insert(strip.ridges.begin(), facet.ridges.front());
  strip.towards_mould.insert(strip.towards_mould.begin(), facet.towards_mould.front());
  --strip.first;
}

void put_behind(WholeStrip& strip, const WholeStrip& facet) {
  strip.ridges.push_back(facet.ridges.front());
  strip.towards_mould.push_back(facet.towards_mould.front());
}

/// In one body ribs go on under panels that lean.
void add_panels(std::vector<WholeStrip>& parts, const FoldedSlitSheet& folded, int number,
                double sign, const Vec3& up) {
  const auto first = facet_below(folded.panel, number, sign, up),
             second = folded.symmetric ? std::nullopt
                                       : facet_below(folded.second_panel, number, sign, up);
  if (second) put_behind(parts.back(), *second);
  if (first && folded.symmetric) put_behind(parts.back(), image_of_facet(*first));
  if (first) put_before(parts.front(), *first);
}

}  // namespace

std::vector<std::vector<WholeStrip>> mould_strips(const FoldedSlitSheet& folded, double sign,
                                                  const Vec3* under_panels) {
  std::vector<std::vector<WholeStrip>> strips;
  for (int i = 0; i < std::ssize(folded.strips); ++i) {
    strips.push_back(whole_strips(folded, i, sign));
    if (under_panels) add_panels(strips.back(), folded, i, sign, *under_panels);
  }
  return strips;
}

}  // namespace planish::slit_detail
