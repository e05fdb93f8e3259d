#include "station_report.hpp"

#include "report_schema.hpp"

#include <planish/base/text.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/table.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace planish::job {
using namespace schema;
namespace {

Json lengths_json(const std::vector<double>& lengths, const Units& units) {
  return json_array(lengths, [&](double length) { return number_json(units.length(length)); });
}

Json ears_json(const SegmentRow& row) {
  Json ears = Json::array();
  if (row.left_ear > 0.0) ears.push_back("left");
  if (row.right_ear > 0.0) ears.push_back("right");
  return ears;
}

Json station_json(const Station& station, const Units& units) {
  Json json{{"set_up", station.set_up + 1}, {"punch", station.punch}, {"die", station.die}};
  add_rows(json, {"from", "segments", "ears", "punch_rows"}, station.punch_rows, units);
  add_rows(json, kDieRows, station.die_rows, units);
  json["strokes"] = json_array(station.strokes, [](int stroke) { return Json(stroke + 1); });
  return json;
}

}  // namespace

void add_rows(Json& json, const RowKeys& keys, const std::vector<SegmentRow>& rows,
              const Units& units) {
  SegmentRow all;
  if (!rows.empty()) all.from = rows.front().from;
  for (const SegmentRow& row : rows) {
    all.segments.insert(all.segments.end(), row.segments.begin(), row.segments.end());
    all.left_ear += row.left_ear;
    all.right_ear += row.right_ear;
  }
  json[keys.from] = number_json(units.length(all.from));
  json[keys.segments] = lengths_json(all.segments, units);
  if (Json ears = ears_json(all); !ears.empty()) json[keys.ears] = std::move(ears);
  if (rows.size() < 2) return;
  json[keys.rows] = json_array(rows, [&](const SegmentRow& row) {
    return Json{{"from", number_json(units.length(row.from))},
                {"segments", lengths_json(row.segments, units)}};
  });
}

Schema ears_schema() {
  return list(words({"left", "right"})).said("ends of the row that are ears");
}

Schema rows_schema() {
  return list(
      object({required("from", measured_length()), required("segments", list(measured_length()))}));
}

Json stations_json(const std::vector<Station>& stations, const Report& report) {
  return json_array(stations, [units = Units(report.units)](const Station& station) {
    return station_json(station, units);
  });
}

Schema station_schema() {
  const Schema lengths = list(measured_length());
  const Schema rows = rows_schema();
  return object({required("set_up", whole(1)), required("punch", text()), required("die", text()),
                 required("from", measured_length().said("of the punch, from the bed's left end")),
                 required("segments", lengths.said("of the punch")),
                 optional("ears", ears_schema()), required("die_from", measured_length()),
                 required("die_segments", lengths),
                 optional("punch_rows", rows.said("where gaps are between segments")),
                 optional("die_rows", rows), required("strokes", list(whole(1)))});
}

namespace {

/// "100 + 15, gap 126.5, 200"
std::string rows_text(const std::vector<SegmentRow>& rows, const Units& units) {
  std::string text;
  double end = 0.0;
  for (const SegmentRow& row : rows) {
    if (!text.empty()) text += fmt::format(", gap {}, ", units.length_text(row.from - end));
    text += text_of(row, [&](double one) { return units.short_text(one); });
    end = end_of(row);
  }
  return text;
}

}  // namespace

std::string stations_text(const Plan& plan, const Units& units) {
  if (plan.stations.empty()) return {};
  const Table::Column from{"from", Table::Align::right};
  Table table({{"set-up", Table::Align::right},
               {"punch"},
               from,
               {"segments"},
               {"die"},
               from,
               {"segments"},
               {"strokes"}});
  for (const Station& station : plan.stations)
    table.add(
        {std::to_string(station.set_up + 1), station.punch,
         units.length_text(station.punch_rows.front().from), rows_text(station.punch_rows, units),
         station.die, units.length_text(station.die_rows.front().from),
         rows_text(station.die_rows, units),
         fmt::format("{}", fmt::join(mapped(station.strokes, [](int s) { return s + 1; }), " "))});
  return table.text();
}

}  // namespace planish::job
