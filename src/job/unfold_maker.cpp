#include "input.hpp"
#include "lay_flat.hpp"
#include "made_report.hpp"
#include "makers.hpp"
#include "report_schema.hpp"

#include <planish/base/progress_part.hpp>
#include <planish/brep/step.hpp>
#include <planish/job/info.hpp>
#include <planish/job/unfold.hpp>

#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace planish::job {
using namespace schema;

ReportDetails unfold_report_details();  // report_json.cpp

namespace {

constexpr auto kUnfoldHelp = R"(Examples:
  planish unfold part.step                     part.dxf beside it, a summary here
  planish unfold part.step -o a.dxf -o a.svg   two files of one pattern
  planish unfold part.step --k-table steel.csv --json part.json
  planish unfold cabinet.step --body door      one body of several
  planish unfold cabinet.step --all -o flat/   every body, with summary.csv
  planish unfold part.step --r12 --profile onshape --units inch
  planish unfold --print-rules > rules.json    thresholds to edit, for --rules
  cat part.step | planish unfold - --check --json -

Exit status:
  0 done (also with warnings)        3 a file cannot be read, is invalid or cannot be written
  1 internal error, or cancelled     4 refused: understood, but no flat pattern exists
  2 wrong usage                        (or, with --all, of none of the bodies)

More in docs/cli.md.)";

constexpr double kRead = 0.7;  // share of the progress taken by opening a file; the rest is
                               // measuring its bodies

class MadeUnfolded : public MadeReport<UnfoldReport> {
 public:
  using MadeReport::MadeReport;
  MadeUnfolded(UnfoldReport report, const Body& body)
      : MadeReport(std::move(report)), body_(body) {}

  Result<Mesh> folded_mesh() const override {
    if (!body_) return Made::folded_mesh();
    auto surface = body_mesh(*body_);
    if (!surface) return pass_on(surface);
    return std::move(surface->mesh);
  }
  // Shows what was refused, but for faces that the kernel cannot mesh.
  std::optional<MeshOfFaces> refused_solid() const override {
    if (!body_) return std::nullopt;
    constexpr double kShare = 1e-3;  // of the extent
    auto surface = body_mesh_in_part(*body_, kShare * body_->size().norm());
    return surface ? std::optional(std::move(*surface)) : std::nullopt;
  }

 private:
  std::optional<Body> body_;
};

/// Keeps the file as read, and the sheets found in its bodies.
class UnfoldWork : public Work {
 public:
  UnfoldWork(std::string name, StepFile file) : name_(std::move(name)), file_(std::move(file)) {}

  std::string info(const Progress& progress) const override {
    const auto info = info_of(file_, {.input = name_, .body = {}}, part_of(progress, kRead, 1.0));
    return info ? info_json(*info) : "null";
  }

  Outcome<std::unique_ptr<Made>> make(const Request& request, const Progress& progress) override {
    const auto index = choose_body(file_, request.body);
    if (!index) return pass_on(index);
    const Body& body = file_.bodies[*index];
    auto report = shown(
        unfold_recognized(body, sheet_of(*index, request, progress), request, progress));
    if (!report) return pass_on(report);
    report->input = request.input.string();
    place_in_file(*report, file_, *index);
    return std::make_unique<MadeUnfolded>(std::move(*report), body);
  }

  bool free_spare() override { return std::exchange(file_.content, nullptr) != nullptr; }

 private:
  /// Recognised once per body and what is looked for.
  const Result<Recognized>& sheet_of(int body, const Request& request, const Progress& progress) {
    const Sought sought{body, request.rip_edges, request.thickness};
    const auto known = found_.find(sought);
    const auto stopped = [](const Result<Recognized>& found) {
      return !found && found.error().code == code::cancelled;
    };
    if (known != found_.end() && !stopped(known->second)) return known->second;
    progress.at("finding the sheet", 0.2);
    auto found = found_sheet(file_.bodies[body], sought_by(request), progress);
    return found_.insert_or_assign(sought, std::move(found)).first->second;
  }

  using Sought = std::tuple<int, std::vector<int>, std::optional<double>>;

  std::string name_;
  StepFile file_;
  std::map<Sought, Result<Recognized>> found_;
};

Result<std::unique_ptr<Work>> open_model(const InputFile& input, const Progress& progress) {
  auto file = read_step_text(input.content, input.name, part_of(progress, 0.0, kRead));
  if (!file) return pass_on(file);
  return std::make_unique<UnfoldWork>(input.name, std::move(*file));
}

std::unique_ptr<Made> failed(const Request& request, const Error& error) {
  return std::make_unique<MadeUnfolded>(failed_unfold(request, error));
}

}  // namespace

std::unique_ptr<Made> made_of(const UnfoldReport& report) {
  return std::make_unique<MadeUnfolded>(report);
}

Maker unfold_maker() {
  return {
      .name = "unfold",
      .description = "lay a sheet-metal part flat",
      .input = "STEP",
      .examples = {{"planish unfold part.step", "writes part.dxf beside it, and prints a summary"},
                   {"planish unfold cabinet.step --all -o flat/",
                    "unfolds every body, with summary.csv"}},
      .help = kUnfoldHelp,
      .sources = {Source::pattern, Source::folded_mesh},
      .options = with_bending_options({{"body"},
                                       {"units", "mm"},
                                       {"k", "0.44"},
                                       {"k_table"},
                                       {"din6935"},
                                       {"material"},
                                       {"bend_k"},
                                       {"root"},
                                       {"rip_edges"},
                                       {"thickness"},
                                       {"up"},
                                       {"extruded"},
                                       {"relief"},
                                       {"bend_relief"},
                                       {"rip_width"},
                                       {"process"},
                                       {"rules"},
                                       {"no_rules"}}),
      .report_details = unfold_report_details,
      .open = open_model,
      .failed = failed,
  };
}

}  // namespace planish::job
