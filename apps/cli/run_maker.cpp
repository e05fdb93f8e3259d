#include "commands.hpp"
#include "output_files.hpp"
#include "plan.hpp"
#include "terminal.hpp"

#include <planish/job/outputs.hpp>
#include <planish/job/unfold.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::cli {
namespace {

using job::Made;
using job::UnfoldReport;

constexpr int kFileStatus = 3;  // exit status: a file cannot be read, is invalid or not written

Error stopped() { return {ErrorCode::cancelled, "cancelled", {}}; }

/// Prints what was done, unless quiet; on standard error if the JSON report goes to standard
/// output.
void print_summary(const Arguments& arguments, const std::string& text) {
  if (!arguments.quiet) fmt::print(arguments.json == "-" ? stderr : stdout, "{}", text);
}

/// Ends a request that failed as a whole: prints the error and writes it as a report, so that
/// scripts find the reason in one place; unless the report is what cannot be written.
int end_failed(const Arguments& arguments, const job::Request& request, const Error& failure) {
  Error error = failure;
  if (error.code == ErrorCode::no_such_body && request.body.empty())
    error.message += "; or take all of them with --all -o FOLDER/";
  const int status = complain(error);
  const bool of_report = error.code == ErrorCode::cannot_write && error.where == arguments.json;
  if (error.code == ErrorCode::cancelled || of_report) return status;
  const auto failed = arguments.maker->failed(request, error);
  if (const auto unwritten = write_report(arguments.json, failed->json())) complain(*unwritten);
  return status;
}

/// A contradictory command line gives no report; a file that cannot be read or written does.
int end_unplanned(const Arguments& arguments, const Error& error) {
  if (exit_status(error.code) != kFileStatus) return complain(error);
  job::Request request;
  request.input = arguments.input;
  request.body = arguments.options.text("body");
  const std::string units = arguments.options.text("units");
  if (!units.empty())
    request.units = units == "inch" ? LengthUnit::inch
                    : units == "m"  ? LengthUnit::m
                                    : LengthUnit::mm;
  return end_failed(arguments, request, error);
}

/// The report of what was written was written with it.
int end_reported(const Arguments& arguments, const Made& made) {
  if (made.report().refusal || arguments.json == "-")
    if (const auto error = write_report(arguments.json, made.json())) return complain(*error);
  if (made.report().refusal) return complain(*made.report().refusal);
  print_summary(arguments, made.text());
  return 0;
}

// net.dxf; for several pieces net-1.dxf, net-2.dxf, …
std::filesystem::path name_of_piece(const std::filesystem::path& path, int piece, int pieces) {
  if (pieces == 1) return path;
  return path.parent_path() /
         fmt::format("{}-{}{}", path.stem().string(), piece + 1, path.extension().string());
}

/// All files, those of all pieces together first, then piece by piece; or the first reason why one
/// cannot be written.
Result<std::vector<OutputFile>> files_of(const Made& made, const Plan& plan) {
  std::vector<OutputFile> files;
  const int pieces = made.pieces();
  for (int piece = pieces > 1 ? -1 : 0; piece < pieces; ++piece)
    for (const Target& target : plan.targets) {
      if (pieces > 1 && target.artifact->by_piece() != (piece >= 0)) continue;
      auto bytes = target.artifact->write(made, std::max(piece, 0), plan.request);
      if (!bytes) return tl::unexpected(bytes.error());
      const bool own = target.artifact->by_piece();
      files.push_back(
          {own ? name_of_piece(target.path, piece, pieces) : target.path, std::move(*bytes)});
    }
  return files;
}

void add_report(std::vector<OutputFile>& files, const std::string& json_option,
                const std::string& text) {
  for (const std::filesystem::path& file : files_named({json_option}))
    files.push_back({file, text});
}

/// What was made, and the report that names its files.
std::optional<Error> write_made(Made& made, const Arguments& arguments, const Plan& plan) {
  auto files = files_of(made, plan);
  if (!files) return files.error();
  if (interrupted()) return stopped();
  for (const OutputFile& file : *files)
    if (file.path.has_parent_path())
      if (auto error = make_folder(file.path.parent_path())) return error;
  append_names(made.report().files, *files);
  add_report(*files, arguments.json, made.json());
  auto error = write_all(*files, plan.inputs);
  if (error) made.report().files.clear();
  return error;
}

Result<std::unique_ptr<Made>> make(const Arguments& arguments, const Plan& plan,
                                   ProgressLine& line) {
  const Progress progress = line.progress();
  const auto work = job::open_input(*arguments.maker, plan.request, progress);
  if (!work) return tl::unexpected(work.error());
  return (*work)->make(plan.request, progress);
}

int run_one(const Arguments& arguments, const Plan& plan) {
  ProgressLine line(!arguments.quiet);
  const auto made = make(arguments, plan, line);
  if (!made) return end_failed(arguments, plan.request, made.error());
  if (interrupted()) return complain(stopped());
  if ((*made)->report().has_pattern())
    (*made)->report().refusal = write_made(**made, arguments, plan);
  if (interrupted()) return complain(stopped());
  return end_reported(arguments, **made);
}

/// Writes the patterns of all bodies that have one into the folder, and the summary.
std::optional<Error> write_bodies(std::vector<UnfoldReport>& reports, const Arguments& arguments,
                                  const Plan& plan) {
  const std::vector<std::string> stems = job::stems(reports);
  std::vector<OutputFile> all;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    if (!reports[i].has_pattern()) continue;
    Plan own = plan;
    for (const job::Artifact* format : plan.formats)
      own.targets.push_back({plan.folder / (stems[i] + std::string(format->file_end)), format});
    auto files = files_of(*job::made_of(reports[i]), own);
    // A body whose pattern cannot be written must not stop the others.
    if (!files) {
      reports[i].refusal = files.error();
      continue;
    }
    append_names(reports[i].files, *files);
    for (OutputFile& file : *files)
      all.push_back(std::move(file));
  }
  if (auto error = make_folder(plan.folder)) return error;
  all.push_back({plan.folder / "summary.csv", job::summary_csv(reports)});
  all.push_back({plan.folder / "summary.json", job::summary_json(reports)});
  add_report(all, arguments.json, job::summary_json(reports));
  return write_all(all, plan.inputs);
}

int end_all(const Arguments& arguments, const std::vector<UnfoldReport>& reports) {
  if (arguments.check || arguments.json == "-")
    if (const auto error = write_report(arguments.json, job::summary_json(reports)))
      return complain(*error);
  print_summary(arguments, job::summary_text(reports));
  if (std::any_of(reports.begin(), reports.end(), [](const auto& r) { return r.has_pattern(); }))
    return 0;
  // The first reason is returned; the table shows them all.
  Error none = *reports.front().refusal;
  if (reports.size() > 1)
    none.message = fmt::format("none of the {} bodies has a flat pattern, the first because: {}",
                               reports.size(), none.message);
  return complain(none);
}

int run_all(const Arguments& arguments, const Plan& plan) {
  ProgressLine line(!arguments.quiet);
  auto reports = job::unfold_all(plan.request, line.progress());
  if (!reports) return end_failed(arguments, plan.request, reports.error());
  if (interrupted()) return complain(stopped());
  if (!arguments.check)
    if (const auto error = write_bodies(*reports, arguments, plan))
      return end_failed(arguments, plan.request, *error);
  return end_all(arguments, *reports);
}

}  // namespace

int run_maker(const job::Catalogue& catalogue, const Arguments& arguments) {
  const auto plan = planned(catalogue, arguments);
  if (!plan) return end_unplanned(arguments, plan.error());
  return arguments.all ? run_all(arguments, *plan) : run_one(arguments, *plan);
}

}  // namespace planish::cli
