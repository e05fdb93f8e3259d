#pragma once

#include "part_list.hpp"

#include <planish/base/progress.hpp>
#include <planish/nest/nest.hpp>
#include <planish/pack/pack.hpp>

#include <string>
#include <vector>

namespace planish::pack {

/// A sheet of stock with parts on it, to be written.
struct StockSheet {
  std::string stem;  ///< "sheet_<material>_<t>mm_<number>"
  std::string material;
  double thickness = 0.0;
  NestedSheet nested;  ///< its parts are positions in the list
};

struct StockSheets {
  std::vector<StockSheet> sheets;
  std::vector<std::string> notes;  ///< parts that are larger than a sheet, one sentence each
};

/// Lays the parts of each group on sheets. Errors: those of `nest`.
Result<StockSheets> lay_on_stock(const PartList& list, const Stock& stock,
                                 const Progress& progress);

/// The drawing of a sheet. Errors: those of `sheet_dxf_text`.
Result<std::string> sheet_dxf(const PartList& list, const StockSheet& sheet, const Stock& stock,
                              const DxfOptions& options);

/// The sheets as CSV: what is on each, and how much of it becomes parts.
std::string sheets_csv(const PartList& list, const std::vector<StockSheet>& sheets);

}  // namespace planish::pack
