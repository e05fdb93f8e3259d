#include "apart.hpp"
#include "commands.hpp"
#include "output_files.hpp"
#include "plan.hpp"
#include "refusals.hpp"

#include <planish/job/codes.hpp>
#include <planish/job/outputs.hpp>
#include <planish/job/unfold.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

namespace planish::cli {
namespace {

using job::Made;
using job::UnfoldReport;
using Bodies = std::vector<job::Outcome<UnfoldReport>>;

/// What is known of a request before it is understood.
job::Request begun(const Arguments& arguments) {
  job::Request request;
  request.input = arguments.input;
  request.body = arguments.options.text("body");
  const std::string units = arguments.options.text("units");
  if (!units.empty())
    request.units = units == "inch" ? LengthUnit::inch
                    : units == "m"  ? LengthUnit::m
                                    : LengthUnit::mm;
  return request;
}

/// The end of a request that failed as a whole: the error, also as a report, so that scripts find
/// the reason in one place.
Outcome failed_outcome(const Arguments& arguments, const job::Request& request,
                       const Error& failure) {
  Error error = failure;
  if (error.code == code::no_such_body && request.body.empty())
    say_after(error, error_of(refuse::or_all_bodies, {}));
  return {.json = arguments.maker->failed(request, error)->json(), .error = error};
}

/// A contradictory command line gives no report; a file that cannot be read or written does.
Outcome unplanned(const Arguments& arguments, const Error& error) {
  if (error.code.status != ExitStatus::unreadable) return {.error = error};
  return failed_outcome(arguments, begun(arguments), error);
}

/// The report, as one of the files where it goes into a file and there are others; and what was
/// done, unless quiet: on standard error if the report goes to standard output.
void add_report(Outcome& outcome, const Arguments& arguments, std::string json,
                std::string summary) {
  if (outcome.files.empty() || arguments.json == "-")
    outcome.json = std::move(json);
  else
    for (std::filesystem::path& file : files_named({arguments.json}))
      outcome.files.push_back({std::move(file), json});
  if (!arguments.quiet)
    (arguments.json == "-" ? outcome.aside : outcome.output) = std::move(summary);
}

/// All files, those of all pieces together first, then piece by piece; or the first reason why one
/// cannot be written. A solid or mould that cannot be made is a finding if there are other files.
Result<std::vector<OutputFile>> files_of(Made& made, const Plan& plan) {
  std::vector<OutputFile> files;
  std::optional<Error> missing;
  const int pieces = made.pieces();
  for (int piece = pieces > 1 ? -1 : 0; piece < pieces; ++piece)
    for (const Target& target : plan.targets) {
      if (pieces > 1 && target.artifact->by_piece() != (piece >= 0)) continue;
      auto bytes = target.artifact->write(made, std::max(piece, 0), plan.request);
      if (!bytes && !target.artifact->may_be_missing(bytes.error())) return pass_on(bytes);
      if (!bytes) {
        job::note_missing(made.report(), *target.artifact, bytes.error());
        missing = bytes.error();
        continue;
      }
      const bool own = target.artifact->by_piece();
      files.push_back(
          {own ? job::name_of_piece(target.path, piece, pieces) : target.path, std::move(*bytes)});
    }
  if (missing && files.empty()) return tl::unexpected(*missing);
  return files;
}

/// What makes sheets of an input, whether of one part or of all.
class MakerCommand : public Command {
 public:
  MakerCommand(const job::Catalogue& catalogue, const Arguments& arguments)
      : catalogue_(catalogue), arguments_(arguments) {}

  Outcome failed(const Error& error) const override {
    return failed_outcome(arguments_, begun(arguments_), error);
  }

 protected:
  const job::Catalogue& catalogue_;
  const Arguments& arguments_;
};

/// One part, and its files.
class OnePart : public MakerCommand {
 public:
  using MakerCommand::MakerCommand;

  Outcome make(const process::Parent& parent) override {
    const auto plan = planned(catalogue_, arguments_);
    if (!plan) return unplanned(arguments_, plan.error());
    auto work = job::open_input(*arguments_.maker, plan->request, parent.progress);
    if (!work) return failed_outcome(arguments_, plan->request, work.error());
    work_ = std::move(*work);
    auto made = job::shown(work_->make(plan->request, parent.progress));
    if (!made) return failed_outcome(arguments_, plan->request, made.error());
    made_ = std::move(*made);
    return outcome_of(*made_, *plan);
  }

 private:
  Outcome outcome_of(Made& made, const Plan& plan) const {
    job::Report& report = made.report();
    Outcome outcome;
    if (!report.refusal) {
      auto files = files_of(made, plan);
      if (files)
        outcome = {.files = std::move(*files), .inputs = plan.inputs};
      else
        report.refusal = files.error();
    }
    if (report.refusal) return {.json = made.json(), .error = report.refusal};
    append_names(report.files, outcome.files);
    add_report(outcome, arguments_, made.json(), made.text());
    return outcome;
  }

  // Kept: the process ends with its answer, and freeing them would only delay that.
  std::unique_ptr<job::Work> work_;
  std::unique_ptr<Made> made_;
};

/// Every body of a file. One that crashes the process is left out of the next.
class AllParts : public MakerCommand {
 public:
  using MakerCommand::MakerCommand;

  Outcome make(const process::Parent& parent) override {
    const auto plan = planned(catalogue_, arguments_);
    if (!plan) return unplanned(arguments_, plan.error());
    const auto begins = [&](int body) { parent.note({std::to_string(body)}); };
    auto bodies = job::unfold_all(plan->request, parent.progress, {given_up_, begins});
    if (!bodies) return failed_outcome(arguments_, plan->request, bodies.error());
    Outcome outcome;
    if (!arguments_.check)
      outcome = {.files = files_of_bodies(*bodies, *plan, begins), .inputs = plan->inputs};
    parent.note({});
    add_report(outcome, arguments_, job::summary_json(*bodies), job::summary_text(*bodies));
    outcome.error = reason_of(*bodies);
    return outcome;
  }

  void hear(const process::Texts& note) override {
    body_ = note.empty() ? std::nullopt : std::optional(std::atoi(note.front().c_str()));
  }

  bool leaves_out(const Error& crash) override {
    return body_ && given_up_.emplace(*std::exchange(body_, std::nullopt), crash).second;
  }

 private:
  /// The patterns of all bodies that have one, and the summary.
  static std::vector<OutputFile> files_of_bodies(Bodies& bodies, const Plan& plan,
                                                 const std::function<void(int)>& begins) {
    const std::vector<std::string> stems = job::stems(bodies);
    std::vector<OutputFile> all;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!bodies[i]) continue;
      begins(static_cast<int>(i));
      Plan own = plan;
      for (const job::Artifact* format : plan.formats)
        own.targets.push_back({plan.folder / (stems[i] + std::string(format->file_end)), format});
      auto files = files_of(*job::made_of(*bodies[i]), own);
      // A body whose pattern cannot be written must not stop the others.
      if (!files) {
        UnfoldReport refused = std::move(*bodies[i]);
        refused.refusal = files.error();
        bodies[i] = std::move(refused);
        continue;
      }
      append_names(bodies[i]->files, *files);
      std::move(files->begin(), files->end(), std::back_inserter(all));
    }
    all.push_back({plan.folder / "summary.csv", job::summary_csv(bodies)});
    all.push_back({plan.folder / "summary.json", job::summary_json(bodies)});
    return all;
  }

  /// Why none of them has a pattern: the first reason; the table shows them all.
  static std::optional<Error> reason_of(const Bodies& bodies) {
    if (std::ranges::any_of(bodies, [](const auto& body) { return body.has_value(); }))
      return std::nullopt;
    Error none = bodies.front().error();
    if (bodies.size() > 1)
      say_before(none, tell("None of the {count} bodies has a flat pattern. The first: ",
                            {{"count", bodies.size()}})
                           .sentence);
    return none;
  }

  std::map<int, Error> given_up_;
  std::optional<int> body_;  ///< that is being tried, from 0
};

}  // namespace

int run_maker(const job::Catalogue& catalogue, const Arguments& arguments) {
  const Running running{arguments.input, arguments.json, arguments.quiet, arguments.limits};
  if (arguments.all) {
    AllParts parts(catalogue, arguments);
    return run_apart(parts, running);
  }
  OnePart part(catalogue, arguments);
  return run_apart(part, running);
}

}  // namespace planish::cli
