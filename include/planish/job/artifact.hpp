#pragma once

#include <planish/job/maker.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace planish::job {

/// What an artifact is of, and the option that asks for its files.
enum class Role { flat, folded, mould, report };

/// One row of the table of artifacts: a file that can be written of what was made.
struct Artifact {
  std::string_view name;  ///< "flat.step": in requests, and of downloads
  Role role;
  Source source;
  std::string_view suffix;       ///< ".step"
  std::string_view file_end;     ///< of a file that nobody named: "_flat.step"
  std::string_view media_type;   ///< "model/step"
  std::string_view description;  ///< "STEP, flat solid"
  /// The file's bytes; `made` has no refusal, but for reports. Errors: those of the writers.
  Result<std::string> (*write)(const Made& made, int piece, const Request& request);

  /// Whether each piece has a file of its own.
  bool by_piece() const { return source == Source::pattern || source == Source::folded_solid; }
};

/// The artifacts of Planish, a row each; the first of a role is what is written where nothing else
/// is asked for.
const std::vector<Artifact>& artifacts();

/// Makers and artifacts that belong together: what a program offers.
struct Catalogue {
  std::vector<Maker> makers;
  std::vector<Artifact> artifacts;

  /// Null where there is none of that name.
  const Maker* maker(std::string_view name) const;
  /// The one whose format an input has: by "format", else by its mark, STEP for what is not JSON.
  /// Errors: `invalid_input`.
  Result<const Maker*> maker_for(const std::string& name, const std::string& content) const;
  /// What a maker can write, in the order of the table.
  std::vector<const Artifact*> written_by(const Maker& maker) const;
  std::vector<const Artifact*> written_by(const Maker& maker, Role role) const;
  /// The one of that name, else the first with that suffix ("step" of what has no folded solid is
  /// the flat one); null where the maker writes none.
  const Artifact* artifact(const Maker& maker, std::string_view name) const;
};

/// All of `makers` and `artifacts`.
const Catalogue& built_in();

/// An artifact's bytes and the name of its file: "part.dxf", of several pieces "part-1.dxf".
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
