#include "lay_flat.hpp"
#include "sides.hpp"
#include "taken_shop.hpp"

#include <planish/brep/step.hpp>
#include <planish/job/unfold.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace planish::job {
namespace {

UnfoldReport begun(const Body& body, const Request& request) {
  UnfoldReport report;
  report.body = body.name();
  report.quantity = body.quantity();
  report.material = body.material();
  report.colour = body.colour();
  report.density = body.density();
  report.units = request.units.value_or(LengthUnit::mm);
  enter_material(report, request);
  return report;
}

std::string note_of_rips(const std::vector<int>& edges) {
  return fmt::format(
      "The part is ripped along {} {}; walls folded sharply there meet by their inside edges.",
      edges.size() == 1 ? "edge" : "edges", fmt::join(edges, ", "));
}

std::optional<Error> fill(UnfoldReport& report, const Body& body, const Result<Recognized>& found,
                          const Request& request, const Progress& progress) {
  if (!found) {
    Error why = found.error();
    if (why.code == code::bad_option) why.where = "rip_edges";
    // Another rip comes after those asked for.
    for (Remedy& remedy : why.remedies)
      if (remedy.option == "rip_edges" && !request.rip_edges.empty())
        remedy.value = fmt::format("{},{}", fmt::join(request.rip_edges, ","), remedy.value);
    return why;
  }
  report.summary = summary_of(found->sheet);
  report.notes = found->notes;
  if (!request.rip_edges.empty()) report.notes.push_back(note_of_rips(request.rip_edges));
  const auto mine = request_of_part(request, report);
  if (!mine) return mine.error();
  const auto options = flatten_options(found->sheet, *mine);
  if (!options) return options.error();
  return lay_flat(
      report,
      {found->sheet, found->distance, *mine, FoldedBody{body, found->sheet}, mine->relief, true},
      *options, progress);
}

}  // namespace

Outcome<UnfoldReport> unfold_recognized(const Body& body, const Result<Recognized>& found,
                                        const Request& request, const Progress& progress) {
  return reported(begun(body, request), [&](UnfoldReport& report) {
    return fill(report, body, found, request, progress);
  });
}

Outcome<UnfoldReport> unfold_body(const Body& body, const Request& request,
                                  const Progress& progress) {
  return reported(begun(body, request), [&](UnfoldReport& report) {
    progress.at("finding the sheet", 0.2);
    return fill(report, body, found_sheet(body, sought_by(request), progress), request, progress);
  });
}

}  // namespace planish::job
