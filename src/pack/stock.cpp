#include "stock.hpp"

#include <planish/base/message.hpp>
#include <planish/job/outputs.hpp>
#include <planish/sheet/csv.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

// Each group of one material and thickness is nested by itself on sheets from stock; `nest` numbers
// parts within the group, the list as a whole. What fits on no sheet becomes a note with the size
// it needs, and the rest is laid.

namespace planish::pack {
namespace {

constexpr std::string_view fits_nowhere =
    "{part} does not fit on a sheet of {length:number} × {width}: with its margin it needs "
    "{long:number} × {wide}";

}  // namespace

Result<StockSheets> lay_on_stock(const PartList& list, const Stock& stock,
                                 const Progress& progress) {
  StockSheets result;
  for (const PartGroup& group : list.groups) {
    std::vector<NestPart> parts;
    for (std::size_t i = group.first; i < group.end; ++i)
      parts.push_back({&list.parts[i].flat, list.parts[i].quantity});
    auto nesting = nest(
        parts,
        {.length = stock.length, .width = stock.width, .gap = stock.gap, .grain = stock.grain},
        progress);
    if (!nesting) return pass_on(nesting);
    for (std::size_t s = 0; s < nesting->sheets.size(); ++s) {
      StockSheet sheet{fmt::format("sheet{}_{}", kind_of(group.material, group.thickness), s + 1),
                       group.material, group.thickness, std::move(nesting->sheets[s])};
      for (Placed& placed : sheet.nested.placed)
        placed.part += static_cast<int>(group.first);
      result.sheets.push_back(std::move(sheet));
    }
    for (const TooLarge& large : nesting->too_large) {
      const PackPart& part = list.parts[group.first + static_cast<std::size_t>(large.part)];
      const Told told = tell(fits_nowhere, {{"part", part.stem},
                                            {"length", stock.length, unit::mm},
                                            {"width", stock.width, unit::mm},
                                            {"long", large.needed.x(), unit::mm},
                                            {"wide", large.needed.y(), unit::mm}});
      result.notes.push_back(in_units(told, part.units).sentence);
    }
  }
  return result;
}

Result<std::string> sheet_dxf(const PartList& list, const StockSheet& sheet, const Stock& stock,
                              const DxfOptions& options) {
  SheetDrawing drawing{stock.length, stock.width, {}};
  DxfOptions drawn = options;
  for (const Placed& placed : sheet.nested.placed) {
    const PackPart& part = list.parts[placed.part];
    drawn.units = part.units;
    drawing.parts.push_back({&part.flat, placed.placement, part.name});
  }
  return sheet_dxf_text(drawing, drawn);
}

std::string sheets_csv(const PartList& list, const std::vector<StockSheet>& sheets) {
  std::string text = csv_row({"file", "material", "thickness", "pieces", "use", "parts"});
  for (const StockSheet& sheet : sheets) {
    std::map<int, int> copies;
    for (const Placed& placed : sheet.nested.placed)
      ++copies[placed.part];
    std::vector<std::string> parts;
    for (const auto& [part, number] : copies)
      parts.push_back(fmt::format("{} ×{}", list.parts[part].stem, number));
    text += csv_row({sheet.stem, sheet.material, csv_number(sheet.thickness),
                     std::to_string(sheet.nested.placed.size()),
                     csv_number(100.0 * sheet.nested.use),
                     fmt::format("{}", fmt::join(parts, "; "))});
  }
  return text;
}

}  // namespace planish::pack
