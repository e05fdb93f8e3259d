#include "bend_order_json.hpp"

#include "bending.hpp"
#include "places_json.hpp"
#include "plan_report.hpp"
#include "proposal_report.hpp"
#include "station_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace planish::job {
using namespace schema;
namespace {

const Units& millimetres() {
  static const Units units(LengthUnit::mm);
  return units;
}

Json profile_json(const ToolProfile& profile) {
  return json_array(profile, [&](const Vec2& p) { return point_json(p, millimetres()); });
}

Json segments_json(const std::vector<StandingSegment>& segments) {
  return json_array(segments, [&](const StandingSegment& segment) {
    return Json::array({number_json(segment.from), number_json(segment.length)});
  });
}

Json moments_json(const std::vector<StrokeMoment>& moments) {
  Json json;
  const auto add = [&](const char* key, const auto& value) {
    Json& column = json[key] = Json::array();
    for (const StrokeMoment& moment : moments)
      column.push_back(number_json(value(moment)));
  };
  add("turn", [](const StrokeMoment& m) { return m.turn.degrees(); });
  add("slope", [](const StrokeMoment& m) { return m.slope.degrees(); });
  add("y", [](const StrokeMoment& m) { return m.by.x(); });
  add("z", [](const StrokeMoment& m) { return m.by.y(); });
  add("punch", [](const StrokeMoment& m) { return m.punch; });
  add("die", [](const StrokeMoment& m) { return m.die; });
  return json;
}

Json scene_json(const CheckedStroke& checked) {
  const StrokeScene& scene = checked.scene;
  Json json;
  json["origin"] = point_json(scene.origin, millimetres());
  json["along"] = point_json(scene.along, millimetres());
  json["pattern_up"] = scene.pattern_up;
  json["held"] = point_json(scene.held, millimetres());
  json["across"] = number_json(scene.across);
  json["moments"] = moments_json(scene.moments);
  json["punch"] = segments_json(scene.punch);
  json["die"] = segments_json(scene.die);
  json["feet"] = segments_json(scene.feet);
  const auto& gauge = checked.stroke.gauge;
  json["gauge"] = gauge ? Json::array({point_json(gauge->edge.a, millimetres()),
                                       point_json(gauge->edge.b, millimetres())})
                        : Json(nullptr);
  json["gauge_height"] = gauge ? number_json(gauge->height) : Json(0.0);
  return json;
}

/// A sentence, and its pieces.
void add_sentence(Json& json, const Told& told, const Report& report) {
  const Told said = in_units(told, report.units);
  json["sentence"] = said.sentence;
  json["wording"] = wording_json(wording(said), Units(report.units));
}

Json blocked_stroke_json(const BlockedBend& blocked, const Report& report) {
  Json json = blocked_json(blocked, report);
  add_sentence(json, told_of(blocked, report), report);
  return json;
}

/// Those tools that the strokes use, by their ids.
Json sections_json(const CheckedOrder& checked, const BrakeTools& tools) {
  const ToolSections sections = tool_sections(tools);
  const auto uses = [&](std::string Stroke::*which, const std::string& id) {
    return std::ranges::any_of(checked.strokes,
                               [&](const CheckedStroke& s) { return s.stroke.*which == id; });
  };
  Json json;
  json["machine"] = tools.machine.name;
  for (const char* key : {"punches", "feet", "upper_beams", "dies"})
    json[key] = Json::object();
  for (std::size_t i = 0; i < tools.punches.size(); ++i) {
    const std::string& id = tools.punches[i].id;
    if (!uses(&Stroke::punch, id)) continue;
    json["punches"][id] = profile_json(sections.punches[i]);
    if (!sections.feet[i].empty()) json["feet"][id] = profile_json(sections.feet[i]);
    if (!sections.upper_beams.empty())
      json["upper_beams"][id] = profile_json(sections.upper_beams[i]);
  }
  for (std::size_t i = 0; i < tools.dies.size(); ++i)
    if (uses(&Stroke::die, tools.dies[i].id))
      json["dies"][tools.dies[i].id] = profile_json(sections.dies[i]);
  json["lower_beam"] = profile_json(sections.lower_beam);
  const auto& gauge = tools.machine.gauge;
  json["finger"] = gauge ? profile_json(gauge->finger) : Json::array();
  json["finger_width"] = gauge ? number_json(gauge->finger_width) : Json(0.0);
  const bool has_nose = gauge && gauge->nose;
  json["nose"] = has_nose ? profile_json(gauge->nose->profile) : Json::array();
  json["nose_width"] = has_nose ? number_json(gauge->nose->width) : Json(0.0);
  return json;
}

}  // namespace

Json planned_order_json(const Plan& plan, const Bending& bending, const Report& report) {
  Json json;
  json["status"] = status_word(plan);
  json["sentence"] = nullptr;
  if (plan.status == PlanStatus::infeasible)
    add_sentence(json, cannot_be_bent(report, plan, bending), report);
  if (plan.status == PlanStatus::gave_up) add_sentence(json, no_plan_found(plan), report);
  json["notes"] = Json::array();
  for (const Remark& remark : plan.remarks)
    json["notes"].push_back(in_units(remark.told, report.units).sentence);
  return json;
}

Json checked_order_json(const CheckedOrder& checked) {
  Json json;
  json["status"] = checked.feasible() ? "possible" : "blocked";
  json["sentence"] = nullptr;
  json["notes"] = Json::array();
  return json;
}

void add_order(Json& json, const CheckedOrder& checked, const Report& report,
               const BrakeTools& tools) {
  json["units"] = Units(report.units).name();
  json["thickness"] = number_json(report.sheet.thickness);
  json["cost"] = checked.feasible() ? number_json(checked.cost) : Json(nullptr);
  json["turn_overs"] = checked.turn_overs;
  json["rotations"] = checked.rotations;
  json["tool_changes"] = checked.tool_changes;
  json["ungauged"] = checked.ungauged;
  json["v_away"] = checked.v_away;
  json["strokes"] = Json::array();
  const auto checks = checks_of(report, mapped(checked.strokes, &CheckedStroke::stroke));
  for (const CheckedStroke& stroke : checked.strokes) {
    Json row = stroke_json(stroke.stroke, checks[json["strokes"].size()], report);
    row["blocked"] = stroke.blocked ? blocked_stroke_json(*stroke.blocked, report) : Json(nullptr);
    row["scene"] = scene_json(stroke);
    json["strokes"].push_back(std::move(row));
  }
  json["stations"] = stations_json(checked.stations, report);
  json["tools"] = sections_json(checked, tools);
}

}  // namespace planish::job
