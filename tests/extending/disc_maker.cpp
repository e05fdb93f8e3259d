#include "disc_maker.hpp"

#include "lay_flat.hpp"
#include "made_report.hpp"
#include "makers.hpp"
#include "report_text.hpp"

#include <planish/base/message.hpp>
#include <planish/schema/json_reading.hpp>
#include <planish/sheet/builder.hpp>

#include <numbers>

namespace planish::job {
using namespace schema;

struct DiscFile {
  double radius = 0.0, thickness = 0.0;  ///< mm
  LengthUnit units = LengthUnit::mm;     ///< of the file
};

struct DiscReport : Report {};

/// An option that no other maker has: the least radius that the shop can turn.
const Option& least_radius() {
  static const Option entry{.name = "least_radius",
                            .kind = OptionKind::number,
                            .group = OptionGroup::checks,
                            .description = "a smaller disc gives a finding, mm",
                            .otherwise = "20",
                            .range = kAboveZero};
  return entry;
}

double least_radius_of(const Request& request) {
  const auto given = request.own.find(least_radius().name);
  return given == request.own.end() ? 20.0 : std::get<double>(given->second);
}

std::string report_json(const DiscReport& report) {
  Json json = begun_report(report, "disc");
  finish_report(json, report);
  return text_of(json);
}

std::string report_text(const DiscReport& report) {
  return text_of(report, input_name(report), {});
}

namespace {

const Schema& disc_schema() {
  static const Schema schema = [] {
    std::vector<Field> fields = header_fields("example/disc", 1);
    fields.push_back(optional("units", units()));
    fields.push_back(required("radius", length(kAboveZero).said("of the plate")));
    fields.push_back(required("thickness", length(kAboveZero).said("of the sheet")));
    return object(std::move(fields)).said("A round flat plate");
  }();
  return schema;
}

Result<DiscFile> parse_disc(const std::string& content, const std::string& name) {
  JsonReading reading(content, "disc file", name, disc_schema());
  const JsonPlace place(reading);
  DiscFile file{place["radius"].length(), place["thickness"].length(), reading.unit()};
  if (reading.error()) return tl::unexpected(*reading.error());
  return file;
}

/// A round plate about the origin: one flange of one face, whose border is one full circle.
Result<Sheet> sheet_of(const DiscFile& file) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  Border border{Arc{Vec2::Zero(), file.radius, 0.0, kTurn}};
  border.edge_length = kTurn * file.radius;
  SheetBuilder builder(file.thickness);
  Face face;
  face.surface = Frame{};
  face.part_of = builder.add_flange();
  face.loops = {{border}};
  builder.add_face(std::move(face));
  builder.number_edges();
  builder.set_volume(std::numbers::pi * file.radius * file.radius * file.thickness);
  return std::move(builder).build();
}

Finding small_disc(double radius, double least) {
  Told told = tell("the disc has a radius of {radius}, less than {least}",
                   {{"radius", radius, unit::mm}, {"least", least, unit::mm}});
  return {.code = "small_disc",
          .severity = Severity::warning,
          .message = std::move(told.sentence),
          .at = {Vec2(radius, radius)},
          .numbers = std::move(told.numbers),
          .remedies = {{.change = "Make it larger, or have it turned by another shop."}}};
}

Outcome<std::unique_ptr<Made>> make(const DiscFile& file, const Request& request,
                                    const Progress& progress) {
  const auto sheet = sheet_of(file);
  if (!sheet) return pass_on(sheet);
  const EdgeDistance distance = border_distance(*sheet);
  auto report = shown(reported(begun<DiscReport>(request, file.units), [&](DiscReport& filled) {
    filled.summary = summary_of(*sheet);
    if (const double least = least_radius_of(request); file.radius < least)
      filled.findings.push_back(small_disc(file.radius, least));
    return lay_flat(filled, {*sheet, distance, request}, FlattenOptions(), progress);
  }));
  if (!report) return pass_on(report);
  return std::make_unique<MadeReport<DiscReport>>(std::move(*report));
}

}  // namespace

Maker disc_maker() {
  return {
      .name = "disc",
      .description = "make a round flat plate",
      .input = "disc",
      .format = "example/disc",
      .mark = "radius",
      .examples = {{"planish disc disc.json", "a round flat plate"}},
      .help = "Example:\n  planish disc disc.json",
      .sources = {Source::pattern},
      .options = with_pattern_options({{"units", "that of the disc file"},
                                       {.name = least_radius().name, .own = &least_radius()}}),
      .schema = disc_schema,
      .open = SpecWork<DiscFile, parse_disc, make>::open,
      .failed = failed_as<MadeReport<DiscReport>, DiscReport>,
  };
}

}  // namespace planish::job
