#include "report_schema.hpp"

#include "places_json.hpp"
#include "plan_report.hpp"
#include "tree_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace planish::job {
using namespace schema;
namespace {

Schema status_schema() { return words({"ok", "warning", "refused"}); }

Schema sheet_schema() {
  return object({required("thickness", measured_length()),
                 required("thickness_spread", measured_length()),
                 required("k_factor", measured_number().said("null where bends differ")),
                 required("k_source", any_text().or_null()), required("flanges", whole()),
                 required("bends", whole()), required("volume", volume().or_null()),
                 required("mass", measured_number().said("kg"))});
}

Schema bend_schema(const std::vector<Field>& details) {
  std::vector<Field> fields{
      required("id", text()),
      required("order", whole(1).or_null().said("of the stroke, if there is a plan")),
      required("kind", words({"cylinder", "cone", "general", "sharp"})),
      required("angle", angle(kAnyNumber).or_null()),
      required("inside_radius", measured_length()),
      required("k_factor", measured_number()),
      required("k_source", any_text()),
      required("allowance", measured_length()),
      required("deduction", measured_length()),
      required("direction", words({"up", "down"})),
      required("length", measured_length()),
      required("line", list(report_point())),
      required("lines", list(report_line()))};
  fields.insert(fields.end(), details.begin(), details.end());
  return object(std::move(fields));
}

Schema flat_schema(const std::vector<Field>& bend_details) {
  const Schema feature = object(
      {required("kind", text()), required("side", words({"both", "up", "down"})),
       required("at", report_point().or_null()), required("size", report_point().or_null()),
       required("openings", whole().said("that are not cut")),
       optional("beyond", measured_length().said("what is cut"))});
  const Schema label = object({required("text", any_text()), required("at", report_point())});
  return object({required("area", measured_area()), required("perimeter", measured_length()),
                 required("size", report_point()), required("openings", whole()),
                 optional("slits", whole().said("lines that are cut")),
                 required("cutting", object({required("outer", measured_length()),
                                             required("inner", measured_length())})),
                 required("bends", list(bend_schema(bend_details))),
                 optional("tree", tree_schema()), optional("labels", list(label)),
                 required("features", list(feature))});
}

Schema verification_schema() {
  return object(
      {required("volume_ratio", measured_number()), required("explained_ratio", measured_number()),
       required("length_error", measured_length()), required("refold_deviation", measured_length()),
       optional("opening_error", measured_length()), optional("outline_error", measured_length()),
       required("closure", measured_length()), required("area_at_half", measured_area()),
       required("openings", object({optional("solid", whole()), required("pattern", whole()),
                                    optional("slits", whole(1).said("of those of the pattern")),
                                    required("features", whole()), optional("loops", whole(1))})),
       required("places", object({required("length_error", report_point()),
                                  required("refold_deviation", report_point()),
                                  optional("opening_error", report_point()),
                                  optional("outline_error", report_point())}))});
}

void append(std::vector<Field>& all, std::vector<Field> more) {
  for (Field& field : more)
    if (std::ranges::none_of(all, [&](const Field& f) { return f.key == field.key; }))
      all.push_back(std::move(field));
}

Schema check_schema() {
  const auto severity = [] { return words({"info", "warning", "error"}); };
  std::vector<Field> place = place_fields();
  append(place, {optional("severity", severity()), optional("message", any_text()),
                 optional("points", list(report_point())), optional("numbers", numbers_schema())});
  std::vector<Field> check{required("code", text()),
                           required("severity", severity()),
                           required("message", any_text()),
                           required("at", list(report_point())),
                           optional("count", whole(1)),
                           required("places", list(object(std::move(place)))),
                           required("numbers", numbers_schema())};
  append(check, remedy_fields());
  return object(std::move(check));
}

std::vector<Field> common_fields(const std::vector<Field>& bend_details) {
  return {required("units", words({"mm", "inch", "m"})),
          required("status", status_schema()),
          required("reason", reason_schema().or_null()),
          required("sheet", sheet_schema().or_null()),
          required("flat", flat_schema(bend_details).or_null()),
          required("verification", verification_schema().or_null()),
          required("checks", list(check_schema())),
          optional("plan", plan_schema()),
          required("notes", list(any_text())),
          required("files", list(text()))};
}

std::vector<Field> written_header(const char* format) {
  return {required("format", values({format}, format)), required("version", values({1}, "1"))};
}

Schema info_sheet_schema() {
  const Schema face = object({required("number", whole()), required("area", measured_area())});
  return object({required("reason", reason_schema().or_null()),
                 optional("thickness", measured_length()), optional("flanges", whole()),
                 optional("bends", whole()), optional("flange_faces", list(face))});
}

}  // namespace

Schema measured_number() { return number().or_null(); }
Schema measured_length() { return length().or_null(); }
Schema measured_area() { return area().or_null(); }
Schema report_point() { return tuple(2, measured_length(), "a point [x, y]"); }
Schema report_space_point() { return tuple(3, measured_length(), "a point [x, y, z]"); }
Schema report_line() { return tuple(2, report_point(), "two points"); }

Schema reason_schema() {
  std::vector<Field> reason{
      required("code", text()), required("message", any_text()), required("where", any_text()),
      required("places", list(object(place_fields()))), required("numbers", numbers_schema())};
  append(reason, remedy_fields());
  reason.push_back(optional("wording", wording_schema()));
  return object(std::move(reason));
}

std::vector<Field> common_report_fields() { return common_fields({}); }

Schema report_schema(const Catalogue& catalogue) {
  std::vector<std::string_view> names;
  std::vector<Field> report_details, bend_details;
  for (const Maker& maker : catalogue.makers) {
    names.push_back(maker.name);
    if (!maker.report_details) continue;
    ReportDetails details = maker.report_details();
    append(report_details, std::move(details.report));
    append(bend_details, std::move(details.bend));
  }
  // What else reports on what a maker makes.
  std::vector<std::string_view> others;
  for (const Task& task : catalogue.tasks)
    if (task.reader == Reader::by_format) others.push_back(task.name);
  names.insert(names.end(), others.begin(), others.end());
  std::vector<Field> fields = written_header("planish/report");
  fields.push_back(required(
      "command", words(names).said(fmt::format("the maker, or {}", fmt::join(others, " or ")))));
  fields.push_back(required("input", any_text()));
  append(fields, {optional("material", any_text()), optional("quantity", whole(1))});
  append(fields, common_fields(bend_details));
  append(fields, std::move(report_details));
  return object(std::move(fields)).said("What came of one part");
}

Schema summary_schema(const Catalogue& catalogue) {
  std::vector<Field> fields = written_header("planish/summary");
  append(fields,
         {required("command", words({"unfold"})), required("input", any_text()),
          required("units", words({"mm", "inch", "m"})), required("status", status_schema()),
          required("unfolded", whole()), required("refused", whole()), required("pieces", whole()),
          optional("surface_bodies", whole().said("shells that belong to no solid")),
          required("bodies", list(report_schema(catalogue)))});
  return object(std::move(fields)).said("What came of every body of a file");
}

Schema info_schema() {
  const Schema body = object(
      {required("number", whole(1)), required("name", any_text()), required("quantity", whole(1)),
       required("faces", whole()), required("size", report_space_point()),
       required("volume", volume().or_null()), optional("material", any_text()),
       optional("density", measured_number()), optional("colour", any_text()),
       optional("sheet", info_sheet_schema())});
  std::vector<Field> fields = written_header("planish/info");
  append(fields,
         {required("command", words({"info"})), required("input", any_text()),
          required("units", words({"mm", "inch", "m"})), required("status", status_schema()),
          required("reason", reason_schema().or_null()), required("schema", any_text()),
          required("cad_system", any_text()), required("file_units", any_text()),
          required("bodies", list(body)), required("surface_bodies", whole())});
  return object(std::move(fields)).said("What a STEP file holds");
}

}  // namespace planish::job
