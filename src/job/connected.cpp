#include "connected.hpp"

#include <planish/brep/step.hpp>

#include <fmt/format.h>

namespace planish::job {
namespace {

Finding unmeasured(const Error& error) {
  return {"folded_solid",
          Severity::warning,
          fmt::format("no folded solid could be made, so the volume is not verified: {}",
                      error.message),
          {}};
}

}  // namespace

ConnectReport begun(const ConnectRequest& request, LengthUnit unit) {
  ConnectReport report;
  report.input = request.input.string();
  report.body = request.input == "-" ? "stdin" : request.input.stem().string();
  report.units = request.units.value_or(unit);
  return report;
}

ConnectReport failed(const ConnectRequest& request, const Error& error) {
  ConnectReport report = begun(request, LengthUnit::mm);
  report.refusal = error;
  return report;
}

Result<FoldedSolid> folded_solid(const Sheet& sheet, const std::string& name,
                                 const Progress& progress) {
  auto step = folded_solid_step(sheet, name);
  if (!step) return tl::unexpected(step.error());
  Progress silent;  // its stages are none of the whole
  silent.cancelled = progress.cancelled;
  const auto read = read_step_text(*step, name, silent);
  if (!read) return tl::unexpected(read.error());
  return FoldedSolid{std::move(*step), read->bodies.front().volume()};
}

std::optional<Error> finish(ConnectReport& report, Connection connection,
                            const AllowanceRule& allowance, const PatternChecks& checks,
                            const Progress& progress) {
  report.connection = std::move(connection);
  Sheet& sheet = report.connection.sheet;
  progress.at("folding it", 0.3);
  auto solid = folded_solid(sheet, report.body, progress);
  if (solid) {
    report.solid = std::move(solid->step);
    sheet.volume = solid->volume;
  } else if (solid.error().code == ErrorCode::cancelled) {
    return solid.error();
  } else {
    report.findings.push_back(unmeasured(solid.error()));
    report.solid = tl::unexpected(solid.error());
    sheet.volume = 0.0;
  }
  report.sheet = summary_of(sheet);
  FlattenOptions options;
  options.allowance = allowance;
  if (!report.connection.structure.plates.empty()) options.root = report.connection.root;
  return lay_flat(report, {sheet, border_distance(sheet), checks}, options, progress);
}

AllowanceRule allowance_of(const PlatesFile& file, const ConnectRequest& request) {
  if (request.allowance) return *request.allowance;
  if (file.k_factor) return ConstantK{*file.k_factor, "plates file"};
  return ConstantK{};
}

Error placed(Error error, const std::string& name) {
  if (error.where.empty() || error.where.front() == '/') error.where = name + error.where;
  return error;
}

}  // namespace planish::job
