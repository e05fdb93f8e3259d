#include "lay_flat.hpp"
#include "sides.hpp"

#include <planish/brep/step.hpp>
#include <planish/job/unfold.hpp>

namespace planish::job {
namespace {

std::optional<Error> fill(UnfoldReport& report, const Body& body, const UnfoldRequest& request,
                          const Progress& progress) {
  progress.at("finding the sheet", 0.2);
  auto found = recognize(body);
  if (!found) return found.error();
  report.sheet = summary_of(found->sheet);
  report.notes = std::move(found->notes);
  const auto options = flatten_options(found->sheet, request);
  if (!options) return options.error();
  return lay_flat(report, {found->sheet, found->distance, request}, *options, progress);
}

}  // namespace

Result<UnfoldReport> unfold_body(const Body& body, const UnfoldRequest& request,
                                 const Progress& progress) {
  UnfoldReport report;
  report.body = body.name();
  report.quantity = body.quantity();
  report.units = request.units;
  if (const auto error = reported(report, [&] { return fill(report, body, request, progress); })) {
    return tl::unexpected(*error);
  }
  return report;
}

}  // namespace planish::job
