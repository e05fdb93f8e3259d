#pragma once

#include <planish/job/artifact.hpp>
#include <planish/job/run.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::job {

/// What is asked in the same way as a maker is, but is none: `planish bend` and `planish info`.
inline constexpr std::string_view kBend = "bend", kInfo = "info";

/// What `bend` writes: the plan on pages, and the report.
inline constexpr std::string_view kBendArtifacts[] = {"pdf", "svg", "json"};

/// A request, read and checked.
struct Asked {
  enum class Task { make, bend, info };
  Task task = Task::make;
  const Maker* maker = nullptr;  ///< of `bend` the one that reads the input; null for `info`
  Request request;
  std::optional<InputFile> content;  ///< empty: `request.input` names a file
  std::vector<const Artifact*> artifacts;
  bool sheets = false;  ///< of `info`
};

/// `bytes`, if given, stand for the content of its input. Errors: those of a request (`run`).
Result<Asked> read_asked(const std::string& text, const Catalogue& catalogue,
                         std::optional<std::string> bytes = std::nullopt);

/// What is made, refused or not. Errors: those of the maker's input.
Result<std::unique_ptr<Made>> make_asked(const Asked& asked, const Progress& progress);

/// What is told of what was made, with the artifacts of it.
Outcome<RunResult> told(const Made& made, std::vector<ArtifactFile> artifacts);

Outcome<RunResult> run_bend(const Asked& asked, const Progress& progress);
Outcome<RunResult> run_info(const Asked& asked, const Progress& progress);

}  // namespace planish::job
