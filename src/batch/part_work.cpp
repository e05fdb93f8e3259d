#include "part_work.hpp"

#include <planish/batch/parts.hpp>
#include <planish/drawing/part_view.hpp>
#include <planish/io/flat_json.hpp>
#include <planish/job/output_paths.hpp>
#include <planish/job/outputs.hpp>
#include <planish/job/run.hpp>
#include <planish/job/unfold.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

// An input as a worker makes it: the maker that reads it gets those options that it has, and its
// results become files, a report and the shapes by which identical parts are found. Nothing that
// goes wrong ends the work: a file that cannot be read, a body without a pattern and an artifact
// that cannot be made are parts with a reason. Each body is announced before it begins, so that the
// parent knows which one a crash belongs to.

namespace planish::batch {
namespace {

using Json = nlohmann::ordered_json;

constexpr auto kSketch = "sketch.svg";

std::string on_one_line(const std::string& json) { return Json::parse(json).dump(); }

/// The options that a maker has.
std::string taken_by(const job::Maker& maker, const std::string& options) {
  const Json given = Json::parse(options);
  Json taken = Json::object();
  for (const auto& [name, value] : given.items())
    if (maker.takes(name)) taken[name] = value;
  return taken.dump();
}

/// A drawing of the pattern for a page of many.
std::string sketch_of(const job::Made& made) {
  return svg_text(made.piece(0).flat, {.labels = false, .names = false, .legend = false});
}

/// The folded pieces, for those who draw them.
void add_views(std::vector<PartFile>& files, const job::Made& made) {
  for (int piece = 0; piece < made.pieces(); ++piece) {
    const job::Report& report = made.piece(piece);
    if (report.sheet.faces.empty()) continue;
    files.push_back({view_name(static_cast<std::size_t>(piece)),
                     drawing::view_json(drawing::isometric_view(report.sheet, report.layout))});
  }
}

/// Makes the files and the report of what was made.
PartDone finished(job::Made& made, const job::Maker& maker, const FileTask& task,
                  const job::Request& request, const job::Catalogue& catalogue,
                  const std::string& folder, const std::string& stem) {
  std::vector<PartFile> done;
  std::vector<std::string> shapes;
  job::Report& report = made.report();
  report.input = task.name;
  for (const std::string& format : task.formats) {
    const job::Artifact* artifact = catalogue.artifact(maker, format);
    if (!artifact || artifact->role == job::Role::report || report.refusal) continue;
    auto files = job::write(*artifact, made, request, stem);
    if (!files && artifact->may_be_missing(files.error())) {
      job::note_missing(report, *artifact, files.error());
      continue;
    }
    if (!files) {
      report.refusal = files.error();
      break;
    }
    for (job::WrittenArtifact& file : *files)
      done.push_back({std::move(file.name), std::move(file.bytes)});
  }
  if (report.refusal) {
    done.clear();
  } else {
    for (const PartFile& file : done)
      report.files.push_back(folder + "/" + file.name);
    for (int piece = 0; piece < made.pieces(); ++piece)
      shapes.push_back(flat_json(made.piece(piece).flat));
    done.push_back({kSketch, sketch_of(made)});
    if (std::ranges::count(task.formats, kViews)) add_views(done, made);
  }
  const std::string json = made.json();
  if (std::ranges::count(task.formats, "json")) done.push_back({"report.json", json});
  return part_done(folder, on_one_line(json), std::move(shapes), std::move(done));
}

/// What the files of the only part of an input are called: bodies of such files have any names.
std::string stem_of(const FileTask& task) { return job::safe_name(job::stem_of_input(task.name)); }

void unfold(const FileTask& task, const job::Maker& maker, const job::Request& request,
            const job::Catalogue& catalogue, const Listener& listener) {
  auto bodies = job::unfold_all(
      request, listener.progress,
      {task.given_up, listener.begins, [&](int body) { return task.share.holds(body); }});
  if (!bodies) return listener.done(failed_part(task, catalogue, bodies.error()));
  for (auto& body : *bodies) {
    const auto report = job::shown(std::move(body));
    listener.begins(report->number - 1);
    const bool alone = report->bodies_in_file == 1;
    const std::string stem = alone ? stem_of(task) : job::safe_name(report->body);
    const std::string folder = alone ? task.name
                                     : fmt::format("{}/{}_{}", task.name, report->number, stem);
    const auto made = job::made_of(*report);
    PartDone part = finished(*made, maker, task, request, catalogue, folder, stem);
    part.body = report->number - 1;
    listener.done(std::move(part));
  }
}

}  // namespace

PartDone part_done(std::string folder, std::string report, std::vector<std::string> shapes,
                   std::vector<PartFile> files, int body) {
  auto names = mapped(files, &PartFile::name);
  return {part_record(std::move(folder), std::move(report), std::move(shapes), std::move(names)),
          std::move(files), body};
}

std::string view_name(std::size_t piece) { return fmt::format("view-{}.json", piece + 1); }

PartDone failed_part(const FileTask& task, const job::Catalogue& catalogue, const Error& error) {
  job::Request request;
  request.input = task.name;
  const job::Maker* maker = &catalogue.makers.front();
  if (const auto input = job::read_input_file(task.file, "input file"))
    if (const auto found = catalogue.maker_for(input->name, input->content)) maker = *found;
  const auto made = maker->failed(request, error);
  made->report().input = task.name;
  const std::string json = made->json();
  std::vector<PartFile> files;
  if (std::ranges::count(task.formats, "json")) files.push_back({"report.json", json});
  return part_done(task.name, on_one_line(json), {}, std::move(files));
}

void work_on(const FileTask& task, const job::Catalogue& catalogue, const Listener& listener) {
  const auto failed = [&](const Error& error) {
    listener.done(failed_part(task, catalogue, error));
  };
  auto input = job::read_input_file(task.file, "input file");
  if (!input) return failed(input.error());
  const auto maker = catalogue.maker_for(input->name, input->content);
  if (!maker) return failed(maker.error());
  const auto options = job::read_options(taken_by(**maker, task.options), **maker,
                                         job::OptionFiles::path_or_content, "");
  if (!options) return failed(options.error());
  job::Request request;
  request.input = task.file;
  if (const auto entered = options->enter(request); !entered) return failed(entered.error());
  if ((*maker)->takes("body") && request.body.empty())
    return unfold(task, **maker, request, catalogue, listener);
  if (!task.share.holds(0)) return;
  const auto work = (*maker)->open(*input, listener.progress);
  if (!work) return failed(work.error());
  const auto made = job::shown((*work)->make(request, listener.progress));
  if (!made) return failed(made.error());
  listener.done(finished(**made, **maker, task, request, catalogue, task.name, stem_of(task)));
}

}  // namespace planish::batch
