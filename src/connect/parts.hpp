#pragma once

#include "bend_fit.hpp"

#include <optional>
#include <string>
#include <vector>

namespace planish::connect_detail {

/// Plates and the bends that join them, ready to become a sheet. The bends form a tree, or close
/// loops that lie flat.
struct Parts {
  double thickness = 0.0;
  std::vector<PlacedPlate> plates;
  std::vector<std::string> ids;
  std::vector<BendFit> fits;
  int root = 0;  ///< index into the plates

  /// The plate on one side of a bend; empty if that end is free.
  std::optional<int> plate_of(int bend, int side) const {
    const auto& rows = fits[bend].report.plates;
    const auto& joint_of = fits[bend].joint_of;
    if (joint_of && joint_of->second != side) return std::nullopt;
    if (side >= static_cast<int>(rows.size())) return std::nullopt;
    return rows[side];
  }
};

}  // namespace planish::connect_detail
