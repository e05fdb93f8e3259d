// Sections of workpiece and tools across the line, before a stroke and after it; of a hem that is
// closed after it alone (math.md#machine-frame, math.md#closing-hems).
#include "closed_hem.hpp"
#include "fits.hpp"
#include "line_set.hpp"
#include "prepared.hpp"
#include "stage_pose.hpp"
#include "tool_shape.hpp"

#include <planish/base/assert.hpp>
#include <planish/brake/stage_pictures.hpp>

#include <algorithm>

namespace planish {
namespace {

using namespace brake_detail;

/// The parts of the workpiece on both sides of a line in a stage.
std::vector<PlacedPart> placed_parts(const PartTree& tree, const LineSet& formed,
                                     const LineSet& pressed) {
  std::vector<PlacedPart> placed;
  for (const PartTree::Part& part : tree.parts()) {
    const bool hangs = part.before >= 0;
    placed.push_back(
        tree.placed(static_cast<int>(placed.size()),
                    hangs ? &placed[static_cast<std::size_t>(part.before)] : nullptr,
                    hangs ? tree.state(part.over, formed, pressed) : PartTree::State::flat));
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

template <typename Tools>
const auto& named(const Tools& tools, const std::string& id) {
  const auto found = std::ranges::find(tools, id, &Tools::value_type::id);
  PLANISH_ASSERT(found != tools.end());
  return *found;
}

std::vector<ToolProfile> sections_of(const std::vector<PlacedPart>& parts, bool gauge_left) {
  std::vector<ToolProfile> sections;
  for (const PlacedPart& part : parts)
    for (const Convex& section : part.sections)
      sections.push_back(part.left == gauge_left ? section : mirrored(section));
  return sections;
}

/// Where the tools of a stroke stand: `punch_at` is the place of the punch's tip, `die_at` of the
/// middle of the die's top.
void add_tools(StrokePicture& picture, const BrakeTools& tools, const Stroke& stroke,
               const Vec2& punch_at, const Vec2& die_at) {
  const Punch& punch = named(tools.punches, stroke.punch);
  const Die& die = named(tools.dies, stroke.die);
  picture.punch = moved(section_of(punch).outline, punch_at);
  picture.die = moved(section_of(die).outline, die_at);
  if (!tools.machine.upper_beam.empty())
    picture.upper_beam = moved(upper_beam_over(punch, tools.machine).outline, punch_at);
  if (!tools.machine.lower_beam.empty())
    picture.lower_beam = moved(section_of(tools.machine.lower_beam).outline, die_at);
  const auto& gauge = tools.machine.gauge;
  if (stroke.gauge && gauge)
    picture.finger = moved(stroke.gauge->by_nose ? gauge->nose->profile : gauge->finger,
                           {stroke.gauge->distance, stroke.gauge->height});
}

StrokePicture picture_of_closing(const Workpiece& work, const BrakeTools& tools,
                                 const Stroke& stroke, const LineSet& formed, int closing) {
  const BrakeLine& line = work.lines[closing];
  const PartTree tree(work, *line.closes);
  const bool gauge_left = stroke.gauge_direction.dot(line.across()) > 0.0;
  const LineSet none = no_lines(static_cast<int>(work.lines.size()));
  const std::vector<PlacedPart> lying = placed_parts(tree, formed, none);
  const auto open = mapped(lying, [&](const PlacedPart& part) { return &part; });
  const ClosedHem hem = closed_hem(work, tree, line, open);
  StrokePicture picture;
  picture.bent = sections_of(hem.parts, gauge_left);
  const double middle = gauge_left ? hem.middle : -hem.middle;
  add_tools(picture, tools, stroke, {middle, hem.top}, {middle, -work.thickness});
  return picture;
}

StrokePicture picture(const Workpiece& work, const BrakeTools& tools, const Stroke& stroke,
                      const LineSet& formed, const LineSet& pressed) {
  const int first = members(pressed).front();
  const BrakeLine& line = work.lines[first];
  if (line.closes) return picture_of_closing(work, tools, stroke, formed, first);
  const PressMotion motion(line.bend, shoulder_of(named(tools.dies, stroke.die)));
  const double turn = stroke.angle.radians();
  const auto parts = placed_parts(PartTree(work, first), formed, pressed);
  const bool gauge_left = stroke.gauge_direction.dot(line.across()) > 0.0;
  StrokePicture picture;
  picture.lying = sections_at(motion, parts, gauge_left, 0.0);
  picture.bent = sections_at(motion, parts, gauge_left, turn);
  const double height = motion.die_height(turn);
  add_tools(picture, tools, stroke, Vec2::Zero(), {0.0, height});
  picture.die_drop = motion.die_height(0.0) - height;
  return picture;
}

}  // namespace

std::vector<StrokePicture> stroke_pictures(const Sheet& sheet, const Layout& layout,
                                           const BrakeTools& tools, const PlanOptions& options,
                                           const Plan& plan) {
  const auto work = workpiece_of(sheet, layout,
                                 workpiece_options(sheet.thickness, tools, options, plan.large));
  PLANISH_ASSERT(work.has_value());
  std::vector<StrokePicture> pictures;
  LineSet formed = no_lines(static_cast<int>(work->lines.size()));
  for (const Stroke& stroke : plan.strokes) {
    const LineSet pressed = lines_of(*work, ordered(stroke));
    pictures.push_back(picture(*work, tools, stroke, formed, pressed));
    formed = joined(formed, pressed);
  }
  return pictures;
}

}  // namespace planish
