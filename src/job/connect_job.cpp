#include "connected.hpp"
#include "folded.hpp"
#include "from_file.hpp"
#include "made_report.hpp"
#include "taken_shop.hpp"

#include <planish/job/connect.hpp>

namespace planish::job {
using namespace shop;
using namespace schema;
namespace {

// A straight lateral boundary is straight on the neutral surface. A rule with a different K for
// each bend can only be applied once the bends are known, so boundaries then use the default.
ConnectOptions options_for(const AllowanceRule& allowance) {
  ConnectOptions options;
  if (const auto* constant = std::get_if<ConstantK>(&allowance)) options.k_factor = constant->k;
  return options;
}

// The work of `connect` fills the first part of the progress bar.
Progress first_part(const Progress& whole) {
  constexpr double kShare = 0.25;
  Progress part;
  part.cancelled = whole.cancelled;
  part.report = [&whole](std::string_view stage, double share) { whole.at(stage, kShare * share); };
  return part;
}

/// What a shop bends the plates to holds as if it were given.
JoinOptions joining_of(const PlatesFile& file, const Request& request) {
  JoinOptions join = request.join;
  if (join.inside_radius || !request.shop) return join;
  if (const Gauge* gauge = gauge_of(*request.shop, file.structure.thickness))
    join.inside_radius = gauge->inside_radius;
  return join;
}

std::optional<Error> fill(ConnectReport& report, const PlatesFile& file, const Request& request,
                          const Progress& progress) {
  const auto mine = request_of_part(request, report);
  if (!mine) return mine.error();
  const AllowanceRule allowance = allowance_of(file, *mine);
  progress.at("joining the plates", 0.0);
  auto connection = planish::connect(with_options(file, joining_of(file, *mine)),
                                     options_for(allowance), first_part(progress));
  if (!connection) return placed(connection.error(), place_name(request.input.string()));
  return finish(report, std::move(*connection), allowance, *mine, progress);
}

}  // namespace

Outcome<ConnectReport> connect_plates(const PlatesFile& file, const Request& request,
                                      const Progress& progress) {
  return reported(begun<ConnectReport>(request, file.units),
                  [&](ConnectReport& report) { return fill(report, file, request, progress); });
}

Outcome<ConnectReport> connect(const Request& request, const Progress& progress) {
  const auto parse = [](const InputFile& input) { return parse_plates(input.content, input.name); };
  return from_file(request, "plates file", parse, connect_plates, progress);
}

}  // namespace planish::job
