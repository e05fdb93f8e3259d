#include "plan_report.hpp"

#include "places_json.hpp"
#include "proposal_report.hpp"
#include "report_schema.hpp"
#include "station_report.hpp"

#include <planish/base/message.hpp>
#include <planish/base/text.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/drawing/bend_pages.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/table.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace planish::job {
using namespace schema;
namespace {

Json id_json(const std::optional<FlangeId>& flange) {
  return flange ? Json(flange_id(*flange)) : Json(nullptr);
}

Json gauge_json(const std::optional<GaugeStop>& gauge, const Report& report, const Units& units) {
  if (!gauge) return nullptr;
  Json json;
  json["distance"] = number_json(units.length(gauge->distance));
  json["edge"] = Json::array({point_json(gauge->edge.a, units), point_json(gauge->edge.b, units)});
  if (gauge->in_opening) json["opening"] = true;
  if (gauge->by_nose) json["nose"] = true;
  if (gauge->flange) json["flange"] = flange_id(*gauge->flange);
  if (gauge->fold) json["fold"] = bend_id(report, *gauge->fold);
  json["touched"] = number_json(units.length(gauge->touched));
  if (gauge->flange || gauge->fold || std::abs(gauge->height) > tolerance::kWrittenDigits)
    json["height"] = number_json(units.length(gauge->height));
  return json;
}

Schema gauge_schema() {
  return object({required("distance", measured_length().said("from the bend line")),
                 required("edge", report_line().said("that touches the fingers")),
                 optional("opening", flag().said("of the sheet: it touches in one")),
                 optional("nose", flag().said("touches instead of the finger")),
                 optional("flange", text().said("formed, whose face does")),
                 optional("fold", text().said("bend formed before, whose outside does")),
                 required("touched", measured_length().said("from the first finger to the last")),
                 optional("height", measured_length().said("of the fingers"))});
}

Schema stroke_schema() {
  const Schema rows = rows_schema();
  return object(
      {required("bends", list(text()).said("pressed together")),
       optional("press_line", whole(1).said("which one of a bend with several")),
       optional("flattening", flag().said("closes a hem that was bent before")),
       optional("open_hem",
                object({required("gap", measured_length().said("between its sides")),
                        required("height", measured_length().said(
                                               "of the punch above the die at the end"))})),
       required("angle", angle(kAnyNumber).or_null()),
       required("v_wanted", measured_length().or_null().said("opening of the V")),
       required("radius_drawn", measured_length().said("inside, of the bend")),
       required("radius_made", measured_length().said("inside, that these tools leave")),
       required("punch", text()),
       required("die", text()),
       required("punch_segments", list(measured_length())),
       required("punch_from", measured_length().said("from the end of the bend line")),
       optional("punch_ears", ears_schema()),
       optional("punch_rows", rows.said("where gaps are between segments")),
       required("die_segments", list(measured_length())),
       required("die_from", measured_length()),
       optional("die_rows", rows),
       required("side_up", words({"reference", "other"})),
       required("to_gauge", text().or_null().said("flange on the gauge's side")),
       required("gauge_direction",
                tuple(2, measured_number(), "a direction [x, y]").said("in the flat pattern")),
       required("gauge", gauge_schema().or_null()),
       optional("check_dimension",
                object({required("flange", text()),
                        required("length", measured_length().said("from the outside of the bend"))})
                    .said("to measure after the stroke")),
       required("force", measured_number().said("kN")),
       optional("on_ears", flag().said("the part reaches over the feet of ears")),
       required("clearance", measured_length().said("least that is left"))});
}

Schema remark_schema() {
  return object({required("code", text()), required("message", any_text()),
                 required("places", list(object(place_fields()))),
                 required("numbers", numbers_schema())});
}

Schema blocked_schema() {
  return object({required("bend", text()), required("hits", text().or_null()),
                 required("tool", words({"punch", "upper beam", "die", "lower beam"}).or_null()),
                 optional("tool_id", text()), required("with", text().or_null().said("flange")),
                 required("depth", measured_length()),
                 optional("through", flag().said("as deep as can be in that tool")),
                 required("at_turn", angle(kAnyNumber).or_null()), optional("why", text()),
                 optional("remark", remark_schema().said("`why` as data"))});
}

Json remark_json(const Remark& remark, const Units& units) {
  return {{"code", remark.code},
          {"message", in_units(remark.told, units.unit()).sentence},
          {"places", places_json(remark.told.places, units)},
          {"numbers", numbers_json(remark.told.numbers)}};
}

std::string gauge_text(const Stroke& stroke, const Units& units) {
  if (!stroke.gauge) return "none";
  return units.length_text(stroke.gauge->distance) +
         (stroke.gauge->in_opening ? " in the opening" : "");
}

std::string strokes_text(const Plan& plan, const Report& report, const Units& units) {
  if (plan.strokes.empty()) return {};
  using Align = Table::Align;
  Table table({{"stroke", Align::right},
               {"bends"},
               {"angle", Align::right},
               {"punch"},
               {"die"},
               {"side up"},
               {"to gauge"},
               {"gauge", Align::right},
               {"check"},
               {"force kN", Align::right}});
  const auto checks = checks_of(report, plan.strokes);
  std::size_t number = 0;
  for (const Stroke& stroke : plan.strokes) {
    const auto& check = checks[number];
    table.add(
        {std::to_string(++number),
         fmt::format("{}", fmt::join(bend_ids(report, stroke.bends), " ")),
         fmt::format("{:.1f}°", stroke.angle.degrees()), stroke.punch, stroke.die,
         std::string(drawing::side_up(stroke, report.layout)),
         stroke.to_gauge ? flange_id(*stroke.to_gauge) : "", gauge_text(stroke, units),
         check ? fmt::format("{} {}", flange_id(check->flange), units.length_text(check->length))
               : std::string(),
         fmt::format("{:.0f}", stroke.force)});
  }
  return table.text();
}

}  // namespace

bool nothing_to_bend(const Plan& plan) { return has_order(plan) && plan.strokes.empty(); }

std::vector<std::optional<CheckDimension>> checks_of(const Report& report,
                                                     const std::vector<Stroke>& strokes) {
  return check_dimensions(report.sheet, report.layout, report.flat, strokes, report.laid);
}

std::string flange_id(FlangeId flange) { return fmt::format("F{}", index_of(flange) + 1); }

std::string bend_id(const Report& report, BendId bend) {
  const auto found = std::ranges::find(report.flat.bends, bend, &FlatBend::bend);
  return found == report.flat.bends.end() ? fmt::format("B{}", index_of(bend) + 1) : found->id;
}

std::vector<std::string> bend_ids(const Report& report, const std::vector<BendId>& bends) {
  return mapped(bends, [&](BendId bend) { return bend_id(report, bend); });
}

std::string_view status_word(const Plan& plan) {
  if (nothing_to_bend(plan)) return "nothing_to_bend";
  return word_of(plan.status, {"optimal", "feasible", "infeasible", "gave_up"});
}

Json stroke_json(const Stroke& stroke, const std::optional<CheckDimension>& check,
                 const Report& report) {
  const Units units(report.units);
  Json json;
  json["bends"] = bend_ids(report, stroke.bends);
  if (stroke.press_line) json["press_line"] = *stroke.press_line + 1;
  if (stroke.flattening) json["flattening"] = true;
  if (stroke.open_hem)
    json["open_hem"] = {{"gap", number_json(units.length(stroke.open_hem->gap))},
                        {"height", number_json(units.length(stroke.open_hem->height))}};
  json["angle"] = number_json(stroke.angle.degrees());
  json["v_wanted"] = stroke.flattening ? Json(nullptr) : number_json(units.length(stroke.v_wanted));
  json["radius_drawn"] = number_json(units.length(stroke.radius_drawn));
  json["radius_made"] = number_json(units.length(stroke.radius_made));
  json["punch"] = stroke.punch;
  json["die"] = stroke.die;
  add_rows(json, {"punch_from", "punch_segments", "punch_ears", "punch_rows"}, stroke.punch_rows,
           units);
  add_rows(json, kDieRows, stroke.die_rows, units);
  json["side_up"] = stroke.reference_up ? "reference" : "other";
  json["to_gauge"] = id_json(stroke.to_gauge);
  json["gauge_direction"] = Json::array(
      {number_json(stroke.gauge_direction.x()), number_json(stroke.gauge_direction.y())});
  json["gauge"] = gauge_json(stroke.gauge, report, units);
  if (check)
    json["check_dimension"] = {{"flange", flange_id(check->flange)},
                               {"length", number_json(units.length(check->length))}};
  json["force"] = number_json(stroke.force);
  json["clearance"] = number_json(units.length(stroke.clearance));
  if (stroke.on_ears) json["on_ears"] = true;
  return json;
}

Json blocked_json(const BlockedBend& blocked, const Report& report) {
  const Units units(report.units);
  Json json;
  json["bend"] = bend_id(report, blocked.bend);
  json["hits"] = blocked.hits ? Json(text_of(*blocked.hits)) : Json(nullptr);
  json["tool"] = blocked.hits ? Json(kind_name(blocked.hits->kind)) : Json(nullptr);
  if (blocked.hits && !blocked.hits->id.empty()) json["tool_id"] = blocked.hits->id;
  json["with"] = id_json(blocked.with);
  json["depth"] = number_json(units.length(blocked.depth));
  if (blocked.through) json["through"] = true;
  json["at_turn"] = blocked.at_turn ? number_json(blocked.at_turn->degrees()) : Json(nullptr);
  if (blocked.why) {
    json["why"] = in_units(blocked.why->told, report.units).sentence;
    json["remark"] = remark_json(*blocked.why, units);
  }
  return json;
}

namespace {

Json large_json(const LargeBend& large, const Report& report) {
  const Units units(report.units);
  Json json{{"bend", bend_id(report, large.bend)},
            {"formed", word_of(large.forming, {"v", "bumps", "rolled"})}};
  if (large.forming != Forming::bumps) return json;
  json["bumps"] = large.bumps;
  json["pitch"] = number_json(units.length(large.pitch));
  json["angle"] = number_json(large.angle.degrees());
  json["chord_error"] = number_json(units.length(large.chord_error));
  return json;
}

Schema large_schema() {
  return object({required("bend", text()), required("formed", words({"v", "bumps", "rolled"})),
                 optional("bumps", whole(2)),
                 optional("pitch", measured_length().said("along the neutral surface")),
                 optional("angle", angle(kAnyNumber).said("of each bump")),
                 optional("chord_error",
                          measured_length().said("of the drawn radius from the pieces between"))});
}

Json as_made_json(const MadeFlat& made, const Report& report) {
  const Units units(report.units);
  Json bends = json_array(made.bends, [&](const MadeFlat::Row& row) -> Json {
    return {{"bend", bend_id(report, row.bend)},
            {"radius_drawn", number_json(units.length(row.drawn))},
            {"radius_made", number_json(units.length(row.made))},
            {"change", number_json(units.length(row.change))}};
  });
  return {{"length", number_json(units.length(made.size.x()))},
          {"width", number_json(units.length(made.size.y()))},
          {"bends", std::move(bends)}};
}

Schema as_made_schema() {
  return object(
             {required("length", measured_length()), required("width", measured_length()),
              required(
                  "bends",
                  list(object(
                      {required("bend", text()), required("radius_drawn", measured_length()),
                       required("radius_made", measured_length()),
                       required("change", measured_length().said("of the developed length"))})))})
      .said("the flat pattern for the radii that these tools make, where they are others");
}

std::string as_made_text(const Report& report) {
  if (!report.as_made) return {};
  const Units units(report.units);
  std::string text = fmt::format(
      "flat as made: {} × {}, for the radii that these tools leave (`--as-made`)\n",
      units.length_text(report.as_made->size.x()), units.length_text(report.as_made->size.y()));
  for (const MadeFlat::Row& row : report.as_made->bends)
    text += fmt::format("  {}: radius {} instead of {}, developed {} {}\n",
                        bend_id(report, row.bend), units.length_text(row.made),
                        units.length_text(row.drawn), units.length_text(std::abs(row.change)),
                        row.change < 0.0 ? "shorter" : "longer");
  return text;
}

}  // namespace

Json plan_json(const Plan& plan, const Report& report) {
  Json json;
  json["status"] = status_word(plan);
  json["cost"] = has_order(plan) ? number_json(plan.cost) : Json(nullptr);
  json["turn_overs"] = plan.turn_overs;
  json["rotations"] = plan.rotations;
  json["tool_changes"] = plan.tool_changes;
  json["ungauged"] = plan.ungauged;
  json["v_away"] = plan.v_away;
  json["states"] = plan.states;
  json["strokes"] = Json::array();
  const auto checks = checks_of(report, plan.strokes);
  for (std::size_t s = 0; s < plan.strokes.size(); ++s)
    json["strokes"].push_back(stroke_json(plan.strokes[s], checks[s], report));
  json["stations"] = stations_json(plan.stations, report);
  const auto in_the_way = [&](const std::vector<BlockedBend>& bends) {
    return json_array(bends, [&](const BlockedBend& one) { return blocked_json(one, report); });
  };
  json["blocked"] = in_the_way(plan.blocked);
  if (!plan.unformed.empty()) json["unformed"] = bend_ids(report, plan.unformed);
  if (!plan.in_the_way.empty()) json["in_the_way"] = in_the_way(plan.in_the_way);
  if (plan.status == PlanStatus::infeasible) json["proposals"] = proposals_json(plan, report);
  if (!plan.large.empty())
    json["large_radii"] = json_array(
        plan.large, [&](const LargeBend& large) { return large_json(large, report); });
  if (report.as_made) json["as_made"] = as_made_json(*report.as_made, report);
  json["remarks"] = json_array(
      plan.remarks, [&](const Remark& one) { return remark_json(one, Units(report.units)); });
  return json;
}

Schema plan_schema() {
  return object({required("status", words({"optimal", "feasible", "infeasible", "gave_up",
                                           "nothing_to_bend"})),
                 required("cost", measured_number().said("null if there is no plan")),
                 required("turn_overs", whole()), required("rotations", whole()),
                 required("tool_changes", whole()), required("ungauged", whole()),
                 required("v_away", whole().said("sizes from the wanted V, of all strokes")),
                 required("states", whole().said("stages that were looked at")),
                 required("strokes", list(stroke_schema())),
                 required("stations", list(station_schema()).said("of all set-ups")),
                 required("blocked", list(blocked_schema()).said("bends that no stage can form")),
                 optional("unformed", list(text()).said("bends left in the stage that got "
                                                        "furthest")),
                 optional("in_the_way",
                          list(blocked_schema()).said("of bends left there, of four at most")),
                 optional("proposals",
                          list(proposal_schema()).said("if infeasible: what it can be bent with")),
                 optional("large_radii",
                          list(large_schema()).said("bends of a radius that no usual V leaves")),
                 optional("as_made", as_made_schema()), required("remarks", list(remark_schema()))})
      .said("the strokes at a press brake, in order");
}

std::string plan_text(const Plan& plan, const Report& report) {
  const Units units(report.units);
  if (only_rolls(plan)) return "plan: no strokes: what is bent is rolled\n";
  if (nothing_to_bend(plan)) return "plan: nothing to bend\n";
  if (!has_order(plan))
    return fmt::format("plan: {} ({} examined)\n",
                       plan.status == PlanStatus::infeasible ? "impossible" : "none found",
                       counted(plan.states, "stage")) +
           proposals_text(plan, report);
  return fmt::format("plan: {}, cost {}: {}, {}, {}, {}\n{}", status_word(plan),
                     number_text(plan.cost), counted(plan.strokes.size(), "stroke"),
                     counted(plan.turn_overs, "turn-over"), counted(plan.rotations, "rotation"),
                     counted(plan.tool_changes, "tool change"), strokes_text(plan, report, units)) +
         stations_text(plan, units) + as_made_text(report);
}

}  // namespace planish::job
