#include "document.hpp"
#include "made_files.hpp"
#include "remembered.hpp"

#include <planish/brep/step.hpp>
#include <planish/io/mesh_writers.hpp>
#include <planish/job/connect.hpp>

namespace planish::studio {
namespace {

using job::ConnectReport;

Json handles_of(const PlateStructure& structure) {
  Json json;
  json["plates"] = Json::array();
  for (const Plate& plate : structure.plates)
    json["plates"].push_back({{"id", plate.id}, {"corners", points_json(plate.outline)}});
  return json;
}

/// Flange i is plate i.
void name_plates(Shape& shape, const PlateStructure& structure) {
  for (std::size_t i = 0; i < structure.plates.size() && i < shape.parts.size(); ++i)
    if (shape.parts[i]["kind"] == "flange") shape.parts[i]["plate"] = structure.plates[i].id;
}

class ConnectDocument : public Document {
 public:
  explicit ConnectDocument(std::string name) : name_(std::move(name)) {}

  std::string_view kind() const override { return "connect"; }

  Result<Shape> shape(const Asked& asked, job::Effort effort, const Progress& progress) override {
    const auto file = spec_of(asked);
    if (!file) return tl::unexpected(file.error());
    const auto report = report_of(*file, asked, effort, progress);
    if (!report) return tl::unexpected(report.error());
    Shape shape;
    shape.report = report_json(*report);
    shape.handles = handles_of(file->structure);
    add_sheet(shape, *report, effort);
    name_plates(shape, file->structure);
    return shape;
  }

  Result<MadeFile> file(const Asked& asked, const std::string& format,
                        const Progress& progress) override {
    const auto file = spec_of(asked);
    if (!file) return tl::unexpected(file.error());
    const auto report = report_of(*file, asked, job::Effort::full, progress);
    if (!report) return tl::unexpected(report.error());
    if (format == "json") return MadeFile{kJsonType, report_json(*report)};
    if (auto common = common_file(*report, asked, format)) return std::move(*common);
    if (auto whole = not_refused(*report); !whole) return tl::unexpected(whole.error());
    if (format == "step") return as_file(report->solid, kStepType);
    if (format != "stl") return tl::unexpected(no_such_format(format));
    const auto mesh = folded_mesh(with_open_seam(report->connection.sheet));
    if (!mesh) return tl::unexpected(mesh.error());
    return MadeFile{kStlType, stl_binary(*mesh, report->body)};
  }

 private:
  Result<job::PlatesFile> spec_of(const Asked& asked) const {
    if (auto given = has_spec(asked); !given) return tl::unexpected(given.error());
    return job::parse_plates(asked.spec, name_);
  }

  Result<ConnectReport> report_of(const job::PlatesFile& file, const Asked& asked,
                                  job::Effort effort, const Progress& progress) {
    const auto make = [&] {
      return job::connect_plates(file, make_request(asked, name_, effort), progress);
    };
    return effort == job::Effort::draft ? make() : last_.get(asked.key, make);
  }

  std::string name_;
  Remembered<ConnectReport> last_;
};

}  // namespace

Result<std::unique_ptr<Document>> open_connect(const std::string& name, const std::string& json) {
  if (const auto file = job::parse_plates(json, name); !file) return tl::unexpected(file.error());
  return std::make_unique<ConnectDocument>(name);
}

}  // namespace planish::studio
