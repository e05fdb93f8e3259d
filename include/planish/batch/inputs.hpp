#pragma once

#include <planish/base/result.hpp>
#include <planish/job/artifact.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace planish::batch {

/// A file to be worked on.
struct Input {
  std::filesystem::path file;
  std::string name;  ///< below the folder given, or that of its list, with "/"; else the file's
};

/// The files that words of a command line stand for, each once, in the byte order of their names:
/// files; folders, with all STEP files and makers' JSON files below them, but nothing hidden; lists
/// ("@parts.txt": a word a line, relative to the list's folder, # begins a comment). `out` is the
/// folder of the results. Errors: `cannot_read` (a word that is no file or folder, a list that
/// cannot be read), `no_input` (there are none), `bad_option` (two of one name; `out` in one of the
/// folders).
Result<std::vector<Input>> inputs_of(const std::vector<std::string>& words,
                                     const std::filesystem::path& out,
                                     const job::Catalogue& catalogue);

}  // namespace planish::batch
