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
#include <vector>

namespace planish::job {

struct Schema;
struct ReportDetails;

/// What artifacts are written from.
enum class Source {
  pattern,       ///< the flat pattern, of each piece
  folded_solid,  ///< the folded part as STEP, of each piece
  folded_mesh,   ///< the folded part as a mesh, of all pieces together
  mould_mesh,    ///< the mould that the sheet is laid on
  report,
};

/// What a maker made of one request: the report, and what artifacts are written from. Functions of
/// sources that the maker does not name in its row are not called.
class Made {
 public:
  Made() = default;
  Made(const Made&) = delete;
  Made& operator=(const Made&) = delete;
  virtual ~Made() = default;

  virtual const Report& report() const = 0;
  virtual Report& report() = 0;
  /// Report as JSON text with the keys of formats.md#report, and as a person reads it on a
  /// terminal.
  virtual std::string json() const = 0;
  virtual std::string text() const = 0;

  /// A part may be laid flat in several pieces, each with a pattern of its own.
  virtual int pieces() const { return 1; }
  virtual const Report& piece(int) const { return report(); }

  /// What the sources of the same names give. Errors: the reason why there is none.
  virtual Result<std::string> folded_solid(int piece) const;
  virtual Result<Mesh> folded_mesh() const;
  virtual Result<Mesh> mould_mesh() const;
  virtual SvgOptions svg() const { return {}; }

  /// What a page can drag, as the text of a JSON object (docs/studio-api.md).
  virtual std::string handles() const { return "{}"; }
  /// Names that the input gives to flanges, in the sheet's order; empty where it gives none.
  virtual std::vector<std::string> flange_names() const { return {}; }
  /// Of what was refused, the solid to look at.
  virtual std::optional<Mesh> refused_solid() const { return std::nullopt; }
};

/// The report of the piece that a request shows, from 0; that of the whole where refusal left none.
/// Errors: `bad_option` where there is no such piece; `where` is the option's name.
Result<const Report*> piece_of(const Made& made, int piece);

/// An input file: its bytes, what messages call it, and where files that it names are. Without a
/// folder these are left unread.
struct InputFile {
  std::string name, content;
  std::optional<std::filesystem::path> folder;
};

/// Reads it; "-" reads standard input, which has no folder of its own. `kind` names it in messages
/// ("plates file"). Errors: `cannot_read`.
Result<InputFile> read_input_file(const std::filesystem::path& file, const std::string& kind);

/// One opened input with what is kept between requests: a file that was read, sheets that were
/// found, strips as they are bent. Not thread-safe.
class Work {
 public:
  Work() = default;
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
  virtual ~Work() = default;

  /// Takes an edited input in the place of what it has. Errors: those of the parser, and what it
  /// had stays; `bad_option` of inputs that cannot be edited.
  virtual Result<void> edit(const InputFile& input);
  /// An error means that the input or the request is wrong; what cannot be made gives a report
  /// with `refusal`. `where` of both is the input's name, followed by the JSON pointer of the
  /// cause, or the name of an option, followed by the pointer within its value.
  virtual Result<std::unique_ptr<Made>> make(const Request& request, const Progress& progress) = 0;
  /// What the input holds, as JSON text; "null" where there is nothing to say beyond itself.
  virtual std::string info(const Progress&) const { return "null"; }
};

/// One row of the table of makers. All texts are for people.
struct Maker {
  std::string_view name = {};         ///< "connect": subcommand, kind of a document
  std::string_view description = {};  ///< "join plates by bends to one sheet"
  std::string_view input = {};        ///< "plates": its file is the "plates file"
  std::string_view format = {};       ///< "planish/plates", its schema "plates"; empty: STEP
  std::string_view mark = {};         ///< a key that files of this format alone have
  std::string_view help = {};         ///< examples and exit status, below the options
  std::vector<Source> sources = {};
  std::vector<OptionUse> options = {};
  const Schema& (*schema)() = nullptr;  ///< of the input; null: not JSON
  /// What its reports have beyond those of all makers; null: nothing.
  ReportDetails (*report_details)() = nullptr;
  /// Errors: `where` is the input's name with the JSON pointer.
  Result<std::unique_ptr<Work>> (*open)(const InputFile& input, const Progress& progress) = nullptr;
  /// The report of a request that ended with an error.
  std::unique_ptr<Made> (*failed)(const Request& request, const Error& error) = nullptr;
  /// Further files that an input names, valid or not; null: none.
  std::vector<NamedFile> (*named_files)(const std::string& content) = nullptr;

  bool makes(Source source) const;
  bool takes(std::string_view option) const;
  /// "plates file", "STEP file"
  std::string input_kind() const;
  /// What stands behind the "/" of the format.
  std::string schema_name() const;
};

/// Opens what a request names as its input. Errors: `cannot_read`, those of the maker.
Result<std::unique_ptr<Work>> open_input(const Maker& maker, const Request& request,
                                         const Progress& progress);

/// The makers of Planish, a row each.
const std::vector<Maker>& makers();

}  // namespace planish::job
