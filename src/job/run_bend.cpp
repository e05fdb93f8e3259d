#include "asked.hpp"

#include <planish/io/pages.hpp>
#include <planish/job/bend_plan_pages.hpp>

namespace planish::job {
namespace {

Result<std::string> bytes_of(const Artifact& artifact, const Made& made,
                             const std::vector<Page>& pages) {
  if (artifact.name == "json") return made.json();
  if (artifact.name == "svg") return pages_svg(pages);
  return pages_pdf(pages, made.report().body + ", bend plan");
}

}  // namespace

Outcome<RunResult> run_bend(const Asked& asked, const Progress& progress) {
  const auto made = make_asked(asked, progress);
  if (!made) return pass_on(made);
  Report& report = (*made)->report();
  std::vector<ArtifactFile> artifacts;
  // A page shows why a part cannot be bent.
  const bool drawn = !report.refusal || report.plan;
  std::vector<Page> pages;
  for (const Artifact* artifact : asked.artifacts) {
    if (!drawn && artifact->role != Role::report) continue;
    if (pages.empty() && artifact->role != Role::report)
      pages = bend_plan_pages(**made, asked.request.bending);
    auto bytes = bytes_of(*artifact, **made, pages);
    if (!bytes) return pass_on(bytes);
    artifacts.push_back({std::string(artifact->name),
                         report.body + "_plan" + std::string(artifact->suffix),
                         std::string(artifact->media_type), std::move(*bytes)});
  }
  return told(**made, std::move(artifacts));
}

}  // namespace planish::job
