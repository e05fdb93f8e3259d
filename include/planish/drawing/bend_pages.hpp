#pragma once

#include <planish/base/length_unit.hpp>
#include <planish/brake/plan.hpp>
#include <planish/brake/stage_pictures.hpp>
#include <planish/io/pages.hpp>
#include <planish/sheet/flat_pattern.hpp>
#include <planish/sheet/layout.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::drawing {

/// What the pages of a bend plan show. Lengths in mm.
struct BendDrawing {
  std::string title;           ///< the part
  std::string metal;           ///< what force and angles are for: "steel 400 N/mm²"
  double thickness = 0.0;      ///< of the sheet
  Vec2 size = Vec2::Zero();    ///< of the blank, longer side first
  std::optional<double> mass;  ///< kg
  LengthUnit units = LengthUnit::mm;
  const FlatPattern& flat;
  const Layout& layout;
  const Plan* plan = nullptr;          ///< null: there is none
  std::vector<BendId> blocked;         ///< bends that cannot be pressed
  std::vector<std::string> obstacles;  ///< sentences: why they cannot
  std::vector<std::string> proposals;  ///< sentences: how the part could be bent
};

/// A bend plan to hang at the machine, A4 upright: the part with its flat pattern, bends numbered
/// in the order of the strokes; then each stroke with the way the sheet lies, the workpiece between
/// the tools, gauge, tools with their segments, force, and what is turned since the stroke before.
/// Requires the pictures of the plan's strokes; without a plan there is the first page alone.
std::vector<Page> bend_pages(const BendDrawing& drawing,
                             const std::vector<StrokePicture>& pictures);

}  // namespace planish::drawing
