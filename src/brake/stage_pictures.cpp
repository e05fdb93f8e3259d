#include "fits.hpp"
#include "line_set.hpp"
#include "stage_pose.hpp"
#include "tool_shape.hpp"

#include <planish/base/assert.hpp>
#include <planish/brake/stage_pictures.hpp>

#include <algorithm>

namespace planish {
namespace {

using namespace brake_detail;

/// The lines that a stroke presses.
LineSet lines_of(const Workpiece& work, const Stroke& stroke) {
  LineSet lines = no_lines(static_cast<int>(work.lines.size()));
  for (int i = 0; i < std::ssize(work.lines); ++i)
    for (const BendId bend : work.lines[i].bends)
      if (std::ranges::find(stroke.bends, bend) != stroke.bends.end() &&
          work.lines[i].press_line == stroke.press_line)
        insert(lines, i);
  return lines;
}

int first_of(const LineSet& lines, int count) {
  for (int i = 0; i < count; ++i)
    if (holds(lines, i)) return i;
  PLANISH_ASSERT(false);
  return 0;
}

/// The parts of the workpiece on both sides of a line in a stage.
std::vector<PlacedPart> placed_parts(const PartTree& tree, const LineSet& formed,
                                     const LineSet& pressed) {
  std::vector<PlacedPart> placed;
  for (const PartTree::Part& part : tree.parts()) {
    PartTree::State over = PartTree::State::flat;
    if (part.before >= 0 && holds(pressed, part.over)) over = PartTree::State::pressed;
    if (part.before >= 0 && holds(formed, part.over)) over = PartTree::State::formed;
    placed.push_back(tree.placed(
        static_cast<int>(placed.size()),
        part.before >= 0 ? &placed[static_cast<std::size_t>(part.before)] : nullptr, over));
  }
  return placed;
}

/// Sections of all parts at a turn, with the gauge's side at y > 0.
std::vector<ToolProfile> sections_at(const PressMotion& motion,
                                     const std::vector<PlacedPart>& parts, bool gauge_left,
                                     double turn) {
  std::vector<ToolProfile> sections;
  for (const PlacedPart& part : parts) {
    const auto add = [&](const Convex& section, bool left) {
      sections.push_back(left == gauge_left ? section : mirrored(section));
    };
    for (const Convex& section : part.sections)
      add(motion.side(section, turn), part.left);
    for (const ArcStrip& strip : part.strips)
      add(motion.arc(strip.from, strip.to, turn), strip.left);
  }
  return sections;
}

ToolProfile moved_up(ToolProfile profile, double by) {
  for (Vec2& p : profile)
    p.y() += by;
  return profile;
}

template <typename Tools>
const auto& named(const Tools& tools, const std::string& id) {
  const auto found = std::ranges::find(tools, id, &Tools::value_type::id);
  PLANISH_ASSERT(found != tools.end());
  return *found;
}

StrokePicture picture(const Workpiece& work, const BrakeTools& tools, const Stroke& stroke,
                      const LineSet& formed, const LineSet& pressed) {
  const int first = first_of(pressed, static_cast<int>(work.lines.size()));
  const BrakeLine& line = work.lines[first];
  const Punch& punch = named(tools.punches, stroke.punch);
  const Die& die = named(tools.dies, stroke.die);
  const PressMotion motion(line.bend, shoulder_of(die));
  const double turn = stroke.angle.radians();
  const auto parts = placed_parts(PartTree(work, first), formed, pressed);
  const bool gauge_left = stroke.gauge_direction.dot(line.across()) > 0.0;
  StrokePicture picture;
  picture.lying = sections_at(motion, parts, gauge_left, 0.0);
  picture.bent = sections_at(motion, parts, gauge_left, turn);
  picture.punch = section_of(punch).outline;
  const double height = motion.die_height(turn);
  picture.die = moved_up(section_of(die).outline, height);
  picture.die_drop = motion.die_height(0.0) - height;
  if (!tools.machine.upper_beam.empty())
    picture.upper_beam = section_of(tools.machine.upper_beam, lowered(punch)).outline;
  if (!tools.machine.lower_beam.empty())
    picture.lower_beam = moved_up(section_of(tools.machine.lower_beam).outline, height);
  if (stroke.gauge && tools.machine.gauge)
    for (const Vec2& p : tools.machine.gauge->finger)
      picture.finger.emplace_back(p.x() + stroke.gauge->distance, p.y());
  return picture;
}

}  // namespace

std::vector<StrokePicture> stroke_pictures(const Sheet& sheet, const Layout& layout,
                                           const BrakeTools& tools, const PlanOptions& options,
                                           const Plan& plan) {
  const auto work = workpiece_of(sheet, layout, workpiece_options(sheet.thickness, options));
  PLANISH_ASSERT(work.has_value());
  std::vector<StrokePicture> pictures;
  LineSet formed = no_lines(static_cast<int>(work->lines.size()));
  for (const Stroke& stroke : plan.strokes) {
    const LineSet pressed = lines_of(*work, stroke);
    pictures.push_back(picture(*work, tools, stroke, formed, pressed));
    formed = joined(formed, pressed);
  }
  return pictures;
}

}  // namespace planish
