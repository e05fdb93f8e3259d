#pragma once

#include <planish/base/result.hpp>
#include <planish/batch/batch.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace planish::pack {

/// A text file that was given, read already.
struct GivenFile {
  std::string name, text;
};

/// Stock sheets on which parts are laid.
struct Stock {
  double length = 0.0, width = 0.0;  ///< mm
  double gap = 5.0;                  ///< between parts, mm
  bool grain = false;                ///< the patterns' x axis stays along the sheet
};

struct PackOptions {
  /// JSON object, as in requests: how parts are made and written, and the list of their materials.
  std::string options = "{}";
  int workers = 1;
  process::Limits limits;               ///< as of a batch
  bool plan = true;                     ///< find out whether a press brake can bend each part
  std::optional<GivenFile> rates = {};  ///< JSON: what the shop asks for work and material
  std::optional<Stock> stock = {};      ///< lay the parts of each group on sheets
  bool drawings = true;                 ///< a PDF of each part, and the cover
  bool zip = false;                     ///< the pack once more as one file
};

struct PackResult {
  std::size_t parts = 0;           ///< distinct ones
  std::size_t pieces = 0;          ///< of all parts together, by their quantities
  std::size_t groups = 0;          ///< of one material and thickness
  std::size_t refused = 0;         ///< bodies
  std::size_t sheets = 0;          ///< of stock that are needed
  std::vector<std::string> notes;  ///< of what could not be done, one sentence each
  std::vector<batch::RefusedFor> refused_for;
  batch::PassedOver passed_over;
  std::vector<std::filesystem::path> files;  ///< written, below the folder
};

/// Makes everything that a shop needs to cut and bend the parts of files, in the folder `out`
/// (formats.md#pack): of identical parts one with their quantity, in groups of one material and
/// thickness, a DXF each, a list with what drives the price, drawings. `words` are inputs as of a
/// batch, or one folder with the results of one. The batch behind it is kept in the folder, so that
/// a second run does only what is missing; files that an earlier pack left there are removed. Parts
/// refused are in the list. Each file is written whole or not at all. Errors: those of `inputs_of`
/// and `run_batch`, `invalid_input` (materials, rates), `bad_option` (a material that the rates do
/// not have), `cannot_draw`, `cannot_write`, `cancelled`.
Result<PackResult> make_pack(const std::vector<std::string>& words,
                             const std::filesystem::path& out, const PackOptions& options,
                             const job::Catalogue& catalogue,
                             const std::function<void(const batch::BatchProgress&)>& report,
                             const std::function<bool()>& cancelled);

}  // namespace planish::pack
