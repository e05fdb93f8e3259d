#include "connected.hpp"

#include "folded.hpp"

namespace planish::job {
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

std::optional<Error> finish(ConnectReport& report, Connection connection,
                            const AllowanceRule& allowance, const PatternChecks& checks,
                            const Progress& progress) {
  report.connection = std::move(connection);
  Sheet& sheet = report.connection.sheet;
  if (checks.effort == Effort::full)
    if (auto stopped = fold(report, sheet, with_open_seam(sheet), report.solid, progress))
      return stopped;
  report.sheet = summary_of(sheet);
  FlattenOptions options;
  options.allowance = allowance;
  if (!report.connection.structure.plates.empty()) options.root = report.connection.root;
  const EdgeDistance distance = checks.effort == Effort::full ? border_distance(sheet)
                                                              : EdgeDistance();
  return lay_flat(report, {sheet, distance, checks}, options, progress);
}

AllowanceRule allowance_of(const PlatesFile& file, const ConnectRequest& request) {
  if (request.allowance) return *request.allowance;
  if (file.k_factor) return ConstantK{*file.k_factor, "plates file"};
  return ConstantK{};
}

}  // namespace planish::job
