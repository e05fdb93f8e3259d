#pragma once

#include "part_list.hpp"

#include <string>

namespace planish::pack {

/// The list of parts as CSV (formats.md#pack): a row a part, a row of totals behind each group and
/// at the end, then what was refused. Lengths in mm.
std::string parts_csv(const PartList& list, const std::string& currency);

/// "panel.step", "chair.step: leg ×4"
std::string source_text(const PartSource& source);

/// Sums over the parts of a group, each as often as it is made.
struct Totals {
  int parts = 0, quantity = 0;
  double area = 0.0, cut_length = 0.0, bend_length = 0.0;
  std::size_t pierces = 0, bends = 0;
  std::optional<double> mass = 0.0, cost = 0.0;  ///< empty where one is not known
};
Totals totals_of(const PartList& list, std::size_t first, std::size_t end);

}  // namespace planish::pack
