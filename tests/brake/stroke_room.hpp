#pragma once

#include "check.hpp"
#include "choices.hpp"
#include "describe.hpp"
#include "scene.hpp"
#include "support/sheets.hpp"

#include <planish/sheet/flat_pattern.hpp>

#include <string>
#include <vector>

namespace planish::test {

/// A straight punch: the wedge of its tip as wide as the body, which goes up to `height`.
struct PlainPunch {
  Angle angle = Angle::degrees(80);
  double half_width = 10.0, height = 150.0, tip_radius = 0.8;
  std::vector<double> segments = {500, 200, 100, 100, 50, 40, 20, 15, 10};
};
Punch punch(const PlainPunch& plain = {});

struct PlainDie {
  double opening = 12.0;
  Angle angle = Angle::degrees(80);
  double shoulder_radius = 1.5, half_width = 20.0, height = 100.0;
  std::vector<double> segments = {500, 200, 100, 100, 50, 40, 20, 15, 10};
};
Die die(const PlainDie& plain = {});

/// Plain dies of these openings, each called by its own after `prefix`: "12", "V12".
std::vector<Die> plain_dies(const std::vector<double>& openings, const std::string& prefix = "");

/// One punch, one die, no beams, no gauge.
BrakeTools plain_tools(const PlainPunch& upper = {}, const PlainDie& lower = {});

/// A base of 120 × 80 with a wall at its right edge that carries a lip, 30 above the base on the
/// inside and as wide as told, and a flap along the front: r 1, t 1. Bend 1 is the flap's, 2 the
/// wall's, 3 the lip's.
Sheet lipped_base(double lip);

/// Two tabs bent up at one edge of a base, each with a lip of that length bent down: bends 1 and 3
/// are the tabs', 2 and 4 the lips'; r 1, t 1.
Sheet tabs_with_lips(double first, double second);

/// A sheet made ready for strokes; its tools live as long as it does.
class Room {
 public:
  Room(Sheet sheet, BrakeTools tools, const PlanOptions& options = {},
       const FlattenOptions& flattening = {});

  brake_detail::StageCache& cache() { return *cache_; }
  const brake_detail::StrokeInputs& inputs() const { return *inputs_; }
  const brake_detail::Workpiece& work() const { return inputs_->work; }
  const Sheet& sheet() const { return sheet_; }
  const Layout& layout() const { return flat_.layout; }
  const BrakeTools& tools() const { return tools_; }

  /// The line of a bend, counted from 1 as people do.
  int line_of(int bend) const;
  LineSet lines(const std::vector<int>& bends) const;
  /// Whether any way is left to press a bend when others are formed.
  bool can_press(int bend, const std::vector<int>& formed);
  /// The ways to press it.
  std::vector<StrokeChoice> ways(int bend, const std::vector<int>& formed);

 private:
  Sheet sheet_;
  BrakeTools tools_;
  FlatSheet flat_;
  std::unique_ptr<brake_detail::StrokeInputs> inputs_;
  std::unique_ptr<brake_detail::StageCache> cache_;
};

}  // namespace planish::test
