#include "apart.hpp"
#include "commands.hpp"
#include "plan.hpp"

#include <planish/job/outputs.hpp>
#include <planish/job/unfold.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <utility>

namespace planish::cli {
namespace {

using job::Made;
using job::UnfoldReport;

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
Ending end_failed(const Arguments& arguments, const job::Request& request, const Error& failure) {
  Error error = failure;
  if (error.code == ErrorCode::no_such_body && request.body.empty())
    error.message += "; or take all of them with --all -o FOLDER/";
  return {arguments.maker->failed(request, error)->json(), {}, {}, error};
}

/// A contradictory command line gives no report; a side file that cannot be read does.
Ending end_unplanned(const Arguments& arguments, const Error& error) {
  if (error.code != ErrorCode::cannot_read && error.code != ErrorCode::invalid_input)
    return {{}, {}, {}, error};
  return end_failed(arguments, begun(arguments), error);
}

/// Prints what was done, unless quiet; on standard error if the JSON report goes to standard
/// output.
Ending end_done(const Arguments& arguments, std::string json, std::string summary) {
  Ending ending{std::move(json), {}, {}, std::nullopt};
  if (!arguments.quiet) (arguments.json == "-" ? ending.aside : ending.output) = std::move(summary);
  return ending;
}

Ending end_reported(const Arguments& arguments, const Made& made) {
  if (made.report().refusal) return {made.json(), {}, {}, made.report().refusal};
  return end_done(arguments, made.json(), made.text());
}

Ending end_all(const Arguments& arguments, const std::vector<UnfoldReport>& reports) {
  Ending ending = end_done(arguments, job::summary_json(reports), job::summary_text(reports));
  if (std::any_of(reports.begin(), reports.end(), [](const auto& r) { return r.has_pattern(); }))
    return ending;
  // The first reason is returned; the table shows them all.
  Error none = *reports.front().refusal;
  if (reports.size() > 1)
    none.message = fmt::format("none of the {} bodies has a flat pattern, the first because: {}",
                               reports.size(), none.message);
  ending.error = none;
  return ending;
}

// net.dxf; for several pieces net-1.dxf, net-2.dxf, …
std::filesystem::path name_of_piece(const std::filesystem::path& path, int piece, int pieces) {
  if (pieces == 1) return path;
  return path.parent_path() /
         fmt::format("{}-{}{}", path.stem().string(), piece + 1, path.extension().string());
}

/// All files, those of all pieces together first, then piece by piece; or the first reason why one
/// cannot be written.
Result<std::vector<File>> files_of(const Made& made, const Plan& plan) {
  std::vector<File> files;
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

/// One part, and its files.
class OnePart : public Command {
 public:
  OnePart(const job::Catalogue& catalogue, const Arguments& arguments)
      : catalogue_(catalogue), arguments_(arguments) {}

  std::variant<Products, Ending> make(const job::Parent& parent) override {
    const auto plan = planned(catalogue_, arguments_);
    if (!plan) return end_unplanned(arguments_, plan.error());
    auto made = made_of(plan->request, parent.progress);
    if (!made) return end_failed(arguments_, plan->request, made.error());
    made_ = std::move(*made);
    if (!made_->report().has_pattern()) return end_reported(arguments_, *made_);
    auto files = files_of(*made_, *plan);
    if (!files) return conclude(files.error());
    append_names(names_, *files);
    return Products{std::move(*files), plan->inputs};
  }

  Ending conclude(const std::optional<Error>& unwritten) override {
    made_->report().refusal = unwritten;
    if (!unwritten) made_->report().files = names_;
    return end_reported(arguments_, *made_);
  }

  Ending lost(const Error& error) const override {
    return end_failed(arguments_, begun(arguments_), error);
  }

 private:
  Result<std::unique_ptr<Made>> made_of(const job::Request& request,
                                        const Progress& progress) const {
    const auto work = job::open_input(*arguments_.maker, request, progress);
    if (!work) return tl::unexpected(work.error());
    return (*work)->make(request, progress);
  }

  const job::Catalogue& catalogue_;
  const Arguments& arguments_;
  std::unique_ptr<Made> made_;
  std::vector<std::string> names_;
};

/// Every body of a file. One that crashes the process is left out of the next.
class AllParts : public Command {
 public:
  AllParts(const job::Catalogue& catalogue, const Arguments& arguments)
      : catalogue_(catalogue), arguments_(arguments) {}

  std::variant<Products, Ending> make(const job::Parent& parent) override {
    auto plan = planned(catalogue_, arguments_);
    if (!plan) return end_unplanned(arguments_, plan.error());
    request_ = plan->request;
    all_.begins = [&](int body) { parent.note({std::to_string(body)}); };
    auto reports = job::unfold_all(request_, parent.progress, all_);
    if (!reports) return end_failed(arguments_, request_, reports.error());
    reports_ = std::move(*reports);
    if (arguments_.check) return end_all(arguments_, reports_);
    Products products{files_of_bodies(*plan), plan->inputs};
    parent.note({});
    products.files.push_back({plan->folder / "summary.csv", job::summary_csv(reports_)});
    products.files.push_back({plan->folder / "summary.json", job::summary_json(reports_)});
    return products;
  }

  Ending conclude(const std::optional<Error>& unwritten) override {
    if (unwritten) return end_failed(arguments_, request_, *unwritten);
    return end_all(arguments_, reports_);
  }

  Ending lost(const Error& error) const override {
    return end_failed(arguments_, begun(arguments_), error);
  }

  void hear(const job::Texts& note) override {
    body_ = note.empty() ? std::nullopt : std::optional(std::atoi(note.front().c_str()));
  }

  bool leaves_out(const Error& crash) override {
    return body_ && all_.given_up.emplace(*std::exchange(body_, std::nullopt), crash).second;
  }

 private:
  /// The files of all bodies that have a pattern.
  std::vector<File> files_of_bodies(const Plan& plan) {
    const std::vector<std::string> stems = job::stems(reports_);
    std::vector<File> all;
    for (std::size_t i = 0; i < reports_.size(); ++i) {
      if (!reports_[i].has_pattern()) continue;
      all_.begins(static_cast<int>(i));
      Plan own = plan;
      for (const job::Artifact* format : plan.formats)
        own.targets.push_back({plan.folder / (stems[i] + std::string(format->file_end)), format});
      auto files = files_of(*job::made_of(reports_[i]), own);
      // A body whose pattern cannot be written must not stop the others.
      if (!files) {
        reports_[i].refusal = files.error();
        continue;
      }
      append_names(reports_[i].files, *files);
      std::move(files->begin(), files->end(), std::back_inserter(all));
    }
    return all;
  }

  const job::Catalogue& catalogue_;
  const Arguments& arguments_;
  job::AllBodies all_;
  job::Request request_;
  std::vector<UnfoldReport> reports_;
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
