#pragma once

#include <planish/job/artifact.hpp>
#include <planish/job/run.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planish::job {

/// A request, read and checked.
struct Asked {
  const Task* task = nullptr;
  const Maker* maker = nullptr;  ///< that reads the input; null: the task does
  Request request;
  std::optional<InputFile> content;  ///< empty: `request.input` names a file
  std::vector<const Artifact*> artifacts;
  std::vector<std::string_view> flags;  ///< of the task, that are true
};

/// Names of what a task can write of what `maker` makes.
std::vector<std::string_view> written_by(const Task& task, const Maker* maker,
                                         const Catalogue& catalogue);
/// Names of the tasks that have one.
std::vector<std::string_view> task_names(const Catalogue& catalogue);

/// `bytes`, if given, stand for the content of its input. Errors: those of a request (`run`).
Result<Asked> read_asked(const std::string& text, const Catalogue& catalogue,
                         std::optional<std::string> bytes = std::nullopt);

/// What is made, refused or not. Errors: those of the maker's input.
Result<std::unique_ptr<Made>> make_asked(const Asked& asked, const Progress& progress);

/// What is told of what was made, with the artifacts of it.
Outcome<RunResult> told(const Made& made, std::vector<ArtifactFile> artifacts);

// What the tasks do.
Outcome<RunResult> run_maker(const Asked& asked, const Progress& progress);
Outcome<RunResult> run_bend(const Asked& asked, const Progress& progress);
Outcome<RunResult> run_info(const Asked& asked, const Progress& progress);

}  // namespace planish::job
