#include "connected.hpp"

#include "bend_spans.hpp"
#include "folded.hpp"

namespace planish::job {

using namespace shop;
std::optional<Error> finish(ConnectReport& report, Connection connection,
                            const AllowanceRule& allowance, const PatternChecks& checks,
                            const Progress& progress) {
  report.connection = std::move(connection);
  Sheet& sheet = report.connection.sheet;
  Sheet opened;
  std::optional<FoldedBody> folded;
  if (checks.effort == Effort::full) {
    opened = with_open_seam(sheet);
    if (auto stopped = fold(report, sheet, opened, report.solid, progress)) return stopped;
    if (report.solid) folded.emplace(FoldedBody{*report.solid, opened});
  }
  report.summary = summary_of(sheet);
  FlattenOptions options;
  options.allowance = allowance;
  if (!report.connection.structure.plates.empty()) options.root = report.connection.root;
  const EdgeDistance distance = checks.effort == Effort::full ? border_distance(sheet)
                                                              : EdgeDistance();
  if (auto error = lay_flat(report, {sheet, distance, checks, folded}, options, progress))
    return error;
  if (checks.effort == Effort::full)
    for (Finding& finding : span_findings(report))
      report.findings.push_back(std::move(finding));
  for (Finding& finding : trim_findings(report.connection))
    report.findings.push_back(std::move(finding));
  return std::nullopt;
}

AllowanceRule allowance_of(const PlatesFile& file, const Request& request) {
  if (request.allowance) return *request.allowance;
  if (request.shop && gauge_of(*request.shop, file.structure.thickness))
    return shop_k(*request.shop, file.structure.thickness);
  if (file.k_factor) return ConstantK{*file.k_factor, "plates file"};
  return ConstantK{};
}

}  // namespace planish::job
