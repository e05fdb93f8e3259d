#include "input.hpp"
#include "lay_flat.hpp"
#include "refusals.hpp"

#include <planish/base/progress_part.hpp>
#include <planish/brep/step.hpp>
#include <planish/geometry/curve.hpp>
#include <planish/job/info.hpp>
#include <planish/schema/printable.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::job {
namespace {

double area_of(const Face& face) {
  double area = 0.0;
  for (const BorderLoop& loop : face.loops) {
    for (const Border& border : loop)
      area += green_area(border.curve);
  }
  return area;
}

// Plane faces have (u, v) in mm, so their area is their loops' area.
std::vector<FlangeFaceInfo> flange_faces(const Sheet& sheet) {
  std::vector<FlangeFaceInfo> faces;
  for (const Face& face : sheet.faces) {
    if (face.source_face && std::holds_alternative<Frame>(face.surface)) {
      faces.push_back({*face.source_face, area_of(face)});
    }
  }
  std::ranges::stable_sort(faces, [](const auto& a, const auto& b) { return a.area > b.area; });
  return faces;
}

Result<SheetInfo> sheet_info(const Body& body) {
  const auto found = found_sheet(body);
  if (!found) return pass_on(found);
  SheetInfo info;
  info.thickness = found->sheet.thickness;
  info.flanges = static_cast<int>(found->sheet.flanges.size());
  info.bends = static_cast<int>(found->sheet.bends.size());
  info.faces = flange_faces(found->sheet);
  return info;
}

BodyInfo body_info(const Body& body, int number) {
  BodyInfo info;
  info.number = number;
  info.name = body.name();
  info.quantity = body.quantity();
  info.faces = body.face_count();
  info.size = body.size();
  info.volume = body.volume();
  info.material = body.material();
  info.colour = body.colour();
  info.density = body.density();
  return info;
}

}  // namespace

Result<InfoReport> info(const InfoRequest& request, const Progress& progress) {
  progress.at("reading", 0.0);
  constexpr double kRead = 0.7;
  const auto file = read_input(request.input, part_of(progress, 0.0, kRead));
  if (!file) return pass_on(file);
  return info_of(*file, request, part_of(progress, kRead, 1.0));
}

Result<InfoReport> info_of(const StepFile& file, const InfoRequest& request,
                           const Progress& progress) {
  int first = 0, last = static_cast<int>(file.bodies.size());
  if (!request.body.empty()) {
    const auto chosen = choose_body(file, request.body);
    if (!chosen) return pass_on(chosen);
    first = *chosen;
    last = first + 1;
  }
  InfoReport report;
  report.input = request.input.string();
  report.schema = file.schema;
  report.cad_system = file.cad_system;
  report.file_unit = file.unit;
  report.surface_bodies = file.surface_bodies;
  report.units = request.units;
  for (int i = first; i < last; ++i) {
    if (progress.should_stop()) return fail(refuse::cancelled);
    const Body& body = file.bodies[i];
    progress.at(fmt::format("body {} ({})", i + 1, schema::printable_name(body.name())),
                double(i - first) / (last - first));
    report.bodies.push_back(body_info(body, i + 1));
    if (request.recognize) report.bodies.back().sheet = sheet_info(body);
  }
  return report;
}

}  // namespace planish::job
