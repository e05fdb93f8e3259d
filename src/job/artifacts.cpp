#include "part_drawing.hpp"
#include "sentences.hpp"

#include <planish/brep/step.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/io/mesh_writers.hpp>
#include <planish/job/artifact.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::job {
namespace {

using Bytes = Result<std::string>;

Bytes write_dxf(const Made& made, int piece, const Request& request) {
  DxfOptions options = request.dxf;
  options.units = made.report().units;
  return dxf_text(made.piece(piece).flat, options);
}

Bytes write_svg(const Made& made, int piece, const Request&) {
  return svg_text(made.piece(piece).flat, made.svg());
}

Bytes write_flat_step(const Made& made, int piece, const Request&) {
  return flat_solid_step(made.piece(piece).flat, made.piece(piece).body);
}

Bytes write_folded_step(const Made& made, int piece, const Request&) {
  return made.folded_solid(piece);
}

Bytes mesh_as(const Result<Mesh>& mesh, const std::string& name,
              std::string (*text)(const Mesh&, const std::string&)) {
  if (!mesh) return pass_on(mesh);
  return text(*mesh, name);
}

std::string stl(const Mesh& mesh, const std::string& name) { return stl_binary(mesh, name); }
std::string obj(const Mesh& mesh, const std::string& name) { return obj_text(mesh, name); }

std::string mould_name(const Made& made) { return made.report().body + " mould"; }

Bytes write_mould_step(const Made& made, int, const Request&) {
  const auto mesh = made.mould_mesh();
  if (!mesh) return pass_on(mesh);
  return mesh_solid_step(*mesh, mould_name(made));
}

}  // namespace

const std::vector<Artifact>& artifacts() {
  static const std::vector<Artifact> table{
      {"dxf", Role::flat, Source::pattern, ".dxf", ".dxf", "image/vnd.dxf", "DXF, flat pattern",
       write_dxf},
      {"svg", Role::flat, Source::pattern, ".svg", ".svg", "image/svg+xml", "SVG, flat pattern",
       write_svg},
      {"flat.step", Role::flat, Source::pattern, ".step", "_flat.step", "model/step",
       "STEP, flat solid", write_flat_step},
      {"pdf", Role::flat, Source::pattern, ".pdf", ".pdf", "application/pdf",
       "PDF, drawing of the part",
       [](const Made& made, int piece, const Request&) { return part_drawing(made, piece); }},
      {"step", Role::folded, Source::folded_solid, ".step", ".step", "model/step", "STEP, folded",
       write_folded_step},
      {"stl", Role::folded, Source::folded_mesh, ".stl", ".stl", "model/stl", "STL, folded",
       [](const Made& made, int, const Request&) {
         return mesh_as(made.folded_mesh(), made.report().body, stl);
       }},
      {"obj", Role::folded, Source::folded_mesh, ".obj", ".obj", "model/obj", "OBJ, folded",
       [](const Made& made, int, const Request&) {
         return mesh_as(made.folded_mesh(), made.report().body, obj);
       }},
      {"mould.stl", Role::mould, Source::mould_mesh, ".stl", "_mould.stl", "model/stl",
       "STL, mould",
       [](const Made& made, int, const Request&) {
         return mesh_as(made.mould_mesh(), mould_name(made), stl);
       }},
      {"mould.obj", Role::mould, Source::mould_mesh, ".obj", "_mould.obj", "model/obj",
       "OBJ, mould",
       [](const Made& made, int, const Request&) {
         return mesh_as(made.mould_mesh(), mould_name(made), obj);
       }},
      {"mould.step", Role::mould, Source::mould_mesh, ".step", "_mould.step", "model/step",
       "STEP, mould", write_mould_step},
      {"json", Role::report, Source::report, ".json", "_report.json", "application/json",
       "JSON, report", [](const Made& made, int, const Request&) -> Bytes { return made.json(); }},
  };
  return table;
}

bool Artifact::may_be_missing(const Error& why) const {
  const bool beside = role == Role::folded || role == Role::mould;
  return beside && why.code != code::cancelled;
}

void note_missing(Report& report, const Artifact& artifact, const Error& why) {
  const bool mould = artifact.role == Role::mould;
  const std::string code = mould ? "mould" : "folded_solid";
  if (std::ranges::any_of(report.findings, [&](const Finding& one) { return one.code == code; }))
    return;
  report.findings.push_back(
      finding_of(code, say::file_missing, why, {{"what", mould ? "mould" : "folded part"}}));
}

Result<std::vector<WrittenArtifact>> write(const Artifact& artifact, const Made& made,
                                           const Request& request, const std::string& stem) {
  std::vector<WrittenArtifact> files;
  const int pieces = artifact.by_piece() ? made.pieces() : 1;
  for (int piece = 0; piece < pieces; ++piece) {
    auto bytes = artifact.write(made, piece, request);
    if (!bytes) return pass_on(bytes);
    const std::string number = pieces > 1 ? fmt::format("-{}", piece + 1) : std::string();
    files.push_back(
        {&artifact, fmt::format("{}{}{}", stem, number, artifact.file_end), std::move(*bytes)});
  }
  return files;
}

std::string_view role_name(Role role) {
  constexpr std::string_view kWords[] = {"flat", "folded", "mould", "report"};
  return kWords[static_cast<int>(role)];
}

}  // namespace planish::job
