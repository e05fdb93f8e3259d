#include "reach_checks.hpp"

#include "refusals.hpp"
#include "value_checks.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/slit/codes.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

// Whether anchors, ends and the second panel are within reach of their strips. A strip bridges no
// more than its length, measured from the panel's edge where it begins; in a symmetric sheet a
// ridge also has to go on to the symmetry plane. What passes may still be out of reach for the
// solver, whose strips have to bend: this refuses only what no shape could meet.

namespace planish::slit_detail {
namespace {

const PanelFacet& facet_of(const std::vector<PanelFacet>& panel, int strip) {
  return *std::ranges::find(panel, strip, &PanelFacet::strip);
}

/// How much too far from the panel's edge a place is for the middle of a strip's end, mm.
struct Way {
  double needed = 0.0, available = 0.0;
};

Facts out_of_reach(const Way& way, int strip, const std::string& where) {
  return {{"strip", place::strip(strip)},
          {"missing", way.needed - way.available, unit::mm},
          {"needed", way.needed, unit::mm},
          {"available", way.available, unit::mm},
          {"field", field(where)}};
}

Way way_to(const SlitDesign& design, const PanelFacet& facet, int strip, const Vec3& end) {
  const auto start = design.sheet.start_of(strip);
  const double along = 0.5 * (start[0] + start[1]);
  const Vec3 from = facet.frame.point({along, 0.5 * (facet.corners[0].y() + facet.corners[3].y())});
  const auto [left, right] = design.sheet.edge_lengths(strip);
  return {(end - from).norm(), 0.5 * (left + right)};
}

}  // namespace

Result<void> check_strip_number(const SlitDesign& design, int strip, const std::string& where) {
  const int count = static_cast<int>(design.sheet.strips.size());
  if (strip >= 0 && strip < count) return {};
  return fail(refuse::no_such_strip, {{"strip", place::strip(strip)},
                                      {"count", count},
                                      {"last", count - 1},
                                      {"field", field(where)}});
}

Result<void> check_anchor(const SlitDesign& design, const std::vector<PanelFacet>& panel,
                          int anchor) {
  const SlitAnchor& wish = design.anchors[anchor];
  const std::string where = "/anchors/" + std::to_string(anchor);
  if (auto sound = check_strip_number(design, wish.strip, where + "/strip"); !sound) return sound;
  if (wish.ridge < 0 || wish.ridge > design.ridges)
    return fail(refuse::no_such_ridge, {{"strip", place::strip(wish.strip)},
                                        {"ridge", place::ridge(wish.ridge)},
                                        {"count", design.ridges + 1},
                                        {"last", design.ridges},
                                        {"field", field(where, "/ridge")}});
  if (auto sound = check_place(wish.at, "an anchor", where + "/at"); !sound) return sound;
  const PanelFacet& facet = facet_of(panel, wish.strip);
  const std::size_t side = wish.side == StripEdge::left ? 0 : 1;
  const double start = design.sheet.start_of(wish.strip)[side];
  const Vec3 from = facet.frame.point({start, facet.corners[side == 0 ? 1 : 2].y()});
  const double available = wish.ridge == 0 ? 0.0 : design.sheet.edge_lengths(wish.strip)[side];
  const double needed = (wish.at - from).norm() +
                        (design.sheet.symmetric && wish.ridge > 0 ? std::abs(wish.at.x()) : 0.0);
  if (needed <= available + tolerance::kComputed * design.sheet.reach()) return {};
  Facts facts = out_of_reach({needed, available}, wish.strip, where + "/at");
  facts.emplace_back("at", place::point(wish.at));
  facts.emplace_back("ridge", place::ridge(wish.ridge));
  return fail(design.sheet.symmetric ? refuse::anchor_beyond_symmetry : refuse::anchor_out_of_reach,
              facts);
}

Result<void> check_second_panel(const SlitDesign& design, const Panels& panels) {
  if (!design.second_panel) return {};
  for (const PanelFacet& facet : panels.second) {
    if (facet.strip < 0) continue;
    const Vec3 end = facet.frame.point(0.5 * (facet.corners[1] + facet.corners[2]));
    const Way way = way_to(design, facet_of(panels.first, facet.strip), facet.strip, end);
    if (way.needed <= way.available) continue;
    Facts facts = out_of_reach(way, facet.strip, "/second_panel");
    facts.emplace_back("at", place::point(end));
    return fail(refuse::panel_out_of_reach, facts);
  }
  return {};
}

Result<void> check_end(const SlitDesign& design, const std::vector<PanelFacet>& panel, int strip) {
  const std::string where = "/ends/" + std::to_string(strip);
  const StripEnd& end = design.ends[strip];
  if (!end.position && !end.direction && !end.across) return {};
  if (auto sound = check_strip_number(design, strip, where); !sound) return sound;
  const auto refused = [&](const Refusal& refusal, const char* key) {
    return fail(refusal, {{"strip", place::strip(strip)}, {"field", field(where, key)}});
  };
  if (design.sheet.symmetric) return refused(refuse::end_in_symmetry_plane, "");
  if (design.second_panel) return refused(refuse::end_at_second_panel, "");
  for (const auto& [direction, key] :
       {std::pair{end.direction, "/direction"}, std::pair{end.across, "/across"}})
    if (direction && !(direction->allFinite() && direction->norm() > 0.0))
      return refused(refuse::no_direction, key);
  if (end.direction && end.across) {
    constexpr double kPerpendicular = tolerance::kWrittenDigits;  // cosine
    const double cosine = end.direction->normalized().dot(end.across->normalized());
    const Angle apart = Angle::radians(std::acos(std::clamp(cosine, -1.0, 1.0)));
    if (std::abs(cosine) > kPerpendicular)
      return fail(refuse::not_at_right_angles, {{"strip", place::strip(strip)},
                                                {"angle", apart.degrees(), unit::degrees},
                                                {"field", field(where, "/across")}});
  }
  if (!end.position) return {};
  if (auto sound = check_place(*end.position, "an end", where + "/position"); !sound) return sound;
  const Way way = way_to(design, facet_of(panel, strip), strip, *end.position);
  if (way.needed <= way.available) return {};
  Facts facts = out_of_reach(way, strip, where + "/position");
  facts.emplace_back("at", place::point(*end.position));
  return fail(refuse::end_out_of_reach, facts);
}

}  // namespace planish::slit_detail
