#include "document.hpp"
#include "made_files.hpp"
#include "remembered.hpp"

#include <planish/base/progress_part.hpp>
#include <planish/brep/step.hpp>
#include <planish/io/mesh_writers.hpp>
#include <planish/job/info.hpp>
#include <planish/job/unfold.hpp>

#include <fmt/format.h>

#include <map>

namespace planish::studio {
namespace {

using job::UnfoldReport;

constexpr double kRead = 0.7;  // share of opening a file, the rest is measuring its bodies

class UnfoldDocument : public Document {
 public:
  UnfoldDocument(std::string name, StepFile file)
      : name_(std::move(name)), file_(std::move(file)) {}

  std::string_view kind() const override { return "unfold"; }

  Json info(const Progress& progress) const override {
    const auto info = job::info_of(file_, {.input = name_, .body = {}},
                                   part_of(progress, kRead, 1.0));
    return Json::parse(job::info_json(info.value()));
  }

  Result<Shape> shape(const Asked& asked, job::Effort effort, const Progress& progress) override {
    const auto report = report_of(asked, effort, progress);
    if (!report) return tl::unexpected(report.error());
    Shape shape;
    shape.report = report_json(*report);
    add_sheet(shape, *report, effort);
    if (report->refusal) add_solid(shape, file_.bodies[static_cast<std::size_t>(asked.body) - 1]);
    return shape;
  }

  Result<MadeFile> file(const Asked& asked, const std::string& format,
                        const Progress& progress) override {
    const auto report = report_of(asked, job::Effort::full, progress);
    if (!report) return tl::unexpected(report.error());
    if (format == "json") return MadeFile{kJsonType, report_json(*report)};
    if (auto common = common_file(*report, asked, format == "step" ? "flat.step" : format))
      return std::move(*common);
    if (format != "stl") return tl::unexpected(no_such_format(format));
    const auto mesh = body_mesh(file_.bodies[static_cast<std::size_t>(asked.body) - 1]);
    if (!mesh) return tl::unexpected(mesh.error());
    return MadeFile{kStlType, stl_binary(*mesh, report->body)};
  }

 private:
  Result<UnfoldReport> report_of(const Asked& asked, job::Effort effort, const Progress& progress) {
    const auto make = [&]() -> Result<UnfoldReport> {
      const int count = static_cast<int>(file_.bodies.size());
      if (asked.body > count)
        return fail(ErrorCode::no_such_body,
                    fmt::format("there is no body {}; the file has {}", asked.body, count),
                    "/options/body");
      const Body& body = file_.bodies[static_cast<std::size_t>(asked.body) - 1];
      auto report = job::unfold_recognized(body, sheet_of(asked.body, progress),
                                           request_of(asked, effort), progress);
      if (!report) return report;
      report->input = name_;
      report->number = asked.body;
      report->bodies_in_file = count;
      return report;
    };
    return effort == job::Effort::draft ? make() : last_.get(asked.key, make);
  }

  job::UnfoldRequest request_of(const Asked& asked, job::Effort effort) const {
    job::UnfoldRequest request;
    request.effort = effort;
    request.density = asked.density;
    request.input = name_;
    request.allowance = asked.k.value_or(ConstantK{});
    request.bend_k = asked.bend_k;
    request.root = asked.root;
    request.up = asked.up;
    request.units = asked.units.value_or(LengthUnit::mm);
    return request;
  }

  /// Found once a body.
  const Result<Recognized>& sheet_of(int body, const Progress& progress) {
    const auto known = found_.find(body);
    if (known != found_.end()) return known->second;
    progress.at("finding the sheet", 0.2);
    return found_.emplace(body, recognize(file_.bodies[static_cast<std::size_t>(body) - 1]))
        .first->second;
  }

  /// Whoever is refused wants to see of what; where the kernel has no mesh there is nothing to see.
  static void add_solid(Shape& shape, const Body& body) {
    constexpr double kShare = 1e-3;  // of the extent
    if (const auto mesh = body_mesh(body, kShare * body.size().norm())) add_space(shape, *mesh);
  }

  std::string name_;
  StepFile file_;
  std::map<int, Result<Recognized>> found_;
  Remembered<UnfoldReport> last_;
};

}  // namespace

Result<std::unique_ptr<Document>> open_unfold(const std::string& name, const std::string& bytes,
                                              const Progress& progress) {
  auto file = read_step_text(bytes, name, part_of(progress, 0.0, kRead));
  if (!file) return tl::unexpected(file.error());
  return std::make_unique<UnfoldDocument>(name, std::move(*file));
}

}  // namespace planish::studio
