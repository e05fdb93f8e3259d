#include "asked.hpp"
#include "refusals.hpp"

#include <planish/base/packed_error.hpp>
#include <planish/job/options.hpp>
#include <planish/job/run.hpp>
#include <planish/process/worker.hpp>
#include <planish/schema/fail_at.hpp>

#include <mutex>
#include <shared_mutex>

// A request from JSON to report and artifacts, in this process or in a copy of it. The copy would
// find every lock that another thread holds taken for ever, so it is made only while nobody works
// here (decisions/0009-work-runs-in-a-process-of-its-own.md). A refusal is an error that has
// something to show.

namespace planish::job {
using namespace process;
namespace {

/// Held by those who work in this process, alone by who copies it.
std::shared_mutex& working_here() {
  static auto* const one = new std::shared_mutex();
  return *one;
}

}  // namespace

Outcome<RunResult> run_maker(const Asked& asked, const Progress& progress) {
  const auto made = make_asked(asked, progress);
  if (!made) return pass_on(made);
  std::vector<ArtifactFile> artifacts;
  Report& report = (*made)->report();
  const std::string stem = report.body;
  for (const Artifact* artifact : asked.artifacts) {
    if (report.refusal && artifact->role != Role::report) continue;
    auto files = write(*artifact, **made, asked.request, stem);
    if (!files && asked.artifacts.size() > 1 && artifact->may_be_missing(files.error())) {
      note_missing(report, *artifact, files.error());
      continue;
    }
    if (!files) return pass_on(files);
    for (WrittenArtifact& file : *files)
      artifacts.push_back({std::string(artifact->name), std::move(file.name),
                           std::string(artifact->media_type), std::move(file.bytes)});
  }
  return told(**made, std::move(artifacts));
}

namespace {

/// An error of options is at its pointer in the request.
tl::unexpected<Error> fail_in_request(Error error) {
  return tl::unexpected(at_pointer(std::move(error), "/options"));
}

Outcome<RunResult> done(const Asked& asked, const Progress& progress) {
  auto result = asked.task->run(asked, progress);
  if (result || result.error().shown) return result;
  return fail_in_request(std::move(result.error()));
}

constexpr std::size_t kOfResult = 5, kOfFile = 4;

Texts texts_of(const Outcome<RunResult>& done) {
  const Texts refusal = done ? Texts() : packed(done.error());
  if (!done && !done.error().shown) return refusal;
  const RunResult& result = done ? *done : *done.error().shown;
  Texts texts{"result", std::to_string(static_cast<int>(result.status)), result.report,
              result.summary, std::to_string(refusal.size())};
  texts.insert(texts.end(), refusal.begin(), refusal.end());
  for (const ArtifactFile& file : result.artifacts)
    texts.insert(texts.end(), {file.artifact, file.name, file.media_type, file.bytes});
  return texts;
}

std::optional<Outcome<RunResult>> result_in(const Texts& texts) {
  if (auto error = unpacked(texts)) return tl::unexpected(std::move(*error));
  if (texts.size() < kOfResult || texts[0] != "result") return std::nullopt;
  const auto of_refusal = parse_number(texts[4]);
  if (!of_refusal || *of_refusal < 0 || *of_refusal > static_cast<double>(texts.size() - kOfResult))
    return std::nullopt;
  const std::size_t head = kOfResult + static_cast<std::size_t>(*of_refusal);
  if ((texts.size() - head) % kOfFile != 0) return std::nullopt;
  RunResult result;
  for (const Status status : {Status::ok, Status::warning, Status::refused})
    if (texts[1] == std::to_string(static_cast<int>(status))) result.status = status;
  result.report = texts[2];
  result.summary = texts[3];
  for (std::size_t i = head; i < texts.size(); i += kOfFile)
    result.artifacts.push_back({texts[i], texts[i + 1], texts[i + 2], texts[i + 3]});
  auto refusal = unpacked(std::span(texts).subspan(kOfResult, head - kOfResult));
  if (!refusal) return result;
  return tl::unexpected(Refused<RunResult>(std::move(*refusal), std::move(result)));
}

}  // namespace

Outcome<RunResult> run(const std::string& request, const Progress& progress,
                       const Catalogue& catalogue) {
  const std::shared_lock here(working_here());
  const auto asked = read_asked(request, catalogue);
  if (!asked) return pass_on(asked);
  return done(*asked, progress);
}

Outcome<MadeRequest> make(const std::string& request, const Progress& progress,
                          std::optional<std::string> bytes, const Catalogue& catalogue) {
  const std::shared_lock here(working_here());
  auto asked = read_asked(request, catalogue, std::move(bytes));
  if (!asked) return pass_on(asked);
  if (!asked->maker)
    return schema::fail_at(refuse::makes_nothing, "/maker", {{"task", asked->task->name}});
  auto made = make_asked(*asked, progress);
  if (!made) return fail_in_request(std::move(made.error()));
  return MadeRequest{asked->maker, std::move(asked->request), std::move(*made)};
}

Outcome<RunResult> run_apart(const std::string& request, const Progress& progress,
                             const Limits& limits, const Catalogue& catalogue) {
  std::unique_lock alone(working_here());
  const auto answering = [&](const Texts&, const Parent& parent) {
    alone.unlock();  // the copy's own
    const auto asked = read_asked(request, catalogue);
    if (!asked) return packed(asked.error());
    parent.note({asked->request.input.string()});
    return texts_of(done(*asked, parent.progress));
  };
  Worker<AsAgreed, Outcome<RunResult>> worker(
      [&] { return ChildProcess::copy(answering, limits.memory); }, result_in);
  const auto begun = worker.begin();
  alone.unlock();
  if (!begun) return pass_on(begun);
  std::string input = "the request";
  const auto name = [&](const Texts& note) { input = note.empty() ? input : note.front(); };
  auto result = worker.work_on({}, {.time = limits.time, .parent = {progress, name}});
  if (!result) return fail(error_of(result.error(), input, limits));
  return std::move(*result);
}

}  // namespace planish::job
