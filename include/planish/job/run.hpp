#pragma once

#include <planish/job/artifact.hpp>
#include <planish/job/child_process.hpp>

#include <string>
#include <vector>

namespace planish::job {

struct ArtifactFile {
  std::string artifact, name, media_type, bytes;
};

/// What came of a request: its report as JSON text and the artifacts that it asked for; none where
/// the report has a refusal.
struct RunResult {
  Status status = Status::ok;
  std::string report;
  std::vector<ArtifactFile> artifacts;
};

/// Does what a request says (JSON text, "planish/request"; its schema is docs/schema/request.json):
///
///   {"maker": "connect", "input": "plates.json", "options": {"k": 0.4}, "artifacts": ["dxf"]}
///
/// `input` is the path of a file, or its content: {"name": "plates.json", "content": {...}}, where
/// `content` is the object itself, or a text of any file. Of a file given so, others that it names
/// are sought in "folder". Errors: `invalid_input` for a request that breaks its schema (`where` is
/// the JSON pointer), `bad_option`, those of the maker's input.
Result<RunResult> run(const std::string& request, const Progress& progress = {},
                      const Catalogue& catalogue = built_in());

/// The same in a process of its own, a copy of this one (`ChildProcess::copy`, which says when one
/// may be made): what a file does to the CAD kernel ends that process and not this one. What it
/// takes is limited; a request that `progress` cancels is ended at once. Costs some milliseconds
/// more. Errors beyond those of `run`: `crashed`, `out_of_time`, `out_of_memory`, each with the
/// stage at which it came, and `internal` where the system starts no process.
Result<RunResult> run_apart(const std::string& request, const Progress& progress = {},
                            const Limits& limits = {}, const Catalogue& catalogue = built_in());

/// Values of options from the text of a JSON object, as the "options" of a request. With
/// `OptionFiles::content` files are given by content alone: {"name": "steel.csv", "content": ...}.
/// Errors: `invalid_input` with the JSON pointer behind `pointer`.
enum class OptionFiles { path_or_content, content };
Result<OptionValues> read_options(const std::string& json, const Maker& maker, OptionFiles files,
                                  const std::string& pointer);

}  // namespace planish::job
