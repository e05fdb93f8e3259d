#include "folded.hpp"

#include <planish/brep/step.hpp>

#include <fmt/format.h>

namespace planish::job {
namespace {

struct FoldedSolid {
  std::string step;
  Body body;
};

Result<FoldedSolid> folded_solid(const Sheet& sheet, const std::string& name,
                                 const Progress& progress) {
  auto step = folded_solid_step(sheet, name);
  if (!step) return tl::unexpected(step.error());
  Progress silent;  // its stages are not reported
  silent.cancelled = progress.cancelled;
  const auto read = read_step_text(*step, name, silent);
  if (!read) return tl::unexpected(read.error());
  return FoldedSolid{std::move(*step), read->bodies.front()};
}

Finding unmeasured(const Error& error) {
  return {
      "folded_solid",
      Severity::warning,
      fmt::format("no folded solid could be made, so neither the volume nor that it does not run "
                  "through itself is verified: {}",
                  error.message),
      {}};
}

}  // namespace

Result<std::optional<Body>> fold(Report& report, Sheet& sheet, const Sheet& to_fold,
                                 Result<std::string>& solid, const Progress& progress) {
  progress.at("folding it", 0.3);
  auto folded = folded_solid(to_fold, report.body, progress);
  if (folded) {
    solid = std::move(folded->step);
    sheet.volume = folded->body.volume();
    return std::optional(std::move(folded->body));
  }
  if (folded.error().code == ErrorCode::cancelled) return tl::unexpected(folded.error());
  leave_unfolded(report, folded.error(), solid);
  sheet.volume.reset();
  return std::optional<Body>();
}

void leave_unfolded(Report& report, const Error& why, Result<std::string>& solid) {
  report.findings.push_back(unmeasured(why));
  solid = tl::unexpected(why);
}

Error placed(Error error, const std::string& name) {
  if (error.where.empty() || error.where.front() == '/') error.where = name + error.where;
  return error;
}

std::string place_name(const std::string& input) { return input == "-" ? "standard input" : input; }

}  // namespace planish::job
