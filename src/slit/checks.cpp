#include "checks.hpp"

#include "design_load.hpp"
#include "joined_ends.hpp"
#include "panel.hpp"
#include "reach_checks.hpp"
#include "refusals.hpp"
#include "value_checks.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/slit/codes.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

// What a slit design must hold before anything is solved: numbers in their range, curves no tighter
// than the material allows, panels that stand, scans of a size to work with; what must be reached
// is in reach_checks.cpp. Every refusal names the field as a JSON pointer (formats.md#slits).

namespace planish::slit_detail {
namespace {

constexpr int kFewestRidges = 3, kMostRidges = 1000, kMostStrips = 10000;
constexpr std::size_t kMostPoints = 2'000'000, kMostPoles = 64;
constexpr double kHeaviest = 1e4;  // of weights: a larger one would swamp the others

/// A value that is checked, as its refusal names it: that of a strip, or of the whole.
struct Named {
  const char* name;
  std::optional<int> strip = std::nullopt;

  tl::unexpected<Error> refused(const Quantity& value, const std::string& range,
                                const std::string& where) const {
    Facts facts{{"name", name},
                {"value", value.value, value.unit},
                {"range", range},
                {"field", field(where)}};
    if (strip) facts.emplace_back("strip", place::strip(*strip));
    return fail(strip ? refuse::bad_strip_value : refuse::bad_value, facts);
  }
};

Result<void> check_length(double value, const Named& named, const std::string& where) {
  if (value > 0.0 && value <= kLargest) return {};
  return named.refused({value, unit::mm},
                       "a value above 0 and up to " + number_text(kLargest) + " mm", where);
}

Result<void> check_from_zero(const Quantity& quantity, double most, const Named& named,
                             const std::string& where) {
  if (quantity.value >= 0.0 && quantity.value <= most) return {};
  return named.refused(quantity, "a value from 0 to " + number_text(most), where);
}

Result<void> check_strip(const SlitSheet& sheet, int index) {
  const SlitStrip& strip = sheet.strips[index];
  const std::string where = "/sheet/strips/" + std::to_string(index);
  if (auto sound = check_length(strip.width, {"The width", index}, where + "/width"); !sound)
    return sound;
  if (auto sound = check_from_zero({strip.gap, unit::mm}, kLargest, {"The gap", index},
                                   where + "/gap");
      !sound)
    return sound;
  if (sheet.symmetric && strip.end)
    return fail(refuse::symmetric_with_end,
                {{"strip", place::strip(index)}, {"field", field(where, "/end")}});
  const double end = sheet.end_of(index);
  if (auto sound = check_length(end, {"The end", index}, where + "/end"); !sound) return sound;
  for (const auto& [start, key] :
       {std::pair{strip.left_start, "/left_start"}, std::pair{strip.right_start, "/right_start"}}) {
    if (!start) continue;
    if (auto sound = check_length(*start, {"The start of a slit", index}, where + key); !sound)
      return sound;
  }
  for (const auto& [value, key] :
       {std::pair{strip.left_end, "/left_end"}, std::pair{strip.right_end, "/right_end"}}) {
    if (!value) continue;
    if (auto sound = check_length(*value, {"The end of a slit", index}, where + key); !sound)
      return sound;
  }
  const auto starts = sheet.start_of(index), ends = sheet.ends_of(index);
  for (std::size_t side = 0; side < 2; ++side)
    if (!(starts[side] < ends[side]))
      return fail(refuse::ends_before_slit, {{"strip", place::strip(index)},
                                             {"end", ends[side], unit::mm},
                                             {"start", starts[side], unit::mm},
                                             {"field", field(where)}});
  return {};
}

/// A place of the leg curve in space.
Vec3 on_ground(const Vec2& p) { return {p.x(), 0.0, p.y()}; }

/// `name`: "The leg curve".
Result<void> check_curve(const BezierCurve& curve, const char* name, const std::string& where) {
  if (curve.poles.size() < 2 || curve.poles.size() > kMostPoles)
    return fail(refuse::bad_number_of_poles, {{"curve", name},
                                              {"poles", curve.poles.size()},
                                              {"most", kMostPoles},
                                              {"field", field(where)}});
  for (std::size_t i = 0; i < curve.poles.size(); ++i)
    if (auto sound = check_place(curve.poles[i], "pole " + std::to_string(i + 1) + " of the curve",
                                 where + "/bezier/" + std::to_string(i));
        !sound)
      return sound;
  if (!(length(curve) > 0.0))
    return fail(refuse::poles_in_one_place, {{"curve", name}, {"field", field(where)}});
  return {};
}

Result<void> check_radius(const SlitDesign& design, const BezierCurve& curve,
                          const std::string& where) {
  const TightestBend tightest = tightest_bend(curve);
  if (tightest.radius >= design.sheet.min_radius()) return {};
  const Vec2 at = bezier_at(curve, tightest.t).point;
  return fail(refuse::curve_too_tight, {{"radius", tightest.radius, unit::mm},
                                        {"at", place::point(on_ground(at))},
                                        {"thickness", design.sheet.thickness, unit::mm},
                                        {"least", design.sheet.min_radius(), unit::mm},
                                        {"field", field(where)}});
}

/// A panel that leans turns about the line through the ends of its leg curve.
Result<void> check_lean(Angle lean, const BezierCurve& curve, const std::string& where) {
  if (!(std::abs(lean.degrees()) <= 90.0))
    return Named{"The lean of a panel"}.refused({lean.degrees(), unit::degrees},
                                                "an angle from -90° to 90°, where it is level "
                                                "with the ground",
                                                where + "/lean");
  if (lean == Angle()) return {};
  const double apart = (curve.poles.back() - curve.poles.front()).norm();
  if (apart > tolerance::kWrittenDigits * length(curve)) return {};
  return fail(refuse::nothing_to_lean_about, {{"field", field(where, "/lean")}});
}

/// The leg curve of a panel, scaled to the sheet if that is asked for.
Result<BezierCurve> checked_curve(const SlitDesign& design, PanelAt at, bool fit, Angle lean,
                                  const std::string& where) {
  const BezierCurve& curve = at == PanelAt::start ? design.leg_curve
                                                  : design.second_panel->leg_curve;
  if (auto sound = check_curve(curve, "The leg curve", where); !sound) return pass_on(sound);
  if (auto sound = check_lean(lean, curve, where); !sound) return pass_on(sound);
  auto scaled = fit ? fitted(design.sheet, curve, at, where) : curve;
  if (!scaled) return scaled;
  if (fit)
    if (auto sound = check_curve(*scaled, "The leg curve as scaled", where); !sound)
      return pass_on(sound);
  if (auto sound = check_radius(design, *scaled, where); !sound) return pass_on(sound);
  return scaled;
}

Result<void> check_side_of_plane(const std::vector<PanelFacet>& panel) {
  const double first = panel.front().frame.point(panel.front().corners[0]).x();
  for (const PanelFacet& facet : panel)
    for (const Vec2& corner : facet.corners)
      if (const Vec3 p = facet.frame.point(corner); !(p.x() * first > 0.0))
        return fail(
            refuse::crosses_symmetry_plane,
            {{"at", place::point(p)}, {"first", first, unit::mm}, {"field", field("/leg_curve")}});
  return {};
}

Result<void> check_weights(const SlitWeights& weights) {
  for (const auto& [value, key] :
       {std::pair{weights.smooth, "smooth"}, std::pair{weights.spacing, "spacing"},
        std::pair{weights.anchors, "anchors"}, std::pair{weights.seat, "seat"},
        std::pair{weights.spread, "spread"}, std::pair{weights.scan, "scan"}})
    if (auto sound = check_from_zero({value}, kHeaviest, {"A weight"},
                                     std::string("/weights/") + key);
        !sound)
      return sound;
  return {};
}

Result<void> check_coupling(const SlitDesign& design) {
  if (!design.coupling) return {};
  if (design.objective != SlitObjective::energy)
    return fail(refuse::load_without_energy, {{"field", field("/coupling")}});
  if (auto sound = check_from_zero({design.coupling->smooth}, kHeaviest, {"A weight"},
                                   "/coupling/smooth");
      !sound)
    return sound;
  if (!design.coupling->gap) return {};
  const auto [least, most] = *design.coupling->gap;
  for (const double value : {least, most})
    if (auto sound = check_from_zero({value, unit::mm}, kLargest, {"A gap"}, "/coupling/gap");
        !sound)
      return sound;
  if (least > most)
    return fail(
        refuse::least_above_most,
        {{"least", least, unit::mm}, {"most", most, unit::mm}, {"field", field("/coupling/gap")}});
  if (design.second_panel || !joined_strips(design.sheet).empty())
    return fail(refuse::gap_at_panel, {{"field", field("/coupling/gap")}});
  return {};
}

Result<void> check_seat_curve(const SlitDesign& design) {
  if (!design.seat_curve) return {};
  if (!design.sheet.symmetric)
    return fail(refuse::seat_curve_without_symmetry, {{"field", field("/seat_curve")}});
  if (auto sound = check_curve(*design.seat_curve, "The seat curve", "/seat_curve"); !sound)
    return sound;
  double width = 0.0;
  for (int i = 0; i < std::ssize(design.sheet.strips); ++i)
    width += design.sheet.width_at_end(i);
  if (const double long_is = length(*design.seat_curve); long_is < (1.0 - kLegTolerance) * width)
    return fail(refuse::seat_curve_too_short, {{"length", long_is, unit::mm},
                                               {"width", width, unit::mm},
                                               {"field", field("/seat_curve")}});
  return {};
}

/// A curve made longer or shorter about its start.
BezierCurve scaled_to(BezierCurve curve, double wanted) {
  const double by = wanted / length(curve);
  if (std::abs(by - 1.0) <= tolerance::kComputed) return curve;
  const Vec2 start = curve.poles.front();
  for (Vec2& pole : curve.poles)
    pole = start + by * (pole - start);
  return curve;
}

/// One scan of a design.
Result<void> check_scan(const SlitDesign& design, int index) {
  const auto& [strip, points] = design.scans[index];
  const std::string where = "/scan/" + std::to_string(index);
  const Fact number("scan", index + 1);
  if (strip)
    if (auto sound = check_strip_number(design, *strip, where + "/strip"); !sound) return sound;
  if (points.size() > kMostPoints)
    return fail(refuse::scan_too_large, {number,
                                         {"points", points.size()},
                                         {"most", kMostPoints},
                                         {"field", field(where, "/points")}});
  if (points.empty()) return fail(refuse::empty_scan, {number, {"field", field(where, "/points")}});
  const auto bad = std::ranges::find_if(points, [](const Vec3& p) { return !in_range(p); });
  if (bad != points.end())
    return fail(refuse::bad_scan_point,
                {number,
                 {"point", bad - points.begin() + 1},
                 {"most", kLargest, unit::mm},
                 {"field", field(where + "/points/" + std::to_string(bad - points.begin()))}},
                where + "/points");
  return {};
}

/// The second panel's part of the sheet.
Result<void> check_far_side(const SlitDesign& design) {
  if (!design.second_panel) return {};
  const SlitSheet& sheet = design.sheet;
  if (sheet.symmetric)
    return fail(refuse::symmetric_with_second_panel, {{"field", field("/second_panel")}});
  const double height = design.second_panel->height;
  if (auto sound = check_length(height, {"The height of the second panel"}, "/second_panel/height");
      !sound)
    return sound;
  const double free_edge = sheet.panel_height + sheet.half_length + height;
  for (int i = 0; i < static_cast<int>(sheet.strips.size()); ++i)
    if (!(sheet.end_of(i) < free_edge))
      return fail(refuse::ends_beyond_panel,
                  {{"strip", place::strip(i)},
                   {"end", sheet.end_of(i), unit::mm},
                   {"edge", free_edge, unit::mm},
                   {"field", field("/sheet/strips/" + std::to_string(i) + "/end")}});
  return {};
}

/// Slits that end before the strips do, where no second panel holds the sheet beyond.
Result<void> check_joined(const SlitDesign& design) {
  const SlitSheet& sheet = design.sheet;
  bool any = false;
  for (int i = 0; i < std::ssize(sheet.strips); ++i) {
    const SlitStrip& strip = sheet.strips[i];
    if (!strip.left_end && !strip.right_end) continue;
    any = true;
    const Fact number("strip", place::strip(i)),
        where("field", field("/sheet/strips/" + std::to_string(i)));
    if (strip.end) return fail(refuse::joined_and_ended, {number, where});
    const bool to_left = sheet.joins_next(i - 1), to_right = sheet.joins_next(i);
    const bool is_alone = (i > 0 && strip.left_end && !to_left) ||
                          (i + 1 < std::ssize(sheet.strips) && strip.right_end && !to_right) ||
                          !(to_left || to_right);
    const bool is_apart = to_right && (*strip.right_end != *sheet.strips[i + 1].left_end ||
                                       sheet.strips[i + 1].gap > 0.0);
    if (is_alone || (is_apart && !design.second_panel) || !(sheet.end_of(i) < sheet.far_line()))
      return fail(refuse::joined_to_none, {number, {"end", sheet.end_of(i), unit::mm}, where});
  }
  if (!any || design.second_panel) return {};
  if (design.objective != SlitObjective::energy)
    return fail(refuse::joined_without_energy, {{"field", field("/objective")}});
  if (sheet.symmetric && design.end_angle != EndAngle::right_angle)
    return fail(refuse::joined_at_angle, {{"field", field("/end_angle")}});
  return {};
}

}  // namespace

Result<void> check_sheet(const SlitDesign& design) {
  const SlitSheet& sheet = design.sheet;
  for (const auto& [value, name, key] :
       {std::tuple{sheet.thickness, "The thickness", "/thickness"},
        std::tuple{sheet.panel_height, "The height of the panel", "/sheet/panel_height"},
        std::tuple{sheet.half_length, "The half-length", "/sheet/half_length"}})
    if (auto sound = check_length(value, {name}, key); !sound) return sound;
  for (const auto& [value, name, key] :
       {std::tuple{sheet.margin, "The margin", "/sheet/margin"},
        std::tuple{sheet.min_inside_radius, "The smallest inside radius", "/min_inside_radius"}})
    if (auto sound = check_from_zero({value, unit::mm}, kLargest, {name}, key); !sound)
      return sound;
  const int count = static_cast<int>(sheet.strips.size());
  if (count < 1 || count > kMostStrips)
    return fail(refuse::bad_number_of_strips,
                {{"count", count}, {"most", kMostStrips}, {"field", field("/sheet/strips")}});
  for (int i = 0; i < count; ++i)
    if (auto sound = check_strip(sheet, i); !sound) return sound;
  if (auto sound = check_far_side(design); !sound) return sound;
  if (auto sound = check_joined(design); !sound) return sound;
  if (design.ridges < kFewestRidges || design.ridges > kMostRidges)
    return fail(refuse::bad_number_of_ridges, {{"count", design.ridges},
                                               {"least", kFewestRidges},
                                               {"most", kMostRidges},
                                               {"field", field("/ridges")}});
  return {};
}

Result<SlitDesign> with_fitted_curves(SlitDesign design) {
  if (design.fit_seat && design.seat_curve) {
    if (auto sound = check_curve(*design.seat_curve, "The seat curve", "/seat_curve"); !sound)
      return pass_on(sound);
    design.seat_curve = scaled_to(*design.seat_curve, design.sheet.breadth());
  }
  auto curve = checked_curve(design, PanelAt::start, design.fit, design.lean, "/leg_curve");
  if (!curve) return pass_on(curve);
  design.leg_curve = std::move(*curve);
  if (!design.second_panel) return design;
  SecondPanel& second = *design.second_panel;
  auto far_curve = checked_curve(design, PanelAt::end, second.fit, second.lean,
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
  if (auto sound = check_coupling(design); !sound) return sound;
  if (auto sound = check_load(design); !sound) return sound;
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
    if (!scan.strip) continue;
    auto& all = points[*scan.strip];
    all.insert(all.end(), scan.points.begin(), scan.points.end());
  }
  return points;
}

}  // namespace planish::slit_detail
