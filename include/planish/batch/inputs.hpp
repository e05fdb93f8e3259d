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
  int copies = 1;    ///< of all that it holds, as its list says
  std::string said_by = {};  ///< "parts.txt, line 3", which says how many; empty: nobody
};

/// A file or folder in a folder that is not worked on.
struct PassedFile {
  std::string name;    ///< as an input's
  std::string reason;  ///< a code: `no_input` for what nobody reads, `cannot_read`
  std::string why;     ///< in a few words
};

/// All that is passed over, in the byte order of the names.
struct PassedOver {
  std::size_t count = 0;
  std::vector<PassedFile> files = {};  ///< the first `kMostPassed` of them
};
inline constexpr std::size_t kMostPassed = 1000;

struct Inputs {
  std::vector<Input> files;
  PassedOver passed_over = {};
};

/// The files that words of a command line stand for, each once, in the byte order of their names:
/// files; folders, with all STEP files and makers' JSON files below them; of packed files that hold
/// several, each STEP file; lists ("@parts.txt" in UTF-8: a word a line, relative to the list's
/// folder, in quotes if wanted, # begins a comment; " x20" behind it: 20 of each).
/// All else in a folder is passed over, and so is a folder that cannot be read; nobody hears of
/// what is hidden. `out` is the folder of the results. Errors: `cannot_read` (a word that is no
/// file or folder, a list that cannot be read), `no_input` (there are none), `bad_option` (two of
/// one name; `out` in one of the folders), `invalid_input` (a file that lists name with different
/// quantities; a list that is no text in UTF-8).
Result<Inputs> inputs_of(const std::vector<std::string>& words, const std::filesystem::path& out,
                         const job::Catalogue& catalogue);

}  // namespace planish::batch
