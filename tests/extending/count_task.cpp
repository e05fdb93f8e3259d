#include "count_task.hpp"

#include "asked.hpp"

#include <fmt/format.h>

namespace planish::job {
namespace {

Maker with_body_alone(const Maker* reader) {
  Maker taking = *reader;
  taking.options = {{"body"}};
  return taking;
}

Outcome<RunResult> count(const Asked& asked, const Progress& progress) {
  const auto made = make_asked(asked, progress);
  if (!made) return pass_on(made);
  if ((*made)->report().refusal) return told(**made, {});
  const FlatPattern& flat = (*made)->report().flat;
  RunResult done;
  done.report = fmt::format("{}\n", asked.flags.empty() ? flat.bends.size() : flat.openings.size());
  return done;
}

}  // namespace

Task count_task() {
  return {.name = "count",
          .description = "count its bends",
          .details = "Count the bends of a part.",
          .reader = Reader::by_format,
          .taking = with_body_alone,
          .artifacts = std::vector<std::string_view>(),
          .flags = {{"openings", "of count: its openings instead"}},
          .run = count};
}

}  // namespace planish::job
