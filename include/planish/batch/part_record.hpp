#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planish::batch {

/// A check of a part that found something.
struct RecordedFinding {
  std::string severity, code, message;
  std::vector<std::string> remedies = {};  ///< sentences, the best first
};

/// A part as a batch keeps it: its journal, tables and page, and packs, have it from here. Of what
/// the report says these are the members that any of them shows; lengths and areas are in `units`,
/// and what it does not say is empty.
struct PartRecord {
  std::string folder;               ///< below that of all parts; equal for the same input always
  std::string report;               ///< JSON on one line, without a line end
  std::vector<std::string> shapes;  ///< the pattern of each piece, as `flat_json`; none: refused
  std::vector<std::string> files;   ///< names in the folder

  std::string input, body, status, units, material, colour;
  std::string reason, message;  ///< why it was refused: code and sentence
  std::optional<int> quantity, openings, bends;
  std::optional<double> thickness, length, width, area, outer_cutting, inner_cutting;
  std::optional<double> mass, density, volume, volume_ratio;
  std::vector<RecordedFinding> findings;
  std::vector<std::string> notes;
  std::vector<std::string> written;  ///< files that were asked for, below the folder of all parts
};

/// The record of a part that has this report. Requires JSON on one line.
PartRecord part_record(std::string folder, std::string report, std::vector<std::string> shapes,
                       std::vector<std::string> files);

/// The findings that are not for information alone.
std::vector<RecordedFinding> warnings_of(const PartRecord& record);

/// One of the texts that `part_records` reads, in brackets and parted by commas. The report stands
/// in it as it is, whatever it says.
std::string record_text(const PartRecord& record);
/// Records from a JSON array of them; empty if the text is none, or one has not what a record has.
/// What else a record holds is left out.
std::optional<std::vector<PartRecord>> part_records(std::string_view text);

}  // namespace planish::batch
