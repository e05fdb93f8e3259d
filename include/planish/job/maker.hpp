#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/geometry/mesh.hpp>
#include <planish/job/named_file.hpp>
#include <planish/job/options.hpp>
#include <planish/job/report.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planish::schema {
struct Schema;
}

namespace planish::job {

struct ReportDetails;

/// What artifacts are written from.
enum class Source {
  pattern,       ///< the flat pattern, of each piece
  folded_solid,  ///< the folded part as STEP, of each piece
  folded_mesh,   ///< the folded part as a mesh, of all pieces together
  mould_mesh,    ///< the mould that the sheet is laid on
  report,
};

/// What a maker made for one request: the report, and the sources of its artifacts. Functions for
/// sources that the maker's entry does not list are never called.
class Made {
 public:
  Made() = default;
  Made(const Made&) = delete;
  Made& operator=(const Made&) = delete;
  virtual ~Made() = default;

  virtual const Report& report() const = 0;
  virtual Report& report() = 0;
  /// Report as JSON text with the keys of formats.md#report, and as text for a terminal.
  virtual std::string json() const = 0;
  virtual std::string text() const = 0;

  /// A part may be laid flat in several pieces, each with its own pattern.
  virtual int pieces() const { return 1; }
  virtual const Report& piece(int) const { return report(); }

  /// The sources of the same names. Errors: why it could not be made.
  virtual Result<std::string> folded_solid(int piece) const;
  virtual Result<Mesh> folded_mesh() const;
  virtual Result<Mesh> mould_mesh() const;
  virtual SvgOptions svg() const { return {}; }

  /// What a page can drag, as the text of a JSON object (docs/studio-api.md).
  virtual std::string handles() const { return "{}"; }
  /// Names that the input gives to flanges, in the sheet's order; empty if it gives none.
  virtual std::vector<std::string> flange_names() const { return {}; }
  /// For a refused input, the solid to show, by face.
  virtual std::optional<MeshOfFaces> refused_solid() const { return std::nullopt; }
};

inline const std::optional<Error>& refusal_of(const std::unique_ptr<Made>& made) {
  return made->report().refusal;
}

/// The report of the piece that a request shows, from 0; the whole's if a refusal left no pieces.
/// Errors: `bad_option` if there is no such piece; `where` is the option's name.
Result<const Report*> piece_of(const Made& made, int piece);

/// An input file: its bytes, its name in messages, and the folder of the files that it refers to.
/// Without a folder these are not read.
struct InputFile {
  std::string name, content;
  std::optional<std::filesystem::path> folder;
};

/// Reads an input file; "-" reads standard input, which has no folder. `kind` is for messages
/// ("plates file"). Errors: `cannot_read`.
Result<InputFile> read_input_file(const std::filesystem::path& file, const std::string& kind);

/// An opened input with the state kept between requests: the file as read, the sheets found, the
/// strips as bent. Not thread-safe.
class Work {
 public:
  Work() = default;
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
  virtual ~Work() = default;

  /// Replaces the input by an edited one. Errors: those of the parser (the previous input stays);
  /// `bad_option` for inputs that cannot be edited.
  virtual Result<void> edit(const InputFile& input);
  /// The error shows a report if the sheet cannot be made or bent; it shows none if the input or
  /// the request is invalid. Its `where` is the input's name, followed by the JSON pointer of the
  /// cause, or the name of an option, followed by the pointer within its value.
  virtual Outcome<std::unique_ptr<Made>> make(const Request& request, const Progress& progress) = 0;
  /// Frees what is kept only because freeing it takes a while; requests are answered as before.
  /// Returns whether there was anything.
  virtual bool free_spare() { return false; }
  /// What the input holds, as JSON text; "null" if there is nothing to add to the input itself.
  virtual std::string info(const Progress&) const { return "null"; }
};

/// An entry in the table of makers. All texts are for people.
struct Maker {
  std::string_view name = {};         ///< "connect": subcommand, kind of a document
  std::string_view description = {};  ///< "join plates by bends to one sheet"
  std::string_view input = {};        ///< "plates": its file is the "plates file"
  std::string_view format = {};       ///< "planish/plates", its schema "plates"; empty: STEP
  std::string_view mark = {};         ///< a key that only files of this format have
  /// A command line and what it does, in the help of the program: {"planish connect plates.json",
  /// "joins plates by bends, and lays them flat"}.
  std::vector<std::pair<std::string_view, std::string_view>> examples = {};
  std::string_view help = {};  ///< examples and exit status, below the options
  std::vector<Source> sources = {};
  std::vector<OptionUse> options = {};
  const schema::Schema& (*schema)() = nullptr;  ///< of the input; null: not JSON
  /// What its reports have beyond those of all makers; null: nothing.
  ReportDetails (*report_details)() = nullptr;
  /// Errors: `where` is the input's name with the JSON pointer.
  Result<std::unique_ptr<Work>> (*open)(const InputFile& input, const Progress& progress) = nullptr;
  /// The report of a request that ended with an error.
  std::unique_ptr<Made> (*failed)(const Request& request, const Error& error) = nullptr;
  /// Other files that an input refers to, valid or not; null: none.
  std::vector<NamedFile> (*named_files)(const std::string& content) = nullptr;

  bool makes(Source source) const;
  bool takes(std::string_view option) const;
  /// "plates file", "STEP file"
  std::string input_kind() const;
  /// The part of the format after "/".
  std::string schema_name() const;
};

/// Opens the input file of a request. Errors: `cannot_read`, those of the maker.
Result<std::unique_ptr<Work>> open_input(const Maker& maker, const Request& request,
                                         const Progress& progress);

/// The makers of Planish.
const std::vector<Maker>& makers();

}  // namespace planish::job
