#include "input.hpp"
#include "refusals.hpp"
#include "taken_shop.hpp"

#include <planish/base/progress_part.hpp>
#include <planish/brep/step.hpp>
#include <planish/job/unfold.hpp>
#include <planish/schema/printable.hpp>

#include <fmt/format.h>

#include <chrono>
#include <exception>

namespace planish::job {
namespace {

constexpr double kUnfoldRead = 0.2;  // share of the progress taken by reading

struct TimedFile {
  StepFile file;
  double seconds = 0.0;
};

Result<TimedFile> timed_read(const Request& request, const Progress& progress) {
  progress.at("reading", 0.0);
  const auto start = std::chrono::steady_clock::now();
  auto file = read_input(request.input, part_of(progress, 0.0, kUnfoldRead));
  if (!file) return pass_on(file);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return TimedFile{std::move(*file), taken.count()};
}

// The one place that keeps a failure in one body from affecting the others.
Outcome<UnfoldReport> unfold_carefully(const Body& body, const Request& request,
                                       const Progress& progress) {
  try {
    return unfold_body(body, request, progress);
  } catch (const std::exception& defect) {
    return fail(refuse::unfolding_crashed, {{"reason", defect.what()}});
  } catch (...) {
    return fail(refuse::unfolding_crashed, {{"reason", "an exception of unknown type"}});
  }
}

// Progress of one body of several: its stages fill its share of the whole.
Progress share_of(const Progress& whole, int index, int count, const std::string& name) {
  Progress part;
  part.cancelled = whole.cancelled;
  part.report = [&whole, index, count, name](std::string_view stage, double share) {
    whole.at(fmt::format("body {} of {} ({}): {}", index + 1, count, schema::printable_name(name),
                         stage),
             (index + share) / count);
  };
  return part;
}

UnfoldReport refused(const Body& body, const Request& request, const Error& error) {
  UnfoldReport report = failed_unfold(request, error);
  report.body = body.name();
  report.quantity = body.quantity();
  report.material = body.material();
  report.colour = body.colour();
  report.density = body.density();
  enter_material(report, request);
  return report;
}

}  // namespace

UnfoldReport failed_unfold(const Request& request, const Error& error) {
  UnfoldReport report;
  report.input = request.input.string();
  report.body = request.body;
  report.units = request.units.value_or(LengthUnit::mm);
  report.refusal = error;
  return report;
}

void place_in_file(UnfoldReport& report, const StepFile& file, int body) {
  report.number = body + 1;
  report.bodies_in_file = static_cast<int>(file.bodies.size());
  report.surface_bodies = file.surface_bodies;
  if (report.bodies_in_file == 1 && report.surface_bodies > 0)
    report.notes.push_back(note_of_surfaces(report));
}

Outcome<UnfoldReport> unfold(const Request& request, const Progress& progress) {
  const auto read = timed_read(request, progress);
  if (!read) return pass_on(read);
  const auto index = choose_body(read->file, request.body);
  if (!index) return pass_on(index);
  auto report = shown(unfold_body(read->file.bodies[*index], request, progress));
  if (!report) return pass_on(report);
  report->input = request.input.string();
  place_in_file(*report, read->file, *index);
  report->read_seconds = read->seconds;
  return std::move(*report);
}

Result<std::vector<Outcome<UnfoldReport>>> unfold_all(const Request& request,
                                                      const Progress& progress,
                                                      const AllBodies& all) {
  const auto read = timed_read(request, progress);
  if (!read) return pass_on(read);
  std::vector<Outcome<UnfoldReport>> bodies;
  const int count = static_cast<int>(read->file.bodies.size());
  const Progress unfolding = part_of(progress, kUnfoldRead, 1.0);
  for (int i = 0; i < count; ++i) {
    const Body& body = read->file.bodies[i];
    if (progress.should_stop()) return fail(refuse::cancelled);
    if (all.wanted && !all.wanted(i)) continue;
    if (all.begins) all.begins(i);
    const auto given_up = all.given_up.find(i);
    auto report = shown(
        given_up != all.given_up.end()
            ? tl::unexpected(given_up->second)
            : unfold_carefully(body, request, share_of(unfolding, i, count, body.name())));
    if (!report && report.error().code == code::cancelled) return pass_on(report);
    if (!report) report = refused(body, request, report.error());
    report->input = request.input.string();
    place_in_file(*report, read->file, i);
    report->read_seconds = read->seconds;
    bodies.push_back(std::move(*report));
  }
  return bodies;
}

}  // namespace planish::job
