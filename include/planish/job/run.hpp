#pragma once

#include <planish/job/artifact.hpp>
#include <planish/process/child_process.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace planish::job {

struct ArtifactFile {
  std::string artifact, name, media_type, bytes;
};

/// The result of a request: its report as JSON text and as text for a terminal, and the artifacts
/// that it asked for.
struct RunResult {
  Status status = Status::ok;
  std::string report, summary;
  std::vector<ArtifactFile> artifacts;
};

/// A result holds its refusal as text only: whoever makes a refused one gives the error beside it.
inline std::optional<Error> refusal_of(const RunResult&) { return std::nullopt; }

/// What was made for a request, kept so that artifacts can be written of it.
struct MadeRequest {
  const Maker* maker = nullptr;
  Request request;
  std::unique_ptr<Made> made;
};

inline const std::optional<Error>& refusal_of(const MadeRequest& request) {
  return refusal_of(request.made);
}

/// Runs a request (JSON text, "planish/request"; its schema is docs/schema/request.json):
///
///   {"maker": "connect", "input": "plates.json", "options": {"k": 0.4}, "artifacts": ["dxf"]}
///
/// `input` is the path of a file, or its content: {"name": "plates.json", "content": {...}}, where
/// `content` is the object itself or the text of any file. Other files that it refers to are then
/// sought in "folder", which must be given. Asked in the same way are the other tasks (`tasks`):
/// "bend", the order of bends of whatever a maker makes of the input (artifacts pdf, svg, json),
/// and "info", what a STEP file holds, with "sheets": true the sheet in each body. From any thread,
/// several at a time. Errors:
/// `invalid_input` for a request that breaks its schema (`where` is the JSON pointer) or is nested
/// more than 100 deep, `bad_option` (`where` is that of the option, "/options/bend_k/B99"), those
/// of the maker's input, and refusals, which show the report and the artifacts that explain it: a
/// bend plan shows what is in the way.
Outcome<RunResult> run(const std::string& request, const Progress& progress = {},
                       const Catalogue& catalogue = built_in());

/// What `run` makes before it writes; `artifacts` of the request are left unwritten. `bytes`, if
/// given, stand for the content of its input, since JSON cannot hold any bytes. From any thread.
/// Errors: those of `run`; `bad_option` for a task for which no maker makes anything, "info".
Outcome<MadeRequest> make(const std::string& request, const Progress& progress = {},
                          std::optional<std::string> bytes = std::nullopt,
                          const Catalogue& catalogue = built_in());

/// The same in a separate process, a copy of this one: a file that crashes the CAD kernel ends that
/// process, not this one. From any thread; the copy is made when no `run` is at work (so `progress`
/// of a `run` must not call this), and no other work with Planish or its kernel may be, see
/// `ChildProcess::copy`. Time and memory are limited; cancelling through `progress` ends the
/// process immediately. Costs some milliseconds more. Errors beyond those of `run`: `crashed`,
/// `out_of_time`, `out_of_memory`, each with the stage that was reached, and `internal` if the
/// system cannot start a process.
Outcome<RunResult> run_apart(const std::string& request, const Progress& progress = {},
                             const process::Limits& limits = {},
                             const Catalogue& catalogue = built_in());

/// Option values from the text of a JSON object, like the "options" of a request. With
/// `OptionFiles::content` files are given by content only: {"name": "steel.csv", "content": ...};
/// `material` may also be the name of one that the content of `shop` has.
/// Errors: `invalid_input`, its JSON pointer prefixed by `pointer`.
enum class OptionFiles { path_or_content, content };
Result<OptionValues> read_options(const std::string& json, const Maker& maker, OptionFiles files,
                                  const std::string& pointer);

/// The JSON object from which `read_options` gives these values again.
std::string options_json(const OptionValues& values);

}  // namespace planish::job
