#include "folded.hpp"
#include "made_report.hpp"
#include "makers.hpp"
#include "profile_points.hpp"
#include "report_schema.hpp"

#include <planish/job/transition.hpp>
#include <planish/job/transition_json.hpp>

namespace planish::job {
using namespace schema;

ReportDetails transition_report_details();  // transition_report.cpp

namespace {

constexpr auto kTransitionHelp = R"(Examples:
  planish transition spec.json                 spec.step and spec.dxf beside it
  planish transition spec.json -o part.step --flat net.dxf --json report.json
  planish transition spec.json --flat net.svg  the net only, to look at
  planish transition spec.json --check         what comes of it, on the terminal

Of several pieces each has files of its own: net-1.dxf, net-2.dxf, ...

Exit status:
  0 done (also with warnings)        3 a file cannot be read, is invalid or cannot be written
  1 internal error, or cancelled     4 refused: understood, but the profiles have no transition
  2 wrong usage

The transition file and all else in docs/transition.md.)";

class MadeTransition : public MadeReport<TransitionReport> {
 public:
  using MadeReport::MadeReport;

  int pieces() const override { return static_cast<int>(made_.pieces.size()); }
  const Report& piece(int i) const override { return made_.pieces[i]; }
  Result<std::string> folded_solid(int i) const override {
    return checked_step(made_.pieces[i].solid);
  }
  // Of all pieces together.
  Result<Mesh> folded_mesh() const override { return made_.transition.mesh; }
  std::string handles() const override {
    Json json;
    for (const PlacedProfile* profile : {&made_.spec.from, &made_.spec.to})
      json["profiles"].push_back(
          {{"points", page_points(profile_points(*profile, made_.transition.mesh))}});
    return page_text(json);
  }
};

Outcome<std::unique_ptr<Made>> transition_of(const TransitionFile& file, const Request& request,
                                             const Progress& progress) {
  auto report = shown(transition_between(file, request, progress));
  if (!report) return pass_on(report);
  // Nobody reads them during a drag, and they would be half of what is sent.
  if (request.effort == Effort::draft) report->transition.true_lengths.clear();
  return std::make_unique<MadeTransition>(std::move(*report));
}

}  // namespace

Maker transition_maker() {
  return {
      .name = "transition",
      .description = "make the surface between two profiles, and its net",
      .input = "transition",
      .format = "planish/transition",
      .mark = "from",
      .examples = {{"planish transition spec.json", "joins two profiles, and makes the net"}},
      .help = kTransitionHelp,
      .sources = {Source::pattern, Source::folded_solid, Source::folded_mesh},
      .options = with_bending_options({{"units", "that of the transition file"},
                                       {"piece"},
                                       {"material"},
                                       {"k", "that of the transition file, or 0.5"},
                                       {"process"},
                                       {"rules"},
                                       {"no_rules"}}),
      .schema = transition_schema,
      .report_details = transition_report_details,
      .open = SpecWork<TransitionFile, parse_transition, transition_of>::open,
      .failed = failed_as<MadeTransition, TransitionReport>,
  };
}

}  // namespace planish::job
