#pragma once

#include <planish/base/angle.hpp>
#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/brake/stroke_search.hpp>
#include <planish/brake/tools.hpp>
#include <planish/sheet/layout.hpp>
#include <planish/sheet/sheet.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace planish {

/// Which V a bend may be pressed over (math.md#v-choice).
enum class VChoice {
  any,     ///< every one from 4 to 12 thicknesses; a size away from the wanted one costs
  wanted,  ///< the one nearest to the wanted one
};

/// Which inside radius is wanted (math.md#made-radius).
enum class RadiusWanted {
  made,   ///< what the tools leave; told where it is not the drawn one
  drawn,  ///< the drawn one, within a third of it
};

/// How a bend whose drawn radius no usual V leaves is formed (math.md#large-radii).
enum class Forming { over_v, bumps, rolled };

/// A bend of large radius. Of bumps `pitch` is that along the neutral surface, and `chord_error`
/// how far the drawn radius lies from the plane pieces between them.
struct LargeBend {
  BendId bend;
  Forming forming = Forming::over_v;
  int bumps = 0;
  double pitch = 0.0;  ///< mm
  Angle angle = {};    ///< of each bump
  double chord_error = 0.0;
};

/// How a sheet is to be bent. Lengths in mm.
struct PlanOptions {
  double clearance = 0.0;                ///< kept between the workpiece and the tools
  std::optional<double> shortfall = {};  ///< of the punch at each end of a bend line; empty:
                                         ///< one thickness
  Angle springback;                      ///< bent beyond the angle
  double tensile_strength = 450.0;       ///< R_m, N/mm²
  double radius_of_opening = 0.16;       ///< inside radius that air bending leaves, per opening
  std::optional<double> opening = {};    ///< wanted of the V; empty: by thickness
  VChoice v = VChoice::any;
  RadiusWanted radius = RadiusWanted::made;
  std::optional<Forming> large_radii = {};  ///< empty: over a V that leaves them, else by
                                            ///< bumps, else rolled
  std::vector<LargeBend> large = {};        ///< what is known of some of them: as in `Plan`
  double chord_error = 0.2;                 ///< of bumps, from the drawn inside radius
  bool gauge_openings = false;              ///< the gauge's nose may touch within openings
  std::vector<BendId> begin_with = {};      ///< bends that come first, in this order
  StrokeWeights weights;
  StrokeLimits limits;
};

/// Where the sheet touches the back gauge.
struct GaugeStop {
  double distance = 0.0;  ///< from the bend line, mm
  /// The border piece that touches, in the flat pattern; of a formed flange the line above or below
  /// which its outer face stands, in the plane of the lying sheet.
  Segment edge;
  double height = 0.0;                  ///< of the finger's point above the upper skin, mm
  std::optional<FlangeId> flange = {};  ///< formed before, whose outer face touches
  std::optional<BendId> fold = {};      ///< formed before, whose fold touches
  bool in_opening = false;              ///< of the sheet
  bool by_nose = false;                 ///< of the gauge, instead of a finger
  double touched = 0.0;                 ///< along the line, from the first finger to the last, mm
  double line = 0.0;                    ///< from one end of what is pressed to the other, mm

  /// Whether the fingers stand far enough apart to hold the sheet square (math.md#gauging).
  bool is_square() const;
};

/// Segments of a tool that stand side by side.
struct SegmentRow {
  double from = 0.0;             ///< along the bend line, mm, from the end of its first line
  std::vector<double> segments;  ///< in the order in which they stand, mm
  /// By which the body of the first and of the last stands back from its outer end, mm; 0: no ear.
  double left_ear = 0.0, right_ear = 0.0;
};

/// Where it ends, mm.
double end_of(const SegmentRow& row);
/// "left ear 100 + 300 + 50": `length` writes one.
std::string text_of(const SegmentRow& row, const std::function<std::string(double)>& length);

/// Something to know about a plan. Codes: formats.md#remarks.
struct Remark {
  std::string_view code;
  Told told;  ///< one sentence without its full stop; its bends are "B1" to "Bn"
};

/// A hem that is not closed as far as it goes.
struct OpenHem {
  double gap = 0.0;     ///< that stays between its sides, mm
  double height = 0.0;  ///< of the flat punch above the flat die when it stops, mm
};

/// Something done at the press brake at once.
struct Stroke {
  std::vector<BendId> bends;                     ///< pressed together
  std::optional<int> press_line = {};            ///< of a bend with several: which, from 0
  bool flattening = false;                       ///< closes a hem that was bent before
  std::optional<OpenHem> open_hem = {};          ///< if it flattens, where the punch has to stop
  Angle angle;                                   ///< turned by it, without springback
  std::string punch, die;                        ///< ids
  double v_wanted = 0.0;                         ///< opening, mm; 0 if it flattens
  int v_away = 0;                                ///< sizes of the catalogue from the wanted V
  double radius_drawn = 0.0;                     ///< inside, of the whole bend, mm
  double radius_made = 0.0;                      ///< inside, that these tools leave, mm
  std::vector<SegmentRow> punch_rows, die_rows;  ///< as the operator sees them, from the left
  bool reference_up = true;                      ///< the side of the lying sheet that faces up
  std::optional<FlangeId> to_gauge = {};         ///< the flange on the gauge's side of the bend
  Vec2 gauge_direction = Vec2::UnitX();          ///< towards the gauge, in the flat pattern; unit
  std::optional<GaugeStop> gauge = {};           ///< empty: ungauged
  std::optional<Remark> ungauged = {};           ///< why
  double force = 0.0;                            ///< kN
  double clearance = 0.0;                        ///< least left over all turns, mm
  bool on_ears = false;  ///< the workpiece then reaches over the feet of the punch's ears
};

/// Punch and die side by side with others on the bed.
struct Station {
  int set_up = 0;  ///< from 0: those of one set-up stand there together
  std::string punch, die;
  std::vector<SegmentRow> punch_rows = {}, die_rows = {};  ///< `from`: from the left end of the bed
  std::vector<int> strokes = {};                           ///< made there, from 0
};

/// Whether the inside radius of a bend is that of its stroke's tools. Bumps and hems make theirs
/// otherwise.
bool makes_radius(const Stroke& stroke);

/// From which difference on a radius that is made is told besides the drawn one, mm: a tenth of it
/// or 0.2 T.
double told_from(double radius_drawn, double thickness);

/// Whether that of a stroke is.
bool is_made_otherwise(const Stroke& stroke, double thickness);

/// The code of what is said of a bend in the stage that got furthest.
inline constexpr std::string_view kFurthestStage = "furthest_stage";

/// Why no reachable stage can form a bend: what the workpiece hits at best.
struct BlockedBend {
  BendId bend;
  std::optional<ToolName> hits = {};  ///< empty: `why` says it
  std::optional<FlangeId> with = {};  ///< the flange that hits
  double depth = 0.0;                 ///< mm
  std::optional<Angle> at_turn = {};
  std::optional<Remark> why = {};    ///< with what would help if that is known
  double reach = 0.0, needed = 0.0;  ///< of `with`, too short for the die: from the bend line, mm
  bool through = false;              ///< no corner is in the tool: right through it
};

/// A change by which a sheet can be bent that cannot be bent as it is. Each was planned again and
/// has an order.
struct Proposal {
  enum class Kind {
    smaller_v,       ///< another wanted opening: `opening`, `tools` its dies
    punch,           ///< a punch of another catalogue besides, or `ears` for one's own: `tools`
    taller_punches,  ///< `tools`, or all, taller `by`, the upper beam as much higher
    shorter_flange,  ///< the one of `flanges` shorter `by`
    longer_flanges,  ///< each of `flanges` longer `by`
    swap,            ///< the two `bends` swapped in the order that was asked for
    any_order,       ///< without the order that was asked for
    split,           ///< two parts, cut at `bends`, each of which can be bent
    rolled,          ///< `bends`, of large radius, rolled and not bent
    segments,        ///< more segments of `tools`: all lengths of a common set
    lower_ears,      ///< ears of the punches whose foot is only `by` high
    die,             ///< a die of another catalogue besides: `tools`
    short_punch,     ///< the punch may be `by` short of each end of a line
  };
  Kind kind = Kind::smaller_v;
  double opening = 0.0;  ///< mm
  double by = 0.0;       ///< mm
  double height = 0.0;   ///< mm: of the one punch that is taller then
  std::vector<std::string> tools = {};
  bool ears = false;
  std::vector<FlangeId> flanges = {};
  std::vector<BendId> bends = {};
  std::vector<Proposal> also = {};  ///< a second change that it takes besides; it has none itself
};

/// The order in which a sheet is bent, or why there is none.
struct Plan {
  PlanStatus status = PlanStatus::gave_up;
  double cost = 0.0;
  int turn_overs = 0, rotations = 0, tool_changes = 0, ungauged = 0;
  int v_away = 0;                      ///< sizes from the wanted V, of all strokes together
  long long states = 0;                ///< stages that were looked at
  std::vector<Stroke> strokes;         ///< empty unless optimal or feasible
  std::vector<Station> stations = {};  ///< by set-up, from the left
  std::vector<LargeBend> large = {};
  std::vector<BlockedBend> blocked;  ///< if infeasible
  std::vector<BendId> unformed;      ///< if infeasible: what is left in the stage that got furthest
  /// If each bend can be formed in some stage: what is in the way of some of the unformed there.
  std::vector<BlockedBend> in_the_way;
  std::vector<Proposal> proposals;  ///< if infeasible, and looked for (proposals.hpp)
  /// Bends that take no stroke, radii beyond what the V gives, and for each of `in_the_way` one
  /// with the code `kFurthestStage`.
  std::vector<Remark> remarks;
};

/// Whether there is an order of strokes.
bool has_order(const Plan& plan);

/// Whether no stroke is needed since all that is bent is rolled.
bool only_rolls(const Plan& plan);

/// Finds the cheapest order of strokes (math.md#press-brake). `layout` is that of the sheet, whose
/// pattern `Stroke` refers to. Errors: `bad_tools`, `no_straight_bend` (nothing that a brake could
/// press), `no_tool` (thickness, radius or hem that no tool bears), `bad_option` (also
/// `gauge_openings` without a nose), `cancelled`.
Result<Plan> plan_bending(const Sheet& sheet, const Layout& layout, const BrakeTools& tools,
                          const PlanOptions& options = {}, const Progress& progress = {});

}  // namespace planish
