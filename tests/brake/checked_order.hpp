#pragma once

#include "brake/stroke_room.hpp"

#include <planish/brake/order.hpp>

#include <gtest/gtest.h>

#include <optional>

namespace planish::test {

/// A sheet laid flat, with what checks its orders.
struct Checked {
  Checked(Sheet given, BrakeTools with, PlanOptions how = {})
      : sheet(std::move(given)), tools(std::move(with)), options(std::move(how)) {
    flat = *flat_sheet(sheet);
    checker.emplace(*OrderChecker::make(sheet, flat.layout, tools, options));
  }
  CheckedOrder check(const std::vector<OrderedStroke>& order) {
    auto checked = checker->check(order);
    EXPECT_TRUE(checked) << (checked ? "" : checked.error().message);
    return checked ? std::move(*checked) : CheckedOrder();
  }
  Plan plan() const { return *plan_bending(sheet, flat.layout, tools, options); }

  Sheet sheet;
  BrakeTools tools;
  PlanOptions options;
  FlatSheet flat;
  std::optional<OrderChecker> checker;
};

inline std::vector<OrderedStroke> one_by_one(const std::vector<int>& bends) {
  std::vector<OrderedStroke> order;
  for (const int bend : bends)
    order.push_back({{BendId(bend)}});
  return order;
}

}  // namespace planish::test
