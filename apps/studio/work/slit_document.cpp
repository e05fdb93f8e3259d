#include "attachments.hpp"
#include "document.hpp"
#include "draft_session.hpp"
#include "made_files.hpp"
#include "remembered.hpp"

#include <planish/brep/step.hpp>
#include <planish/io/mesh_writers.hpp>
#include <planish/job/slit.hpp>
#include <planish/slit/mould.hpp>

namespace planish::studio {
namespace {

using job::SlitReport;

constexpr int kErrorOfForm = 4;  // exit status: understood, but there is no such form

Json curve_json(const BezierCurve& curve, Vec3 (*place)(const Vec2&)) {
  constexpr int kChords = 64;
  Json json = Json::array();
  for (int i = 0; i <= kChords && !curve.poles.empty(); ++i)
    json.push_back(point_json(place(bezier_at(curve, static_cast<double>(i) / kChords).point)));
  return json;
}

Json ridges_json(const FoldedSlitSheet& folded) {
  Json json = Json::array();
  for (const FoldedStrip& strip : folded.strips) {
    json.push_back(Json::array());
    for (const SlitRidge& ridge : strip.ridges)
      json.back().push_back({point_json(ridge.folded[0]), point_json(ridge.folded[1])});
  }
  return json;
}

/// At most 5000 points of all scans, evenly picked.
Json scan_json(const std::vector<SlitScan>& scans, const Eigen::Isometry3d& motion) {
  constexpr std::size_t kMost = 5000;
  std::size_t count = 0, seen = 0;
  for (const SlitScan& scan : scans)
    count += scan.points.size();
  const std::size_t step = (count + kMost - 1) / kMost;
  Json json = Json::array();
  for (const SlitScan& scan : scans)
    for (const Vec3& p : scan.points)
      if (seen++ % step == 0) json.push_back(point_json(motion * p));
  return json;
}

Json handles_of(const SlitDesign& design, const SlitReport& report) {
  Json json;
  json["leg_curve"] = curve_json(design.leg_curve,
                                 [](const Vec2& p) { return Vec3(p.x(), 0, p.y()); });
  if (design.seat_curve)
    json["seat_curve"] = curve_json(*design.seat_curve,
                                    [](const Vec2& p) { return Vec3(0, p.x(), p.y()); });
  json["ridges"] = ridges_json(report.folded);
  json["scan"] = scan_json(design.scans, report.scan_motion);
  return json;
}

/// They are drawn; while somebody drags they are too many to be told of one by one.
void leave_out_ridges(SlitReport& report) {
  report.flat.bends.clear();
  for (FoldedStrip& strip : report.folded.strips)
    strip.ridges.clear();
}

class SlitDocument : public Document {
 public:
  SlitDocument(std::string name, std::filesystem::path attachments)
      : name_(std::move(name)), attachments_(std::move(attachments)) {}

  std::string_view kind() const override { return "slit"; }

  Result<Shape> shape(const Asked& asked, job::Effort effort, const Progress& progress) override {
    const auto file = spec_of(asked);
    if (!file) return tl::unexpected(file.error());
    const bool is_draft = effort == job::Effort::draft;
    auto report = is_draft ? draft(*file, asked, progress) : result(*file, asked, progress);
    if (!report) return tl::unexpected(report.error());
    Shape shape;
    shape.handles = handles_of(file->design, *report);
    add_sheet(shape, *report, effort);
    if (is_draft) leave_out_ridges(*report);
    shape.report = report_json(*report);
    return shape;
  }

  Result<MadeFile> file(const Asked& asked, const std::string& format,
                        const Progress& progress) override {
    const auto file = spec_of(asked);
    if (!file) return tl::unexpected(file.error());
    const auto report = result(*file, asked, progress);
    if (!report) return tl::unexpected(report.error());
    if (format == "json") return MadeFile{kJsonType, report_json(*report)};
    // Ridges are drawn but too many to be labelled; strips are.
    if (auto common = common_file(*report, asked, format, {.labels = false}))
      return std::move(*common);
    if (auto whole = not_refused(*report); !whole) return tl::unexpected(whole.error());
    if (format == "step")
      return as_file(folded_surface_step(sheet_of(report->folded), report->body), kStepType);
    if (format == "stl")
      return MadeFile{kStlType, stl_binary(mesh_of(report->folded), report->body)};
    if (format != "mould.stl") return tl::unexpected(no_such_format(format));
    const auto mould = mould_of(report->folded);
    if (!mould) return tl::unexpected(mould.error());
    return MadeFile{kStlType, stl_binary(mesh_of(*mould), report->body + " mould")};
  }

 private:
  Result<job::SlitFile> spec_of(const Asked& asked) const {
    if (auto given = has_spec(asked); !given) return tl::unexpected(given.error());
    if (auto plain = check_attachments(asked.spec, name_, attachments_); !plain)
      return tl::unexpected(plain.error());
    auto file = job::parse_slits(asked.spec, name_, attachments_);
    if (file && asked.align_scans) file->align_scans = *asked.align_scans;
    return file;
  }

  Result<SlitReport> result(const job::SlitFile& file, const Asked& asked,
                            const Progress& progress) {
    return last_.get(asked.key, [&] {
      return job::slit_sheet(file, make_request(asked, name_, job::Effort::full), progress);
    });
  }

  /// As far as a moment allows: strips that are not at their best then are `open`, and the next
  /// draft goes on.
  Result<SlitReport> draft(const job::SlitFile& file, const Asked& asked,
                           const Progress& progress) {
    const job::MakeRequest request = make_request(asked, name_, job::Effort::draft);
    if (auto followed = session_.follow(file, progress); !followed)
      return refused(request, followed.error());
    auto report = job::slit_solved(session_.now(), file, request, progress);
    if (report) report->scan_motion = session_.scan_motion();
    return report;
  }

  static Result<SlitReport> refused(const job::MakeRequest& request, const Error& error) {
    if (exit_status(error.code) != kErrorOfForm) return tl::unexpected(error);
    return job::failed_slit(request, error);
  }

  std::string name_;
  std::filesystem::path attachments_;
  DraftSession session_;
  Remembered<SlitReport> last_;
};

}  // namespace

Result<std::unique_ptr<Document>> open_slit(const std::string& name, const std::string& json,
                                            const std::filesystem::path& attachments) {
  // The files that it names come later.
  const auto alone = without_attachments(json, name);
  if (!alone) return tl::unexpected(alone.error());
  if (const auto file = job::parse_slits(*alone, name, attachments); !file)
    return tl::unexpected(file.error());
  return std::make_unique<SlitDocument>(name, attachments);
}

}  // namespace planish::studio
