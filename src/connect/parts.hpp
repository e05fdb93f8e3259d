#pragma once

#include "bend_fit.hpp"

#include <planish/base/message.hpp>

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

/// The plates that a bend joins, as facts for its refusal.
inline Facts plates_of(const Parts& parts, int bend) {
  return mapped(parts.fits[bend].report.plates,
                [&](int plate) { return Fact("plate", place::plate(parts.ids[plate])); });
}

/// A plate and a place on it, likewise.
inline Facts plate_at(const std::string& id, const Vec3& at) {
  return {{"plate", place::at(place::plate(id), at)}, {"at", place::point(at)}};
}

}  // namespace planish::connect_detail
