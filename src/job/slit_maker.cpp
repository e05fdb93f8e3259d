#include "folded.hpp"
#include "made_report.hpp"
#include "makers.hpp"
#include "report_schema.hpp"
#include "slit_drafts.hpp"

#include <planish/brep/step.hpp>
#include <planish/job/slit.hpp>
#include <planish/job/slit_json.hpp>
#include <planish/slit/bezier.hpp>
#include <planish/slit/mould.hpp>

namespace planish::job {
using namespace schema;

ReportDetails slit_report_details();  // slit_report.cpp

namespace {

constexpr auto kSlitHelp = R"(Examples:
  planish slit chair.json                      chair.step and chair.dxf beside it
  planish slit chair.json -o folded.step --flat pattern.dxf --mould mould.stl --json report.json
  planish slit chair.json -o folded.stl --flat pattern.svg     to look at
  planish slit chair.json --check              what comes of it, on the terminal

Exit status:
  0 done (also with warnings)        3 a file cannot be read, is invalid or cannot be written
  1 internal error, or cancelled     4 refused: strips cannot reach, or curves do not fit
  2 wrong usage

The slit file and all else in docs/slit.md.)";

Json curve_json(const BezierCurve& curve, Vec3 (*place)(const Vec2&)) {
  constexpr int kChords = 64;
  Json json = Json::array();
  for (int i = 0; i <= kChords && !curve.poles.empty(); ++i)
    json.push_back(page_point(place(bezier_at(curve, static_cast<double>(i) / kChords).point)));
  return json;
}

Json ridges_json(const FoldedSlitSheet& folded) {
  Json json = Json::array();
  for (const FoldedStrip& strip : folded.strips) {
    json.push_back(Json::array());
    for (const SlitRidge& ridge : strip.ridges)
      json.back().push_back({page_point(ridge.folded[0]), page_point(ridge.folded[1])});
  }
  return json;
}

/// At most 5000 points of all scans, picked evenly.
Json scan_json(const std::vector<SlitScan>& scans, const Eigen::Isometry3d& motion) {
  constexpr std::size_t kMost = 5000;
  std::size_t count = 0, seen = 0;
  for (const SlitScan& scan : scans)
    count += scan.points.size();
  const std::size_t step = (count + kMost - 1) / kMost;
  Json json = Json::array();
  for (const SlitScan& scan : scans)
    for (const Vec3& p : scan.points)
      if (seen++ % step == 0) json.push_back(page_point(motion * p));
  return json;
}

class MadeSlitSheet : public MadeReport<SlitReport> {
 public:
  using MadeReport::MadeReport;
  /// `file`: the input, with the curves, scans and mould as asked for.
  MadeSlitSheet(SlitReport report, const SlitFile& file, const Request& request)
      : MadeReport(std::move(report)),
        asked_(file.design),
        mould_(file.mould),
        effort_(request.effort) {
    if (request.overbend) mould_.overbend = made_.design.material.value_or(SlitMaterial{});
  }

  /// During a drag ridges are drawn, but not reported one by one: there are too many.
  std::string json() const override {
    return report_json(made_, effort_ == Effort::draft ? Ridges::left_out : Ridges::told);
  }
  Result<std::string> folded_solid(int) const override {
    return folded_surface_step(sheet_of(made_.folded), made_.body);
  }
  Result<Mesh> folded_mesh() const override { return mesh_of(made_.folded); }
  Result<Mesh> mould_mesh() const override {
    const auto mould = mould_of(made_.folded, mould_);
    if (!mould) return pass_on(mould);
    return mesh_of(*mould);
  }
  // There are too many ridges to label; strips are labelled.
  SvgOptions svg() const override { return {.labels = false}; }
  std::string handles() const override {
    Json json;
    constexpr auto on_ground = [](const Vec2& p) { return Vec3(p.x(), 0, p.y()); };
    json["leg_curve"] = curve_json(asked_.leg_curve, on_ground);
    if (asked_.second_panel)
      json["second_leg_curve"] = curve_json(asked_.second_panel->leg_curve, on_ground);
    if (asked_.seat_curve)
      json["seat_curve"] = curve_json(*asked_.seat_curve,
                                      [](const Vec2& p) { return Vec3(0, p.x(), p.y()); });
    json["ridges"] = ridges_json(made_.folded);
    json["scan"] = scan_json(asked_.scans, made_.scan_motion);
    return page_text(json);
  }

 private:
  SlitDesign asked_;
  MouldOptions mould_;
  Effort effort_ = Effort::full;
};

/// Keeps the bent strips, so that each draft starts from the previous one.
class SlitWork : public Work {
 public:
  explicit SlitWork(SlitFile file) : file_(std::move(file)) {}

  Result<void> edit(const InputFile& input) override {
    auto file = parse_slits(input.content, input.name, input.folder);
    if (!file) return pass_on(file);
    file_ = std::move(*file);
    return {};
  }

  Outcome<std::unique_ptr<Made>> make(const Request& request, const Progress& progress) override {
    auto report = request.effort == Effort::draft ? draft(request, progress)
                                                  : shown(slit_sheet(file_, request, progress));
    if (!report) return pass_on(report);
    return std::make_unique<MadeSlitSheet>(std::move(*report), file_, request);
  }

 private:
  /// Solves for a moment: strips that are not finished then are `open`, and the next draft
  /// continues. The report may be refused.
  Result<SlitReport> draft(const Request& request, const Progress& progress) {
    if (auto followed = drafts_.follow(file_, progress); !followed) {
      const Error error = placed(followed.error(), place_name(request.input.string()));
      if (error.code.status != ExitStatus::refused) return tl::unexpected(error);
      return failed_report<SlitReport>(request, error);
    }
    auto report = shown(slit_solved(drafts_.now(), file_, request, progress));
    if (report) report->scan_motion = drafts_.scan_motion();
    return report;
  }

  SlitFile file_;
  SlitDrafts drafts_;
};

Result<std::unique_ptr<Work>> open_slits(const InputFile& input, const Progress&) {
  auto file = parse_slits(input.content, input.name, input.folder);
  if (!file) return pass_on(file);
  return std::make_unique<SlitWork>(std::move(*file));
}

}  // namespace

Maker slit_maker() {
  return {
      .name = "slit",
      .description = "bend the strips of a slit sheet into a form",
      .input = "slit",
      .format = "planish/slits",
      .mark = "leg_curve",
      .examples = {{"planish slit chair.json", "bends the strips of a slit sheet"}},
      .help = kSlitHelp,
      .sources = {Source::pattern, Source::folded_solid, Source::folded_mesh, Source::mould_mesh},
      .options = with_pattern_options({{"units", "that of the slit file"}, {"overbend"}}),
      .schema = slits_schema,
      .report_details = slit_report_details,
      .open = open_slits,
      .failed = failed_as<MadeSlitSheet, SlitReport>,
      .named_files = slit_files_of,
  };
}

}  // namespace planish::job
