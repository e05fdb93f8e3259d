#include "asked.hpp"

#include <planish/io/pages.hpp>
#include <planish/job/bend_plan_pages.hpp>
#include <planish/job/output_paths.hpp>

#include <algorithm>
#include <iterator>

namespace planish::job {
namespace {

/// The bytes of the plan; its pages are drawn once.
class Written {
 public:
  Written(const Made& made, const Asked& asked) : made_(made), asked_(asked) {}

  /// The files of an artifact, with the ends of their names.
  Result<std::vector<ArtifactFile>> files(const Artifact& artifact) {
    if (artifact.role == Role::flat && artifact.suffix == ".dxf") return flats_as_made(artifact);
    auto bytes = bytes_of(artifact);
    if (!bytes) return pass_on(bytes);
    return std::vector{file(artifact, "_plan" + std::string(artifact.suffix), std::move(*bytes))};
  }

 private:
  Result<std::string> bytes_of(const Artifact& artifact) {
    if (artifact.role == Role::report) return made_.json();
    if (pages_.empty()) pages_ = bend_plan_pages(made_, asked_.request.bending);
    if (artifact.suffix == ".svg") return pages_svg(pages_);
    return pages_pdf(pages_, made_.report().body + ", bend plan");
  }

  Result<std::vector<ArtifactFile>> flats_as_made(const Artifact& artifact) const {
    std::vector<ArtifactFile> files;
    for (int piece = 0; piece < made_.pieces(); ++piece) {
      auto dxf = dxf_as_made(made_.piece(piece), asked_.request);
      if (!dxf) return pass_on(dxf);
      files.push_back(file(artifact, name_of_piece("_as_made.dxf", piece, made_.pieces()).string(),
                           std::move(*dxf)));
    }
    return files;
  }

  ArtifactFile file(const Artifact& artifact, const std::string& end, std::string bytes) const {
    return {std::string(artifact.name), made_.report().body + end, std::string(artifact.media_type),
            std::move(bytes)};
  }

  const Made& made_;
  const Asked& asked_;
  std::vector<Page> pages_;
};

}  // namespace

Outcome<RunResult> run_bend(const Asked& asked, const Progress& progress) {
  const auto made = make_asked(asked, progress);
  if (!made) return pass_on(made);
  const Report& report = (*made)->report();
  std::vector<ArtifactFile> artifacts;
  Written written(**made, asked);
  for (const Artifact* artifact : asked.artifacts) {
    // A page shows why a part cannot be bent.
    const bool there = artifact->role == Role::report || !report.refusal ||
                       (report.plan && artifact->suffix != ".dxf");
    if (!there) continue;
    auto files = written.files(*artifact);
    if (!files) return pass_on(files);
    std::ranges::move(*files, std::back_inserter(artifacts));
  }
  return told(**made, std::move(artifacts));
}

}  // namespace planish::job
