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

/// The name of a flange, at a place in it.
struct FlangeName {
  std::string name;
  Vec2 at;            ///< in the flat pattern
  double room = 0.0;  ///< around it, mm
};
/// "F1" … in the middle of the widest part of each flange, away from its openings.
std::vector<FlangeName> flange_names(const Sheet& sheet, const Layout& layout);

/// A length to measure once a flange is bent, from the outside of the bend on.
struct FlangeCheck {
  std::string flange;
  double length = 0.0;
};

/// The side of the sheet that faces up in a stroke: "front", which its pattern shows, or "back".
/// Requires the layout of the pattern.
std::string_view side_up(const Stroke& stroke, const Layout& layout);

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
  std::string machine = {};                 ///< name of the press brake; may be empty
  double bed = 0.0;                         ///< length of it
  const Plan* plan = nullptr;               ///< null: there is none
  std::vector<BendId> blocked = {};         ///< bends that cannot be pressed
  std::vector<std::string> obstacles = {};  ///< sentences: why they cannot
  std::vector<std::string> proposals = {};  ///< sentences: how the part could be bent
  std::vector<FlangeName> flanges = {};
  std::vector<std::optional<FlangeCheck>> checks = {};  ///< of each stroke; may be left out
  std::vector<std::string> notes = {};                  ///< sentences: what else is to be known
};

/// A bend plan to hang at the machine, A4 upright: the part with its flat pattern, bends numbered
/// in the order of the strokes; the bed with its stations for each set-up; then each stroke with
/// the way the sheet lies, the workpiece between the tools, gauge, length to check, tools with
/// their segments, force, and what is turned since the stroke before; then notes. Requires the
/// pictures of the plan's strokes; without a plan there is the first page alone.
std::vector<Page> bend_pages(const BendDrawing& drawing,
                             const std::vector<StrokePicture>& pictures);

}  // namespace planish::drawing
