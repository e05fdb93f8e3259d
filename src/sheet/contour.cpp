// Chains the free borders of a laid-out sheet to closed contours. The next border is found by
// topology, by going round the corner across joints, never by nearness: a contour closes even where
// the layout misses by a little. Across a sharp bend a segment is put in. The contour of largest
// area is the outer one; each curve keeps the borders that it came from through the joining of
// collinear neighbours.

#include "contour.hpp"

#include "refusals.hpp"

#include <planish/geometry/fit.hpp>
#include <planish/sheet/topology.hpp>

#include <algorithm>

namespace planish::sheet_detail {
namespace {

/// Contour before recognition: exact images of the borders.
struct RawContour {
  Loop loop;
  std::vector<Origin> origins;
  void add(Curve2 curve, const BorderRef& border, bool gap) {
    origins.push_back({border, gap, curve});
    loop.push_back(std::move(curve));
  }
};

RawContour walk(const Layout& layout, const Topology& topology, BorderId start,
                IdVector<BorderId, bool>& seen) {
  RawContour contour;
  BorderId at = start;
  do {
    seen[at] = true;
    contour.add(layout.image(topology[at]), topology[at], false);
    const Topology::Step step = topology.along_contour(at);
    // Along the end of each sharp bend, by the corner of the face between two of them.
    for (const BorderId beyond : step.beyond_sharp) {
      const bool last = beyond == step.beyond_sharp.back();
      const Vec2 from = end_of(contour.loop.back());
      const Vec2 to = start_of(layout.image(topology[last ? step.border : beyond]));
      contour.add(Segment{from, to}, topology[at], true);
    }
    at = step.border;
  } while (at != start && !seen[at]);
  return contour;
}

Contour finished(RawContour raw, double tolerance) {
  Contour contour{std::move(raw.loop), {}};
  for (const Origin& origin : raw.origins)
    contour.origins.push_back({origin});
  return joined_contour(contour, tolerance);
}

/// The formed feature that a contour outlines; empty for a cut.
std::optional<FeatureId> feature_of(const Sheet& sheet, const RawContour& contour) {
  for (const Origin& origin : contour.origins)
    if (const auto feature = sheet[origin.border].feature) return feature;
  return {};
}

/// Why there is no pattern where a feature reaches the outer contour: what its maker says.
Error refusal_at_rim(const FormedFeature& feature) {
  if (!feature.at_rim.message.empty()) return feature.at_rim;
  Facts facts{{"kind", feature.kind}};
  if (feature.source_face) facts.emplace_back("face", place::face(*feature.source_face));
  return error_of(refuse::form_at_rim, facts);
}

}  // namespace

Result<Contours> chain_contours(const Sheet& sheet, const Layout& layout,
                                const FlattenOptions& options) {
  const Topology topology(sheet);
  IdVector<BorderId, bool> seen(topology.border_count(), false);
  Contours contours;
  double outer_area = 0.0;
  for (const BorderId id : topology.borders()) {
    if (seen[id] || !topology.is_free(id)) continue;
    RawContour raw = walk(layout, topology, id, seen);
    const double area = signed_area(raw.loop);
    if (const auto feature = feature_of(sheet, raw)) {
      if (area > outer_area) return tl::unexpected(refusal_at_rim(sheet[*feature]));
      contours.formed.emplace_back(*feature, merged(raw.loop, options.merge_tolerance).loop);
      continue;
    }
    Contour contour = finished(std::move(raw), options.merge_tolerance);
    if (area > outer_area) {
      // The previous outer contour is then an opening whose rim covers itself.
      if (outer_area > 0) contours.openings.push_back(std::move(contours.outer));
      contours.outer = std::move(contour);
      outer_area = area;
    } else {
      contours.openings.push_back(std::move(contour));
    }
  }
  if (outer_area <= 0) return fail(refuse::no_outer_contour);
  return contours;
}

Contour joined_contour(const Contour& contour, double tolerance) {
  MergedLoop whole = merged(contour.loop, tolerance);
  const size_t inputs = contour.loop.size(), outputs = whole.loop.size();
  std::vector<std::vector<Origin>> origins(outputs);
  for (size_t i = 0; i < outputs; ++i) {
    const auto first = static_cast<size_t>(whole.first_input[i]);
    const auto last = static_cast<size_t>(whole.first_input[(i + 1) % outputs]);
    const size_t span = outputs == 1 ? inputs : (last + inputs - first) % inputs;
    for (size_t k = 0; k < span; ++k) {
      const auto& known = contour.origins[(first + k) % inputs];
      origins[i].insert(origins[i].end(), known.begin(), known.end());
    }
  }
  return {std::move(whole.loop), std::move(origins)};
}

}  // namespace planish::sheet_detail
