// Measures a pattern against the sheet that it was made from, sharing nothing with the layout that
// made it (math.md#certificate, math.md#certificate-independence): the sheet is laid out again
// (relaid.cpp), borders are sought in the pattern and contours among the borders, both ways;
// lengths, the area at K = ½ times the thickness (math.md#volume-identity) and the number of
// openings are compared with those of the solid.

#include "curve_index.hpp"
#include "opening_count.hpp"
#include "refusals.hpp"
#include "relaid.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/sheet/certificate.hpp>

#include <algorithm>
#include <cmath>

namespace planish {
namespace {

using namespace sheet_detail;

/// A deviation and where it is in the pattern.
struct Worst {
  double distance = 0.0;
  Vec2 at = Vec2::Zero();
  void take(double other, const Vec2& place) {
    if (!(other > distance)) return;
    distance = other;
    at = place;
  }
};

/// Openings run clockwise, except possibly in a pattern that covers itself.
double area_as_written(const FlatPattern& pattern) {
  double area = signed_area(pattern.outer.loop);
  for (const Contour& opening : pattern.openings)
    area += signed_area(opening.loop);
  return area;
}

using Allowances = IdVector<BendId, BendAllowance>;

Curve2 image_of(const Sheet& sheet, const Relaid& laid, const BorderRef& ref, double tolerance) {
  const auto& development = laid.development[ref.face];
  const Curve2& curve = sheet[ref].curve;
  return transformed(development ? development->develop(curve, tolerance) : curve,
                     laid.placement[ref.face]);
}

/// The area of the bends, less their openings.
double area_of_bends(const Sheet& sheet, const Relaid& laid, const Allowances& allowances,
                     double tolerance) {
  double sum = 0.0;
  for (const FaceId id : sheet.faces.ids()) {
    if (!laid.development[id]) continue;
    double area = 0.0;
    for (const BorderLoop& loop : sheet[id].loops)
      for (const Border& border : loop)
        area += green_area(laid.development[id]->develop(border.curve, tolerance));
    sum += std::abs(area);
  }
  const auto length = [&](const BorderRef& ref) {
    const Curve2& curve = sheet[ref].curve;
    return (laid.image(ref.face, end_of(curve)) - laid.image(ref.face, start_of(curve))).norm();
  };
  for (const Joint& joint : sheet.joints)
    if (joint.sharp)
      sum += allowances[*joint.sharp].allowance * 0.5 * (length(joint.a) + length(joint.b));
  return sum;
}

/// What lies within the outlines of formed features, where the material goes on.
double area_of_forms(const Sheet& sheet, const Topology& topology, const Relaid& laid,
                     double tolerance) {
  double sum = 0.0;
  IdVector<BorderId, bool> seen(topology.border_count(), false);
  for (const BorderId start : topology.borders()) {
    if (seen[start] || !topology.is_free(start)) continue;
    Loop outline;
    bool formed = false;
    for (BorderId at = start; !seen[at]; at = topology.along_contour(at).border) {
      seen[at] = true;
      formed |= sheet[topology[at]].feature.has_value();
      const Curve2 image = image_of(sheet, laid, topology[at], tolerance);
      if (!outline.empty()) outline.push_back(Segment{end_of(outline.back()), start_of(image)});
      outline.push_back(image);
    }
    outline.push_back(Segment{end_of(outline.back()), start_of(outline.front())});
    if (formed) sum += std::abs(signed_area(outline));
  }
  return sum;
}

/// The area of the pattern as written, if all its bends had K = ½: less the extra area of the
/// bends, and of the forms over them, at the K-factors that the pattern states.
Result<double> area_at_half(const Sheet& sheet, const FlatPattern& pattern, const Relaid& laid,
                            const Allowances& stated, double tolerance) {
  const double written = area_as_written(pattern);
  const bool all_half = std::ranges::all_of(
      stated, [](const BendAllowance& bend) { return bend.k_factor == 0.5; });
  if (all_half) return written;
  const Allowances half = at_half(sheet, stated);
  const auto halfway = relaid(sheet, pattern, half);
  if (!halfway) return pass_on(halfway);
  double beyond = area_of_bends(sheet, laid, stated, tolerance) -
                  area_of_bends(sheet, *halfway, half, tolerance);
  if (!sheet.features.empty()) {
    const Topology topology(sheet);
    beyond += area_of_forms(sheet, topology, laid, tolerance) -
              area_of_forms(sheet, topology, *halfway, tolerance);
  }
  return written - beyond;
}

/// Lengths on the reference surface itself: its development must keep them, whatever the K-factor.
Worst worst_length(const Sheet& sheet, const Relaid& laid, double tolerance) {
  Worst worst;
  for (const FaceId id : sheet.faces.ids()) {
    const Face& face = sheet[id];
    const auto* surface = std::get_if<Developable>(&face.surface);
    std::optional<Development> skin;
    if (surface) skin.emplace(*surface, 0.0);
    for (const BorderLoop& loop : face.loops)
      for (const Border& border : loop) {
        if (!border.edge || !border.edge_length) continue;
        const double flat = length(skin ? skin->develop(border.curve, tolerance) : border.curve);
        const double error = std::abs(flat - *border.edge_length);
        if (error > worst.distance) worst.take(error, laid.image(id, point_at(border.curve, 0.5)));
      }
  }
  return worst;
}

/// Everything that the pattern draws of the material's borders.
std::vector<Curve2> drawn_curves(const FlatPattern& pattern) {
  std::vector<Curve2> curves = written_curves(pattern);
  for (const FlatFeature& feature : pattern.features)
    for (const Loop& outline : feature.outlines)
      curves.insert(curves.end(), outline.begin(), outline.end());
  return curves;
}

/// The setbacks that sharp bends cut off the faces beside them: points of a loop there are not in
/// the pattern.
struct CutStrip {
  int loop = 0;
  Vec2 origin, inwards;  ///< of the joint's border, in (x, y) of the face
  double depth = 0.0;
};

IdVector<FaceId, std::vector<CutStrip>> cut_strips(const Sheet& sheet) {
  IdVector<FaceId, std::vector<CutStrip>> strips(sheet.faces.size());
  for (const Joint& joint : sheet.joints) {
    const double setback = setback_at(sheet, joint);
    if (setback <= 0.0) continue;
    for (const BorderRef& ref : {joint.a, joint.b}) {
      const Vec2 from = start_of(sheet[ref].curve);
      const Vec2 along = (end_of(sheet[ref].curve) - from).normalized();
      strips[ref.face].push_back({ref.loop, from, perpendicular(along), setback});
    }
  }
  return strips;
}

bool is_cut_off(const std::vector<CutStrip>& strips, int loop, const Vec2& uv) {
  return std::ranges::any_of(strips, [&](const CutStrip& strip) {
    return strip.loop == loop && (uv - strip.origin).dot(strip.inwards) < strip.depth;
  });
}

/// Looks for every free border of the sheet in the pattern, and folds the points found back.
Worst worst_border(const Sheet& sheet, const FlatPattern& pattern, const Relaid& laid,
                   const EdgeDistance& distance) {
  const CurveIndex drawn(drawn_curves(pattern));
  const auto strips = cut_strips(sheet);
  const Topology topology(sheet);
  Worst worst;
  for (const BorderId id : topology.borders()) {
    if (!topology.is_free(id)) continue;
    const BorderRef& ref = topology[id];
    const Border& border = sheet[ref];
    const Face& face = sheet[ref.face];
    for (const double t : {0.0, 0.3, 0.5, 0.8}) {
      const Vec2 uv = point_at(border.curve, t);
      if (is_cut_off(strips[ref.face], ref.loop, uv)) continue;
      const Vec2 expected = laid.image(ref.face, uv);
      const auto hit = drawn.nearest(expected);
      worst.take(hit->distance, expected);
      if (!border.edge || border.feature) continue;
      const Vec2 back = laid.fold(ref.face, hit->point);
      const Vec3 in_space = skin_point(face, back) - border.edge_depth * outward_normal(face, back);
      worst.take(distance(*border.edge, in_space), hit->point);
    }
  }
  return worst;
}

/// Looks for every contour of the pattern among the sheet's free borders, laid flat; across sharp
/// bends contours run within their bands.
Worst worst_contour(const Sheet& sheet, const FlatPattern& pattern, const Relaid& laid,
                    const Allowances& stated, double tolerance) {
  const Topology topology(sheet);
  std::vector<Curve2> borders;
  for (const BorderId id : topology.borders()) {
    if (!topology.is_free(id)) continue;
    borders.push_back(image_of(sheet, laid, topology[id], tolerance));
  }
  for (const FormedFeature& feature : sheet.features)
    for (const BorderLoop* cut : cuts_of(feature))
      for (const Curve2& image : image_of_cut(laid, feature.face, *cut))
        borders.push_back(image);
  std::vector<HingeBand> bands;
  for (const Joint& joint : sheet.joints)
    if (joint.sharp)
      bands.push_back(hinge_band(sheet, laid, joint, stated[*joint.sharp].allowance));
  const CurveIndex index(std::move(borders));
  const auto across_hinge = [&](const Vec2& p) {
    return std::ranges::any_of(
        bands, [&](const HingeBand& band) { return band.holds(p, 10.0 * tolerance); });
  };
  Worst worst;
  for (const Curve2& curve : written_curves(pattern))
    for (const double t : {0.0, 0.21, 0.5, 0.83}) {
      const Vec2 p = point_at(curve, t);
      const auto hit = index.nearest(p);
      const double off = hit ? hit->distance : length(curve);
      if (off > worst.distance && !across_hinge(p)) worst.take(off, p);
    }
  return worst;
}

/// An opening of the pattern by its number, with its box.
struct BoxedOpening {
  Box2 box;
  size_t opening = 0;
};

/// The opening as written where one of the sheet's is expected; empty where none is near, which
/// other residuals tell.
const Contour* opening_at(const FlatPattern& pattern, const std::vector<BoxedOpening>& openings,
                          const Box2& box) {
  constexpr double kNear = 2.0;  // mm between the corners of boxes
  const Contour* best = nullptr;
  double least = kNear;
  auto row = std::ranges::lower_bound(openings, box.lo.x() - kNear, {},
                                      [](const BoxedOpening& one) { return one.box.lo.x(); });
  for (; row != openings.end() && row->box.lo.x() <= box.lo.x() + kNear; ++row) {
    const double off = (row->box.lo - box.lo).norm() + (row->box.hi - box.hi).norm();
    if (off > least) continue;
    least = off;
    best = &pattern.openings[row->opening];
  }
  return best;
}

/// Holds each opening as written against what the solid lacks there.
std::optional<Worst> worst_opening(const Sheet& sheet, const FlatPattern& pattern,
                                   const Relaid& laid) {
  if (sheet.measured_openings.empty()) return {};
  std::vector<BoxedOpening> openings;
  for (size_t i = 0; i < pattern.openings.size(); ++i)
    openings.push_back({bounds(pattern.openings[i].loop), i});
  std::ranges::sort(openings, {}, [](const BoxedOpening& one) { return one.box.lo.x(); });
  Worst worst;
  for (const MeasuredOpening& measured : sheet.measured_openings) {
    const auto& borders = sheet[measured.face].loops[measured.loop];
    if (measured.border) {
      const Vec2 at = point_at(borders[*measured.border].curve, 0.5);
      worst.take(measured.intrusion, laid.image(measured.face, at));
      continue;
    }
    const Loop image = image_of_cut(laid, measured.face, borders);
    const Contour* written = opening_at(pattern, openings, bounds(image));
    if (!written) continue;
    const double cut = std::abs(signed_area(written->loop));
    const double lacking = measured.lacking - measured.beyond;
    const double off = std::abs(cut * sheet.thickness - lacking) /
                       (sheet.thickness * length(written->loop));
    const Box2 box = bounds(written->loop);
    worst.take(std::max(off, measured.intrusion), (box.lo + box.hi) / 2);
  }
  return worst;
}

/// How far the solid reaches beyond the outlines of flanges.
std::optional<Worst> worst_outline(const Sheet& sheet, const Relaid& laid) {
  if (sheet.measured_outlines.empty()) return {};
  Worst worst;
  for (const MeasuredOutline& outline : sheet.measured_outlines)
    worst.take(outline.beyond, laid.image(outline.face, outline.at));
  return worst;
}

/// The residuals of volume and openings, of a pattern with this area at K = ½.
Certificate measured(const Sheet& sheet, const FlatPattern& pattern, const Relaid& laid,
                     double area) {
  Certificate certificate;
  certificate.flat_area_half = area;
  if (sheet.volume) certificate.volume_ratio = area * sheet.thickness / *sheet.volume;
  if (sheet.volume && sheet.forms_volume) {
    const double plain = *sheet.volume - *sheet.forms_volume - sheet.mitres_volume;
    const double uncut = area + area_cut_in_forms(sheet, pattern, laid);
    if (plain > 0.0) certificate.explained_ratio = uncut * sheet.thickness / plain;
  }
  certificate.openings = counted_openings(sheet, pattern, laid);
  if (const auto opening = worst_opening(sheet, pattern, laid)) {
    certificate.opening_error = opening->distance;
    certificate.opening_error_at = opening->at;
  }
  if (const auto outline = worst_outline(sheet, laid)) {
    certificate.outline_error = outline->distance;
    certificate.outline_error_at = outline->at;
  }
  return certificate;
}

}  // namespace

Result<Certificate> certify(const Sheet& sheet, const FlatPattern& pattern,
                            const EdgeDistance& distance, double curve_tolerance) {
  if (auto right = check(sheet); !right) return pass_on(right);
  if (pattern.outer.loop.empty()) return fail(refuse::pattern_empty);
  if (auto right = check(pattern); !right) return pass_on(right);
  if (!sheet.faces.has(pattern.root))
    return fail(refuse::pattern_root_unknown,
                {{"root", index_of(pattern.root) + 1}, {"count", sheet.faces.size()}});
  if (!(curve_tolerance > 0.0 && curve_tolerance <= kFarthest))
    return fail(refuse::curve_tolerance, {{"tolerance", curve_tolerance, unit::mm}});
  const auto stated = stated_allowances(sheet, pattern);
  if (!stated) return pass_on(stated);
  const auto laid = relaid(sheet, pattern, *stated);
  if (!laid) return pass_on(laid);
  const auto half = area_at_half(sheet, pattern, *laid, *stated, curve_tolerance);
  if (!half) return pass_on(half);

  Certificate certificate = measured(sheet, pattern, *laid, *half);
  const Worst length = worst_length(sheet, *laid, curve_tolerance);
  certificate.length_error = length.distance;
  certificate.length_error_at = length.at;
  if (!distance) return certificate;
  Worst refold = worst_border(sheet, pattern, *laid, distance);
  const Worst contour = worst_contour(sheet, pattern, *laid, *stated, curve_tolerance);
  refold.take(contour.distance, contour.at);
  certificate.refold_deviation = refold.distance;
  certificate.refold_at = refold.at;
  return certificate;
}

}  // namespace planish
