#pragma once

#include "bend_fit.hpp"
#include "sample_plates.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>

// Single plates and pairs of plates to test one step of joining with.

namespace planish::test {

inline constexpr double kPlanarity = 1e-3;  // mm

inline connect_detail::PlacedPlate laid(const Plate& plate) {
  auto made = connect_detail::placed(plate, "/plates/0", kPlanarity);
  EXPECT_TRUE(made) << (made ? "" : made.error().message + " at " + made.error().where);
  return made ? std::move(*made) : connect_detail::PlacedPlate{};
}

/// A task between the first two plates of a structure, and the plates that it points to.
struct PairTask {
  std::array<connect_detail::PlacedPlate, 2> plates;
  connect_detail::FitTask task;

  explicit PairTask(const PlateStructure& structure, const BendRequest& request = {})
      : plates{laid(structure.plates[0]), laid(structure.plates[1])} {
    task.plates = {&plates[0], &plates[1]};
    task.request = request;
    task.request.between = {structure.plates[0].id, structure.plates[1].id};
    task.thickness = structure.thickness;
    task.pointer = "/bends/0";
  }
  PairTask(const PairTask&) = delete;
  PairTask& operator=(const PairTask&) = delete;
};

}  // namespace planish::test
