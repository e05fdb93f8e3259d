#include "folded.hpp"
#include "made_report.hpp"
#include "makers.hpp"
#include "report_schema.hpp"

#include <planish/brep/step.hpp>
#include <planish/connect/connect.hpp>
#include <planish/job/connect.hpp>
#include <planish/job/plates_json.hpp>

namespace planish::job {
using namespace schema;

ReportDetails connect_report_details();  // connect_report.cpp

namespace {

constexpr auto kConnectHelp = R"(Examples:
  planish connect plates.json                  plates.step and plates.dxf beside it
  planish connect plates.json -o part.step --flat part.dxf --json report.json
  planish connect plates.json --flat part.svg  the flat pattern only, to look at
  planish connect plates.json --check          what comes of it, on the terminal
  cat plates.json | planish connect - -o part.step --din6935

Exit status:
  0 done (also with warnings)        3 a file cannot be read, is invalid or cannot be written
  1 internal error, or cancelled     4 refused: understood, but the plates cannot be joined so
  2 wrong usage

The plates file and all else in docs/connect.md.)";

class MadeConnection : public MadeReport<ConnectReport> {
 public:
  using MadeReport::MadeReport;
  MadeConnection(ConnectReport report, std::vector<Plate> plates)
      : MadeReport(std::move(report)), plates_(std::move(plates)) {}

  Result<std::string> folded_solid(int) const override { return checked_step(made_.solid); }
  Result<Mesh> folded_mesh() const override {
    return planish::folded_mesh(with_open_seam(made_.connection.sheet));
  }
  std::string handles() const override {
    Json json;
    json["plates"] = Json::array();
    for (const Plate& plate : plates_)
      json["plates"].push_back({{"id", plate.id}, {"corners", page_points(plate.outline)}});
    return page_text(json);
  }
  // Flange i is plate i.
  std::vector<std::string> flange_names() const override { return mapped(plates_, &Plate::id); }

 private:
  std::vector<Plate> plates_;  // as in the input, joined or not
};

Outcome<std::unique_ptr<Made>> connection_of(const PlatesFile& file, const Request& request,
                                             const Progress& progress) {
  auto report = shown(connect_plates(file, request, progress));
  if (!report) return pass_on(report);
  return std::make_unique<MadeConnection>(std::move(*report), file.structure.plates);
}

}  // namespace

Maker connect_maker() {
  return {
      .name = "connect",
      .description = "join plates by bends into one sheet",
      .input = "plates",
      .format = "planish/plates",
      .mark = "plates",
      .examples = {{"planish connect plates.json", "joins plates by bends, and lays them flat"}},
      .help = kConnectHelp,
      .sources = {Source::pattern, Source::folded_solid, Source::folded_mesh},
      .options = with_bending_options({{"units", "that of the plates file"},
                                       {"k", "that of the plates file, or 0.44"},
                                       {"k_table"},
                                       {"din6935"},
                                       {"material"},
                                       {"inside_radius", "that of the plates file"},
                                       {"lateral", "that of the plates file, or auto"},
                                       {"trade_off", "that of the plates file, or 1"},
                                       {"largest_span",
                                        "that of the plates file; for bends that the program "
                                        "finds, twice the diagonals of both plates"},
                                       {"trim", "that of the plates file, or auto"},
                                       {"process"},
                                       {"rules"},
                                       {"no_rules"}}),
      .schema = plates_schema,
      .report_details = connect_report_details,
      .open = SpecWork<PlatesFile, parse_plates, connection_of>::open,
      .failed = failed_as<MadeConnection, ConnectReport>,
  };
}

}  // namespace planish::job
