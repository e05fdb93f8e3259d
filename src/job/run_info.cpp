#include "asked.hpp"

#include <planish/base/progress_part.hpp>
#include <planish/brep/step.hpp>
#include <planish/job/info.hpp>

#include <algorithm>

namespace planish::job {
namespace {

constexpr double kInfoRead = 0.7;  // share of the time

Result<InfoReport> info_of_content(const InputFile& file, const InfoRequest& request,
                                   const Progress& progress) {
  const auto read = read_step_text(file.content, file.name, part_of(progress, 0.0, kInfoRead));
  if (!read) return pass_on(read);
  return info_of(*read, request, part_of(progress, kInfoRead, 1.0));
}

}  // namespace

Outcome<RunResult> run_info(const Asked& asked, const Progress& progress) {
  const InfoRequest request{asked.request.input, asked.request.body,
                            std::ranges::count(asked.flags, "sheets") > 0,
                            asked.request.units.value_or(LengthUnit::mm)};
  const auto report = asked.content ? info_of_content(*asked.content, request, progress)
                                    : info(request, progress);
  if (!report) return pass_on(report);
  return RunResult{Status::ok, info_json(*report), info_text(*report), {}};
}

}  // namespace planish::job
