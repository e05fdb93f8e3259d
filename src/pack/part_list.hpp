#pragma once

#include <planish/batch/parts.hpp>
#include <planish/drawing/part_view.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/request.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::pack {

/// What a part is called whose material nobody says.
inline constexpr auto kUnknown = "unknown";

/// "_S235_2mm", "_2mm": what names of files say of material and thickness.
std::string kind_of(const std::string& material, double thickness);

/// Where a part came from.
struct PartSource {
  std::string input;  ///< name of the file
  std::string body;
  int quantity = 1;
};

/// One part to be made, as often as its quantity says. Lengths in mm.
struct PackPart {
  std::string name;  ///< as its body is called
  /// Of its files, "<part>_<material>_<t>mm_x<quantity>", without a material that is not known; no
  /// two are the same, in any case.
  std::string stem;
  std::string material = kUnknown;
  FlatPattern flat;
  LengthUnit units = LengthUnit::mm;
  int quantity = 0;
  std::vector<PartSource> sources;
  Vec2 size = Vec2::Zero();         ///< smallest rectangle around it, longer side first
  double cut_length = 0.0;          ///< of all contours and slits
  std::size_t pierces = 0;          ///< contours and slits
  double bend_length = 0.0;         ///< of all bends
  std::optional<double> mass = {};  ///< kg, of one
  std::string plan;                 ///< whether it can be bent, in a few words
  std::vector<std::string> help;    ///< of one that cannot: sentences, what it can be bent with
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
  std::optional<drawing::PartView> view = {};
  std::optional<double> cost = {};  ///< of all, in the currency of the rates
};

/// `PackPart::plan` of a part whose report says nothing of a press brake, and of one that was
/// planned and has no bend that a stroke forms: it is rolled, or bent otherwise.
inline constexpr auto kNotPlanned = "not planned", kNoStroke = "takes no stroke";

/// A body of which no part was made.
struct RefusedPart {
  PartSource source;
  std::string code, reason;
};

/// Parts of one material and thickness: positions in the list.
struct PartGroup {
  std::string material;
  double thickness = 0.0;
  std::size_t first = 0, end = 0;
};

/// What a pack holds: parts by material, thickness and name.
struct PartList {
  std::vector<PackPart> parts;
  std::vector<PartGroup> groups;
  std::vector<RefusedPart> refused;
  std::vector<int> unused_rows = {};  ///< lines of the list of materials about no part
  batch::PassedOver passed_over = {};
};

/// Merges identical parts of one material and puts all in order. The request has the materials that
/// were chosen, which go before those that the batch knows. Errors: `cannot_read` (a batch that is
/// damaged), `bad_option` (quantities from two places).
Result<PartList> part_list(const std::filesystem::path& batch, const job::Request& request);

}  // namespace planish::pack
