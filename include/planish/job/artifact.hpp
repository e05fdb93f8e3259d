#pragma once

#include <planish/job/maker.hpp>
#include <planish/job/task.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace planish::job {

/// What an artifact shows, and the option that asks for its files.
enum class Role { flat, folded, mould, report };

/// An entry in the table of artifacts: a file that can be written from what was made.
struct Artifact {
  std::string_view name;  ///< "flat.step": in requests and in names of downloads
  Role role;
  Source source;
  std::string_view suffix;       ///< ".step"
  std::string_view file_end;     ///< ends default file names: "_flat.step"
  std::string_view media_type;   ///< "model/step"
  std::string_view description;  ///< "STEP, flat solid"
  /// The file's bytes. `made` must not be refused, except for reports. Errors: those of the
  /// writers.
  Result<std::string> (*write)(const Made& made, int piece, const Request& request);

  /// Whether each piece has a file of its own.
  bool by_piece() const { return source == Source::pattern || source == Source::folded_solid; }
  /// Whether the other files are worth writing without this one: a solid or mould that cannot be
  /// made leaves the pattern as it is.
  bool may_be_missing(const Error& why) const;
};

/// Notes in the report that this file is not written, and why: a warning with the role's code
/// (`mould`), or `folded_solid`, unless it is there already.
void note_missing(Report& report, const Artifact& artifact, const Error& why);

/// The artifacts of Planish; the first of each role is written by default.
const std::vector<Artifact>& artifacts();

/// The makers, artifacts and tasks that a program offers.
struct Catalogue {
  std::vector<Maker> makers;
  std::vector<Artifact> artifacts;
  std::vector<Task> tasks;

  /// Null for an unknown name.
  const Maker* maker(std::string_view name) const;
  /// The task of that name, or of the maker of that name; null for an unknown one.
  const Task* task(std::string_view name) const;
  /// The maker that reads an input's format: by its "format" key, else by its mark; STEP if it is
  /// not JSON. Errors: `invalid_input`.
  Result<const Maker*> maker_for(const std::string& name, const std::string& content) const;
  /// What a maker can write, in the order of the table.
  std::vector<const Artifact*> written_by(const Maker& maker) const;
  std::vector<const Artifact*> written_by(const Maker& maker, Role role) const;
  /// The artifact of that name, else the first with that suffix ("step" is the flat solid where
  /// there is no folded one); null if the maker writes neither.
  const Artifact* artifact(const Maker& maker, std::string_view name) const;
};

/// All of `makers`, `artifacts` and `tasks`.
const Catalogue& built_in();

/// An artifact's bytes and file name: "part.dxf", or "part-1.dxf" for one of several pieces.
struct WrittenArtifact {
  const Artifact* artifact = nullptr;
  std::string name, bytes;
};
/// All files of one artifact; `stem` begins their names. Errors: those of the writer.
Result<std::vector<WrittenArtifact>> write(const Artifact& artifact, const Made& made,
                                           const Request& request, const std::string& stem);

/// "flat", "folded", "mould", "report"
std::string_view role_name(Role role);

}  // namespace planish::job
