#include "checks.hpp"

#include "panel.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/slit/codes.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

// What a slit design must hold before anything is solved: numbers in their range, curves no tighter
// than the material allows, anchors and ends within reach. Reach is measured from the panel's edge
// where the strip begins: no strip bridges more than its length. Every refusal names the field as a
// JSON pointer (formats.md#slits).

namespace planish::slit_detail {
namespace {

constexpr int kFewestRidges = 3, kMostRidges = 1000, kMostStrips = 10000;
constexpr std::size_t kMostPoints = 2'000'000, kMostPoles = 64;
constexpr double kLargest = 1e7;   // mm, of lengths and coordinates: 10 km
constexpr double kHeaviest = 1e4;  // of weights: a larger one would swamp the others

tl::unexpected<Error> invalid(std::string message, std::string where) {
  return fail(code::invalid_input, std::move(message), std::move(where));
}

Result<void> check_length(double value, const char* what, std::string where) {
  if (value > 0.0 && value <= kLargest) return {};
  return invalid(
      fmt::format("{} is {} mm; it must be above 0 and at most {:g} mm", what, value, kLargest),
      std::move(where));
}

Result<void> check_from_zero(double value, double most, const char* what, std::string where) {
  if (value >= 0.0 && value <= most) return {};
  return invalid(fmt::format("{} is {}; it must be between 0 and {:g}", what, value, most),
                 std::move(where));
}

/// Of points and poles.
bool in_range(const auto& p) { return p.allFinite() && p.cwiseAbs().maxCoeff() <= kLargest; }

Result<void> check_place(const auto& p, const char* what, std::string where) {
  if (in_range(p)) return {};
  return invalid(
      fmt::format("a coordinate of {} is not a number, or beyond {:g} mm", what, kLargest),
      std::move(where));
}

Result<void> check_strip(const SlitSheet& sheet, int index) {
  const SlitStrip& strip = sheet.strips[index];
  const std::string where = fmt::format("/sheet/strips/{}", index);
  if (auto sound = check_length(strip.width, "the width of a strip", where + "/width"); !sound)
    return sound;
  if (auto sound = check_from_zero(strip.gap, kLargest, "the gap beside a strip", where + "/gap");
      !sound)
    return sound;
  if (sheet.symmetric && strip.end)
    return invalid("strips of a symmetric sheet end at its symmetry plane; leave out their ends",
                   where + "/end");
  const double end = sheet.end_of(index);
  if (auto sound = check_length(end, "the end of a strip", where + "/end"); !sound) return sound;
  for (const auto& [start, key] :
       {std::pair{strip.left_start, "/left_start"}, std::pair{strip.right_start, "/right_start"}}) {
    if (!start) continue;
    if (auto sound = check_length(*start, "the start of a slit", where + key); !sound) return sound;
  }
  for (const double start : sheet.start_of(index))
    if (!(start < end))
      return invalid(fmt::format("strip {} ends at {:.6g} mm, before its slit begins at {:.6g} mm",
                                 index, end, start),
                     where);
  return {};
}

Result<void> check_curve(const BezierCurve& curve, const char* what, const std::string& where) {
  if (curve.poles.size() < 2)
    return invalid(fmt::format("{} has {} poles; it needs at least 2", what, curve.poles.size()),
                   where);
  if (curve.poles.size() > kMostPoles)
    return invalid(fmt::format("{} has {} poles; at most {} are allowed", what, curve.poles.size(),
                               kMostPoles),
                   where);
  for (std::size_t i = 0; i < curve.poles.size(); ++i)
    if (auto sound = check_place(curve.poles[i], fmt::format("a pole of {}", what).c_str(),
                                 fmt::format("{}/bezier/{}", where, i));
        !sound)
      return sound;
  if (!(length(curve) > 0.0))
    return invalid(fmt::format("{} has all its poles in one place", what), where);
  return {};
}

Result<void> check_radius(const SlitDesign& design, const BezierCurve& curve,
                          const std::string& where) {
  const TightestBend tightest = tightest_bend(curve);
  if (tightest.radius >= design.sheet.min_radius()) return {};
  const Vec2 at = bezier_at(curve, tightest.t).point;
  return fail(code::radius_too_small,
              fmt::format("the leg curve bends with a radius of {:.4g} mm at (x, z) = ({:.4g}, "
                          "{:.4g}) mm; the sheet, {:.4g} mm thick, needs at least "
                          "{:.4g} mm at its mid-surface",
                          tightest.radius, at.x(), at.y(), design.sheet.thickness,
                          design.sheet.min_radius()),
              where);
}

/// A panel that leans turns about the line through the ends of its leg curve.
Result<void> check_lean(Angle lean, const BezierCurve& curve, const std::string& where) {
  if (!(std::abs(lean.degrees()) <= 90.0))
    return invalid(fmt::format("a panel leans by {:.4g}°; it must be from -90° to 90°, where it is "
                               "level with the ground",
                               lean.degrees()),
                   where + "/lean");
  if (lean == Angle()) return {};
  const double apart = (curve.poles.back() - curve.poles.front()).norm();
  if (apart > tolerance::kWrittenDigits * length(curve)) return {};
  return invalid(
      "the leg curve ends where it begins, so there is no line about which its panel could lean",
      where + "/lean");
}

/// The leg curve of a panel, scaled to the sheet if that is asked for.
Result<BezierCurve> checked_curve(const SlitDesign& design, const BezierCurve& curve, bool fit,
                                  Angle lean, const std::string& where) {
  if (auto sound = check_curve(curve, "the leg curve", where); !sound) return pass_on(sound);
  if (auto sound = check_lean(lean, curve, where); !sound) return pass_on(sound);
  auto scaled = fit ? fitted(design.sheet, curve, where) : curve;
  if (!scaled) return scaled;
  if (fit)
    if (auto sound = check_curve(*scaled, "the leg curve as scaled", where); !sound)
      return pass_on(sound);
  if (auto sound = check_radius(design, *scaled, where); !sound) return pass_on(sound);
  return scaled;
}

Result<void> check_side_of_plane(const std::vector<PanelFacet>& panel) {
  const double first = panel.front().frame.point(panel.front().corners[0]).x();
  for (const PanelFacet& facet : panel)
    for (const Vec2& corner : facet.corners)
      if (const double x = facet.frame.point(corner).x(); !(x * first > 0.0))
        return invalid(fmt::format("the panel on the leg curve meets the symmetry plane (x = "
                                   "{:.4g} mm after x = {:.4g} mm); it must stay on one side of x "
                                   "= 0",
                                   x, first),
                       "/leg_curve");
  return {};
}

const PanelFacet& facet_of(const std::vector<PanelFacet>& panel, int strip) {
  return *std::find_if(panel.begin(), panel.end(),
                       [&](const PanelFacet& facet) { return facet.strip == strip; });
}

Result<void> check_strip_number(const SlitDesign& design, int strip, const std::string& where) {
  const int count = static_cast<int>(design.sheet.strips.size());
  if (strip >= 0 && strip < count) return {};
  return fail(code::unknown_strip,
              fmt::format("there is no strip {}; the sheet has strips 0 to {}", strip, count - 1),
              where);
}

Result<void> check_weights(const SlitWeights& weights) {
  for (const auto& [value, key] :
       {std::pair{weights.smooth, "smooth"}, std::pair{weights.spacing, "spacing"},
        std::pair{weights.anchors, "anchors"}, std::pair{weights.seat, "seat"},
        std::pair{weights.spread, "spread"}, std::pair{weights.scan, "scan"}})
    if (auto sound = check_from_zero(value, kHeaviest, "a weight", fmt::format("/weights/{}", key));
        !sound)
      return sound;
  return {};
}

Result<void> check_seat_curve(const SlitDesign& design) {
  if (!design.seat_curve) return {};
  if (!design.sheet.symmetric)
    return invalid(
        "a seat curve lies in the symmetry plane, but the sheet is not symmetric; leave it out and "
        "place the ends of the strips",
        "/seat_curve");
  if (auto sound = check_curve(*design.seat_curve, "the seat curve", "/seat_curve"); !sound)
    return sound;
  double width = 0.0;
  for (const SlitStrip& strip : design.sheet.strips)
    width += strip.width;
  if (const double long_is = length(*design.seat_curve); long_is < (1.0 - kLegTolerance) * width)
    return fail(code::curve_too_short,
                fmt::format("the seat curve is {:.6g} mm long; the ends of the strips are {:.6g} "
                            "mm wide together and would overlap",
                            long_is, width),
                "/seat_curve");
  return {};
}

Result<void> check_anchor(const SlitDesign& design, const std::vector<PanelFacet>& panel,
                          int anchor) {
  const SlitAnchor& wish = design.anchors[anchor];
  const std::string where = fmt::format("/anchors/{}", anchor);
  if (auto sound = check_strip_number(design, wish.strip, where + "/strip"); !sound) return sound;
  if (wish.ridge < 0 || wish.ridge > design.ridges)
    return fail(code::unknown_ridge,
                fmt::format("strip {} has no ridge {}; it has ridges 0 to {}", wish.strip,
                            wish.ridge, design.ridges),
                where + "/ridge");
  if (auto sound = check_place(wish.at, "an anchor", where + "/at"); !sound) return sound;
  const PanelFacet& facet = facet_of(panel, wish.strip);
  const std::size_t side = wish.side == StripEdge::left ? 0 : 1;
  const double start = design.sheet.start_of(wish.strip)[side];
  const Vec3 from = facet.frame.point({start, facet.corners[side == 0 ? 1 : 2].y()});
  const double available = wish.ridge == 0 ? 0.0 : design.sheet.end_of(wish.strip) - start;
  const double needed = (wish.at - from).norm() +
                        (design.sheet.symmetric && wish.ridge > 0 ? std::abs(wish.at.x()) : 0.0);
  if (needed <= available + tolerance::kComputed * design.sheet.reach()) return {};
  return fail(code::out_of_reach,
              fmt::format("the anchor at ({:.4g}, {:.4g}, {:.4g}) mm is {:.4g} mm out of reach: "
                          "the way there from the panel{} is {:.4g} mm, but strip {} is only "
                          "{:.4g} mm long",
                          wish.at.x(), wish.at.y(), wish.at.z(), needed - available,
                          design.sheet.symmetric ? " and on to the symmetry plane" : "", needed,
                          wish.strip, available),
              where + "/at");
}

/// How much too far from the panel's edge a place is for the middle of a strip's end, mm.
struct Way {
  double needed = 0.0, available = 0.0;
};

Way way_to(const SlitDesign& design, const PanelFacet& facet, int strip, const Vec3& end) {
  const auto start = design.sheet.start_of(strip);
  const double along = 0.5 * (start[0] + start[1]);
  const Vec3 from = facet.frame.point({along, 0.5 * (facet.corners[0].y() + facet.corners[3].y())});
  return {(end - from).norm(), design.sheet.end_of(strip) - along};
}

Result<void> check_second_panel(const SlitDesign& design, const Panels& panels) {
  if (!design.second_panel) return {};
  for (const PanelFacet& facet : panels.second) {
    if (facet.strip < 0) continue;
    const Vec3 end = facet.frame.point(0.5 * (facet.corners[1] + facet.corners[2]));
    const auto [needed, available] = way_to(design, facet_of(panels.first, facet.strip),
                                            facet.strip, end);
    if (needed <= available) continue;
    return fail(code::out_of_reach,
                fmt::format("the second panel is {:.4g} mm out of reach of strip {}: its edge is "
                            "{:.4g} mm from that of the first panel, but the strip is only {:.4g} "
                            "mm long",
                            needed - available, facet.strip, needed, available),
                "/second_panel");
  }
  return {};
}

Result<void> check_end(const SlitDesign& design, const std::vector<PanelFacet>& panel, int strip) {
  const std::string where = fmt::format("/ends/{}", strip);
  const StripEnd& end = design.ends[strip];
  if (!end.position && !end.direction && !end.across) return {};
  if (auto sound = check_strip_number(design, strip, where); !sound) return sound;
  if (design.sheet.symmetric)
    return fail(
        code::bad_option,
        "strips of a symmetric sheet end in its symmetry plane; their ends cannot be placed",
        where);
  if (design.second_panel)
    return fail(code::bad_option, "the strips end at the second panel; their ends cannot be placed",
                where);
  for (const auto& [direction, key] :
       {std::pair{end.direction, "/direction"}, std::pair{end.across, "/across"}})
    if (direction && !(direction->allFinite() && direction->norm() > 0.0))
      return invalid("a direction is zero or not finite", where + key);
  if (end.direction && end.across) {
    constexpr double kPerpendicular = tolerance::kWrittenDigits;  // cosine
    const double cosine = end.direction->normalized().dot(end.across->normalized());
    if (std::abs(cosine) > kPerpendicular)
      return invalid(
          fmt::format("the end's direction and its last ridge are {:.4g}° apart; they must be at "
                      "right angles",
                      Angle::radians(std::acos(std::clamp(cosine, -1.0, 1.0))).degrees()),
          where + "/across");
  }
  if (!end.position) return {};
  if (auto sound = check_place(*end.position, "an end", where + "/position"); !sound) return sound;
  const auto [needed, available] = way_to(design, facet_of(panel, strip), strip, *end.position);
  if (needed <= available) return {};
  return fail(code::out_of_reach,
              fmt::format("the end of strip {} is {:.4g} mm out of reach: it is {:.4g} mm from the "
                          "panel's edge, but the strip is only {:.4g} mm long",
                          strip, needed - available, needed, available),
              where + "/position");
}

/// One scan of a design.
Result<void> check_scan(const SlitDesign& design, int index) {
  const auto& [strip, points] = design.scans[index];
  const std::string where = fmt::format("/scan/{}", index);
  if (auto sound = check_strip_number(design, strip, where + "/strip"); !sound) return sound;
  if (points.size() > kMostPoints)
    return fail(code::scan_too_large,
                fmt::format("the scan of strip {} has {} points; thin it out to at most {}", strip,
                            points.size(), kMostPoints),
                where + "/points");
  if (points.empty())
    return fail(code::empty_scan, fmt::format("the scan of strip {} has no points", strip),
                where + "/points");
  const auto bad = std::find_if(points.begin(), points.end(),
                                [](const Vec3& p) { return !in_range(p); });
  if (bad != points.end())
    return invalid(fmt::format("point {} of the scan of strip {} has a coordinate that is not a "
                               "number, or beyond {:g} mm",
                               bad - points.begin() + 1, strip, kLargest),
                   where + "/points");
  return {};
}

/// The second panel's part of the sheet.
Result<void> check_far_side(const SlitDesign& design) {
  if (!design.second_panel) return {};
  const SlitSheet& sheet = design.sheet;
  if (sheet.symmetric)
    return invalid(
        "the other half of a symmetric sheet is its mirror image; leave out the second panel, or "
        "set symmetric to false",
        "/second_panel");
  const double height = design.second_panel->height;
  if (auto sound = check_length(height, "the height of the second panel", "/second_panel/height");
      !sound)
    return sound;
  const double free_edge = sheet.panel_height + sheet.half_length + height;
  for (int i = 0; i < static_cast<int>(sheet.strips.size()); ++i)
    if (!(sheet.end_of(i) < free_edge))
      return invalid(fmt::format("strip {} ends at {:.6g} mm, beyond the second panel, whose free "
                                 "edge is at {:.6g} mm",
                                 i, sheet.end_of(i), free_edge),
                     fmt::format("/sheet/strips/{}/end", i));
  return {};
}

}  // namespace

Result<void> check_sheet(const SlitDesign& design) {
  const SlitSheet& sheet = design.sheet;
  if (auto sound = check_length(sheet.thickness, "the thickness", "/thickness"); !sound)
    return sound;
  if (auto sound = check_length(sheet.panel_height, "the height of the panel",
                                "/sheet/panel_height");
      !sound)
    return sound;
  if (auto sound = check_length(sheet.half_length, "the half-length", "/sheet/half_length"); !sound)
    return sound;
  if (auto sound = check_from_zero(sheet.margin, kLargest, "the margin", "/sheet/margin"); !sound)
    return sound;
  if (auto sound = check_from_zero(sheet.min_inside_radius, kLargest, "the smallest inside radius",
                                   "/min_inside_radius");
      !sound)
    return sound;
  const int count = static_cast<int>(sheet.strips.size());
  if (count < 1 || count > kMostStrips)
    return invalid(fmt::format("the sheet has {} strips; it must have 1 to {}", count, kMostStrips),
                   "/sheet/strips");
  for (int i = 0; i < count; ++i)
    if (auto sound = check_strip(sheet, i); !sound) return sound;
  if (auto sound = check_far_side(design); !sound) return sound;
  if (design.ridges < kFewestRidges || design.ridges > kMostRidges)
    return invalid(fmt::format("each strip has {} ridges; it must have {} to {}", design.ridges,
                               kFewestRidges, kMostRidges),
                   "/ridges");
  return {};
}

Result<SlitDesign> with_fitted_curves(SlitDesign design) {
  auto curve = checked_curve(design, design.leg_curve, design.fit, design.lean, "/leg_curve");
  if (!curve) return pass_on(curve);
  design.leg_curve = std::move(*curve);
  if (!design.second_panel) return design;
  SecondPanel& second = *design.second_panel;
  auto far_curve = checked_curve(design, second.leg_curve, second.fit, second.lean,
                                 "/second_panel/leg_curve");
  if (!far_curve) return pass_on(far_curve);
  second.leg_curve = std::move(*far_curve);
  return design;
}

Result<Panels> checked_panels(const SlitDesign& design) {
  auto first = panel_of(design.sheet, design.leg_curve, design.lean);
  if (!first) return pass_on(first);
  if (design.sheet.symmetric)
    if (auto sound = check_side_of_plane(*first); !sound) return pass_on(sound);
  if (!design.second_panel) return Panels{std::move(*first), {}};
  auto second = second_panel_of(design.sheet, *design.second_panel);
  if (!second) return pass_on(second);
  return Panels{std::move(*first), std::move(*second)};
}

Result<void> check_all(const SlitDesign& design, const Panels& panels) {
  const std::vector<PanelFacet>& panel = panels.first;
  if (auto sound = check_seat_curve(design); !sound) return sound;
  if (auto sound = check_weights(design.weights); !sound) return sound;
  for (int i = 0; i < static_cast<int>(design.anchors.size()); ++i)
    if (auto sound = check_anchor(design, panel, i); !sound) return sound;
  for (int i = 0; i < static_cast<int>(design.ends.size()); ++i)
    if (auto sound = check_end(design, panel, i); !sound) return sound;
  return check_second_panel(design, panels);
}

Result<std::vector<std::vector<Vec3>>> points_by_strip(const SlitDesign& design) {
  std::vector<std::vector<Vec3>> points(design.sheet.strips.size());
  for (int i = 0; i < static_cast<int>(design.scans.size()); ++i) {
    const SlitScan& scan = design.scans[i];
    if (auto sound = check_scan(design, i); !sound) return pass_on(sound);
    auto& all = points[scan.strip];
    all.insert(all.end(), scan.points.begin(), scan.points.end());
  }
  return points;
}

}  // namespace planish::slit_detail
