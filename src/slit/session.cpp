#include "align.hpp"
#include "checks.hpp"
#include "crossing.hpp"
#include "strip_solver.hpp"

#include <planish/base/assert.hpp>
#include <planish/slit/session.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <utility>

namespace planish {
namespace {

using namespace slit_detail;
using Clock = std::chrono::steady_clock;

/// A strip between two edits. Never changed once it is in a snapshot.
struct Slot {
  StripParameters p;  ///< empty until it is solved for the first time
  std::vector<Inequality> inequalities;
  std::shared_ptr<const NearestPoints> scan;
  StripState state;
};

/// Everything that undo brings back. Copies share what is large.
struct Snapshot {
  std::shared_ptr<const SlitDesign> design;
  std::shared_ptr<const std::vector<PanelFacet>> panel;
  std::shared_ptr<const BezierSearch> seat;
  std::shared_ptr<const std::vector<Vec2>> seat_places;  ///< left and right of each strip
  std::vector<std::shared_ptr<const Slot>> slots;

  const Slot& slot(int strip) const { return *slots[static_cast<std::size_t>(strip)]; }
  int count() const { return static_cast<int>(slots.size()); }
};

StripBase base_of(const Snapshot& now, int strip) {
  const SlitSheet& sheet = now.design->sheet;
  const auto facet = std::find_if(now.panel->begin(), now.panel->end(), [&](const PanelFacet& f) { return f.strip == strip; });
  return {facet->frame, {facet->corners[0].y(), facet->corners[3].y()}, sheet.start_of(strip), sheet.end_of(strip), now.design->ridges};
}

/// The strips side by side on the curve, evenly apart from its start to its end; one alone in its middle.
std::vector<Vec2> places_along(const BezierCurve& curve, const SlitSheet& sheet) {
  double rest = length(curve);
  for (const SlitStrip& strip : sheet.strips)
    rest -= strip.width;
  const std::size_t count = sheet.strips.size();
  const double apart = count > 1 ? rest / static_cast<double>(count - 1) : 0.0;
  std::vector<double> lengths;
  double at = count > 1 ? 0.0 : 0.5 * rest;
  for (const SlitStrip& strip : sheet.strips) {
    lengths.push_back(at);
    lengths.push_back(at + strip.width);
    at += strip.width + apart;
  }
  return points_at_lengths(curve, lengths);
}

void take_seat_curve(Snapshot& now, const SlitDesign& design) {
  now.seat = design.seat_curve ? std::make_shared<const BezierSearch>(*design.seat_curve) : nullptr;
  now.seat_places = design.seat_curve ? std::make_shared<const std::vector<Vec2>>(places_along(*design.seat_curve, design.sheet)) : nullptr;
}

/// Sign of x on the modelled half.
double half_sign(const Snapshot& now) { return now.panel->front().frame.point(now.panel->front().corners[0]).x() < 0.0 ? -1.0 : 1.0; }

std::vector<EndCondition> at_symmetry_plane(EndAngle angle) {
  using Of = EndCondition::Of;
  std::vector<EndCondition> ends{{Of::left_end, Vec3::UnitX(), 0.0}, {Of::right_end, Vec3::UnitX(), 0.0}};
  if (angle == EndAngle::right_angle) ends.push_back({Of::normal, Vec3::UnitX(), 0.0});
  if (angle == EndAngle::level) ends.push_back({Of::along, Vec3::UnitY(), 0.0});
  return ends;
}

/// Two directions with `direction` that are a right-handed system.
std::array<Vec3, 2> perpendiculars(const Vec3& direction) {
  const Frame frame = frame_from_normal(Vec3::Zero(), direction.normalized());
  return {frame.x, frame.y};
}

std::vector<EndCondition> at_free_end(const StripEnd& end) {
  using Of = EndCondition::Of;
  std::vector<EndCondition> ends;
  if (end.position)
    for (int axis = 0; axis < 3; ++axis)
      ends.push_back({Of::middle, Vec3::Unit(axis), (*end.position)[axis]});
  if (end.direction)
    for (const Vec3& across : perpendiculars(*end.direction))
      ends.push_back({Of::along, across, 0.0});
  if (end.across && end.direction) ends.push_back({Of::across, end.direction->cross(*end.across).normalized(), 0.0});
  if (end.across && !end.direction)
    for (const Vec3& across : perpendiculars(*end.across))
      ends.push_back({Of::across, across, 0.0});
  return ends;
}

StripProblem problem_of(const Snapshot& now, int strip) {
  const SlitDesign& design = *now.design;
  StripProblem problem;
  problem.base = base_of(now, strip);
  problem.ends = design.sheet.symmetric ? at_symmetry_plane(design.end_angle) : at_free_end(design.ends[static_cast<std::size_t>(strip)]);
  problem.mirrored = design.sheet.symmetric && design.end_angle == EndAngle::right_angle;
  problem.weights = design.weights;
  for (const SlitAnchor& anchor : design.anchors)
    if (anchor.strip == strip) problem.anchors.push_back({anchor.ridge, anchor.side == Side::left ? 0 : 1, anchor.at});
  if (design.sheet.symmetric && now.seat) {
    problem.seat = now.seat;
    problem.seat_places = {(*now.seat_places)[2 * static_cast<std::size_t>(strip)], (*now.seat_places)[2 * static_cast<std::size_t>(strip) + 1]};
  }
  problem.scan = now.slot(strip).scan;
  problem.min_radius = design.sheet.min_radius();
  problem.inequalities = now.slot(strip).inequalities;
  return problem;
}

const StripParameters& parameters_of(const Snapshot& now, int strip, StripParameters& room) {
  const Slot& slot = now.slot(strip);
  if (slot.p.size()) return slot.p;
  room = flat_parameters(base_of(now, strip));
  return room;
}

FoldedStrip folded_of(const Snapshot& now, int strip) {
  StripParameters room;
  return folded_strip(base_of(now, strip), parameters_of(now, strip, room));
}

void reopen(Snapshot& now, int strip) {
  Slot slot = now.slot(strip);
  slot.state.status = StripStatus::open;
  now.slots[static_cast<std::size_t>(strip)] = std::make_shared<const Slot>(std::move(slot));
}

void reopen_all(Snapshot& now) {
  for (int strip = 0; strip < now.count(); ++strip)
    reopen(now, strip);
}

/// Ends that point the wrong way meet their condition as well as those that point the right way.
bool ends_backwards(const StripEnd& end, const FoldedStrip& strip) {
  const Frame& last = strip.quads.back();
  return (end.direction && end.direction->dot(last.x) < 0.0) || (end.across && end.across->dot(last.y) < 0.0);
}

/// What is reported of a strip, measured on its shape.
StripState measured(const Snapshot& now, int strip, const StripProblem& problem, const StripSolution& solution) {
  const FoldedStrip shape = folded_strip(problem.base, solution.p);
  const StripFold fold = folded(problem.base, solution.p);
  StripState state;
  state.gap = end_gap(problem, fold);
  const bool backwards = !now.design->sheet.symmetric && ends_backwards(now.design->ends[static_cast<std::size_t>(strip)], shape);
  state.status = !solution.reached || backwards ? StripStatus::out_of_reach : solution.converged ? StripStatus::solved : StripStatus::open;
  if (!solution.reached) state.shortfall = state.gap;
  const Tightest tightest = tightest_fold(problem.base, solution.p);
  state.min_radius = tightest.radius;
  state.tightest_ridge = tightest.ridge;
  constexpr double kRounding = 1e-6;
  state.too_tight = tightest.radius < problem.min_radius * (1.0 - kRounding);
  if (now.design->sheet.symmetric) state.crosses_plane = depth_behind_mirror(shape, half_sign(now)) > kRounding * problem.base.unit();
  state.objective = solution.objective;
  if (problem.seat)
    for (const Vec3& end : shape.ridges.back().folded)
      state.seat_distance = std::max(state.seat_distance, (problem.seat->nearest(end.tail<2>()).point - end.tail<2>()).norm());
  for (const StripAnchor& anchor : problem.anchors)
    state.anchor_distance = std::max(state.anchor_distance, (fold.end(anchor.side, anchor.ridge) - anchor.at).norm());
  if (problem.scan) {
    double sum = 0.0;
    for (int ridge = 1; ridge <= problem.base.quads; ++ridge)
      for (int side = 0; side < 2; ++side)
        sum += (problem.scan->nearest(fold.end(side, ridge)) - fold.end(side, ridge)).squaredNorm();
    state.scan_distance = std::sqrt(sum / (2.0 * problem.base.quads));
  }
  state.iterations = solution.iterations;
  return state;
}

bool stands(const Snapshot& now, int strip) {
  return strip >= 0 && strip < now.count() && now.slot(strip).p.size() && now.slot(strip).state.status != StripStatus::open;
}

/// What the strip must keep clear of: its mirror image, and neighbours that stand.
PlanesBroken clear_of(const Snapshot& now, int strip) {
  std::vector<std::pair<Side, FoldedStrip>> neighbours;
  if (stands(now, strip - 1)) neighbours.emplace_back(Side::left, folded_of(now, strip - 1));
  if (stands(now, strip + 1)) neighbours.emplace_back(Side::right, folded_of(now, strip + 1));
  const bool symmetric = now.design->sheet.symmetric;
  const double sign = half_sign(now);
  return [neighbours = std::move(neighbours), symmetric, sign](const FoldedStrip& shape) {
    std::vector<HalfSpace> planes;
    constexpr double kThrough = 1e-7;
    if (symmetric && depth_behind_mirror(shape, sign) > kThrough * (shape.ridges.back().flat[0].x() - shape.ridges.front().flat[0].x()))
      planes = planes_before_mirror(static_cast<int>(shape.quads.size()), sign);
    for (const auto& [side, neighbour] : neighbours)
      if (cross(shape, neighbour)) {
        const auto beside = planes_beside(shape, neighbour, side);
        planes.insert(planes.end(), beside.begin(), beside.end());
      }
    return planes;
  };
}

/// Solves one strip of a snapshot.
StripSolution work_on(Snapshot& now, int strip, const DescentOptions& options) {
  const StripProblem problem = problem_of(now, strip);
  StripSolution solution = solve_strip(problem, now.slot(strip).p, options, clear_of(now, strip));
  Slot slot = now.slot(strip);
  slot.p = solution.p;
  slot.state = measured(now, strip, problem, solution);
  slot.inequalities = solution.inequalities;
  std::erase_if(slot.inequalities, [](const Inequality& known) { return std::holds_alternative<HalfSpace>(known.what); });
  now.slots[static_cast<std::size_t>(strip)] = std::make_shared<const Slot>(std::move(slot));
  return solution;
}

void note_crossing(Snapshot& now, int strip) {
  if (strip < 0 || strip + 1 >= now.count()) return;
  const bool crosses = cross(folded_of(now, strip), folded_of(now, strip + 1));
  if (crosses == now.slot(strip).state.crosses_next) return;
  Slot slot = now.slot(strip);
  slot.state.crosses_next = crosses;
  now.slots[static_cast<std::size_t>(strip)] = std::make_shared<const Slot>(std::move(slot));
}

/// Every quad of the strip divided in its middle by a ridge that does not fold (MATH 6.4).
StripParameters subdivided(const StripBase& base, const StripParameters& p) {
  const int quads = 2 * base.quads;
  StripParameters fine = StripParameters::Zero(parameter_count(quads));
  for (int ridge = 0; ridge < base.quads; ++ridge)
    fine[2 * ridge] = p[ridge];
  for (int ridge = 1; ridge < quads; ++ridge)
    for (int side = 0; side < 2; ++side)
      fine[abscissa_index(quads, ridge, side)] =
          0.5 * (abscissa(base, p, ridge / 2, side) + abscissa(base, p, (ridge + 1) / 2, side)) / base.unit();
  return fine;
}

std::shared_ptr<const NearestPoints> scan_of(std::vector<Vec3> points) {
  return points.empty() ? nullptr : std::make_shared<const NearestPoints>(std::move(points));
}

/// Points of a strip's surface, close enough together to align scans with.
void add_surface_points(const FoldedStrip& strip, std::vector<Vec3>& points) {
  constexpr int kAlong = 8, kAcross = 8;
  for (std::size_t quad = 0; quad < strip.quads.size(); ++quad)
    for (int i = 0; i < kAlong; ++i)
      for (int j = 0; j <= kAcross; ++j) {
        const double s = static_cast<double>(i) / kAlong, r = static_cast<double>(j) / kAcross;
        const auto on = [&](const SlitRidge& ridge) -> Vec3 { return (1.0 - r) * ridge.folded[0] + r * ridge.folded[1]; };
        points.push_back((1.0 - s) * on(strip.ridges[quad]) + s * on(strip.ridges[quad + 1]));
      }
}

Result<void> check_all(const SlitDesign& design, const std::vector<PanelFacet>& panel) {
  if (auto sound = check_seat_curve(design); !sound) return sound;
  if (auto sound = check_weights(design.weights); !sound) return sound;
  for (int i = 0; i < static_cast<int>(design.anchors.size()); ++i)
    if (auto sound = check_anchor(design, panel, i); !sound) return sound;
  for (int i = 0; i < static_cast<int>(design.ends.size()); ++i)
    if (auto sound = check_end(design, panel, i); !sound) return sound;
  for (int i = 0; i < static_cast<int>(design.scans.size()); ++i) {
    const SlitScan& scan = design.scans[static_cast<std::size_t>(i)];
    if (auto sound = check_scan(design, scan.strip, scan.points, i); !sound) return sound;
    if (scan.points.empty())
      return fail(ErrorCode::empty_scan, fmt::format("the scan of strip {} has no points", scan.strip), fmt::format("/scan/{}/points", i));
  }
  return {};
}

}  // namespace

struct SlitSession::Content {
  Snapshot now;
  std::vector<Snapshot> before, after;

  /// Makes an edited copy current and remembers the last.
  void commit(Snapshot next) {
    before.push_back(std::move(now));
    after.clear();
    now = std::move(next);
  }
};

SlitSession::SlitSession(std::unique_ptr<Content> content) : content_(std::move(content)) {}
SlitSession::SlitSession(SlitSession&&) noexcept = default;
SlitSession& SlitSession::operator=(SlitSession&&) noexcept = default;
SlitSession::~SlitSession() = default;

Result<SlitSession> SlitSession::start(SlitDesign design) {
  if (auto sound = check_sheet(design); !sound) return tl::unexpected(sound.error());
  auto panel = checked_panel(design);
  if (!panel) return tl::unexpected(panel.error());
  if (auto sound = check_all(design, *panel); !sound) return tl::unexpected(sound.error());
  auto content = std::make_unique<Content>();
  const std::size_t count = design.sheet.strips.size();
  std::vector<std::vector<Vec3>> points(count);
  for (SlitScan& scan : design.scans) {
    auto& all = points[static_cast<std::size_t>(scan.strip)];
    all.insert(all.end(), scan.points.begin(), scan.points.end());
  }
  design.scans.clear();
  design.ends.resize(count);
  for (auto& cloud : points)
    content->now.slots.push_back(std::make_shared<const Slot>(Slot{{}, {}, scan_of(std::move(cloud)), {}}));
  take_seat_curve(content->now, design);
  content->now.panel = std::make_shared<const std::vector<PanelFacet>>(std::move(*panel));
  content->now.design = std::make_shared<const SlitDesign>(std::move(design));
  return SlitSession(std::move(content));
}

Result<void> SlitSession::set_leg_curve(BezierCurve curve) {
  Snapshot next = content_->now;
  SlitDesign design = *next.design;
  design.leg_curve = std::move(curve);
  auto panel = checked_panel(design);
  if (!panel) return tl::unexpected(panel.error());
  if (auto sound = check_all(design, *panel); !sound) return sound;
  next.panel = std::make_shared<const std::vector<PanelFacet>>(std::move(*panel));
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  reopen_all(next);
  content_->commit(std::move(next));
  return {};
}

Result<void> SlitSession::set_seat_curve(std::optional<BezierCurve> curve) {
  Snapshot next = content_->now;
  SlitDesign design = *next.design;
  design.seat_curve = std::move(curve);
  if (auto sound = check_seat_curve(design); !sound) return sound;
  take_seat_curve(next, design);
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  reopen_all(next);
  content_->commit(std::move(next));
  return {};
}

Result<void> SlitSession::set_weights(const SlitWeights& weights) {
  if (auto sound = check_weights(weights); !sound) return sound;
  Snapshot next = content_->now;
  SlitDesign design = *next.design;
  design.weights = weights;
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  reopen_all(next);
  content_->commit(std::move(next));
  return {};
}

Result<void> SlitSession::set_end_angle(EndAngle angle) {
  Snapshot next = content_->now;
  SlitDesign design = *next.design;
  design.end_angle = angle;
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  reopen_all(next);
  content_->commit(std::move(next));
  return {};
}

Result<void> SlitSession::set_end(int strip, const StripEnd& end) {
  if (strip < 0 || strip >= strip_count())
    return fail(ErrorCode::unknown_strip, fmt::format("there is no strip {}; the sheet has strips 0 to {}", strip, strip_count() - 1), fmt::format("/ends/{}", strip));
  Snapshot next = content_->now;
  SlitDesign design = *next.design;
  design.ends[static_cast<std::size_t>(strip)] = end;
  if (auto sound = check_end(design, *next.panel, strip); !sound) return sound;
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  reopen(next, strip);
  content_->commit(std::move(next));
  return {};
}

Result<void> SlitSession::add_anchor(const SlitAnchor& anchor) {
  Snapshot next = content_->now;
  SlitDesign design = *next.design;
  design.anchors.push_back(anchor);
  if (auto sound = check_anchor(design, *next.panel, static_cast<int>(design.anchors.size()) - 1); !sound) return sound;
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  reopen(next, anchor.strip);
  content_->commit(std::move(next));
  return {};
}

namespace {

Result<void> check_anchor_number(const SlitDesign& design, int anchor) {
  if (anchor >= 0 && anchor < static_cast<int>(design.anchors.size())) return {};
  return fail(ErrorCode::bad_option, fmt::format("there is no anchor {}; there are {}", anchor, design.anchors.size()), fmt::format("/anchors/{}", anchor));
}

}  // namespace

Result<void> SlitSession::move_anchor(int anchor, const Vec3& at) {
  if (auto sound = check_anchor_number(design(), anchor); !sound) return sound;
  Snapshot next = content_->now;
  SlitDesign design = *next.design;
  SlitAnchor& moved = design.anchors[static_cast<std::size_t>(anchor)];
  moved.at = at;
  if (auto sound = check_anchor(design, *next.panel, anchor); !sound) return sound;
  reopen(next, moved.strip);
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  content_->commit(std::move(next));
  return {};
}

Result<void> SlitSession::remove_anchor(int anchor) {
  if (auto sound = check_anchor_number(design(), anchor); !sound) return sound;
  Snapshot next = content_->now;
  SlitDesign design = *next.design;
  reopen(next, design.anchors[static_cast<std::size_t>(anchor)].strip);
  design.anchors.erase(design.anchors.begin() + anchor);
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  content_->commit(std::move(next));
  return {};
}

Result<void> SlitSession::set_scan(int strip, std::vector<Vec3> points) {
  if (auto sound = check_scan(design(), strip, points, strip); !sound) return sound;
  Snapshot next = content_->now;
  Slot slot = next.slot(strip);
  slot.scan = scan_of(std::move(points));
  slot.state.status = StripStatus::open;
  next.slots[static_cast<std::size_t>(strip)] = std::make_shared<const Slot>(std::move(slot));
  content_->commit(std::move(next));
  return {};
}

Result<Eigen::Isometry3d> SlitSession::align_scans() {
  Snapshot next = content_->now;
  std::vector<Vec3> surface, points;
  for (int strip = 0; strip < next.count(); ++strip) {
    const auto& scan = next.slot(strip).scan;
    if (!scan) continue;
    add_surface_points(folded_of(next, strip), surface);
    points.insert(points.end(), scan->points().begin(), scan->points().end());
  }
  if (points.empty()) return fail(ErrorCode::empty_scan, "there is no scan to align", "/scan");
  const Eigen::Isometry3d motion = aligning_motion(points, NearestPoints(std::move(surface)));
  for (auto& known : next.slots) {
    if (!known->scan) continue;
    Slot slot = *known;
    std::vector<Vec3> moved = known->scan->points();
    for (Vec3& p : moved)
      p = motion * p;
    slot.scan = scan_of(std::move(moved));
    slot.state.status = StripStatus::open;
    known = std::make_shared<const Slot>(std::move(slot));
  }
  content_->commit(std::move(next));
  return motion;
}

void SlitSession::subdivide() {
  Snapshot next = content_->now;
  for (int strip = 0; strip < next.count(); ++strip) {
    Slot slot = next.slot(strip);
    if (slot.p.size()) slot.p = subdivided(base_of(content_->now, strip), slot.p);
    slot.inequalities.clear();
    slot.state.status = StripStatus::open;
    next.slots[static_cast<std::size_t>(strip)] = std::make_shared<const Slot>(std::move(slot));
  }
  SlitDesign design = *next.design;
  design.ridges *= 2;
  for (SlitAnchor& anchor : design.anchors)
    anchor.ridge *= 2;
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  content_->commit(std::move(next));
}

bool SlitSession::can_undo() const { return !content_->before.empty(); }
bool SlitSession::can_redo() const { return !content_->after.empty(); }

void SlitSession::undo() {
  if (!can_undo()) return;
  content_->after.push_back(std::move(content_->now));
  content_->now = std::move(content_->before.back());
  content_->before.pop_back();
}

void SlitSession::redo() {
  if (!can_redo()) return;
  content_->before.push_back(std::move(content_->now));
  content_->now = std::move(content_->after.back());
  content_->after.pop_back();
}

Result<SlitSolveReport> SlitSession::solve(const SlitSolveOptions& options, const Progress& progress) {
  const auto began = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
  bool cancelled = false;
  const DescentOptions descent{options.max_iterations, options.function_tolerance, [&] {
                                 cancelled = cancelled || progress.should_stop();
                                 return cancelled || elapsed() >= options.seconds;
                               }};
  Snapshot& now = content_->now;
  SlitSolveReport report;
  for (int strip = 0; strip < now.count(); ++strip) {
    if (now.slot(strip).state.status != StripStatus::open) continue;
    if (descent.stop()) break;
    progress.at("strips", static_cast<double>(strip) / now.count());
    report.iterations += work_on(now, strip, descent).iterations;
    ++report.strips_solved;
    note_crossing(now, strip - 1);
    note_crossing(now, strip);
  }
  if (cancelled) return fail(ErrorCode::cancelled, "solving the slit sheet was cancelled");
  for (const auto& slot : now.slots) {
    report.converged = report.converged && slot->state.status != StripStatus::open;
    report.gap = std::max(report.gap, slot->state.gap);
  }
  report.seconds = elapsed();
  return report;
}

const SlitDesign& SlitSession::design() const { return *content_->now.design; }
int SlitSession::strip_count() const { return content_->now.count(); }

const std::vector<Vec3>& SlitSession::scan(int strip) const {
  static const std::vector<Vec3> none;
  PLANISH_ASSERT(strip >= 0 && strip < strip_count());
  const auto& scan = content_->now.slot(strip).scan;
  return scan ? scan->points() : none;
}

const StripState& SlitSession::state(int strip) const {
  PLANISH_ASSERT(strip >= 0 && strip < strip_count());
  return content_->now.slot(strip).state;
}

FoldedSlitSheet SlitSession::folded() const {
  const Snapshot& now = content_->now;
  FoldedSlitSheet sheet{now.design->sheet.thickness, now.design->sheet.reach(), now.design->sheet.symmetric, *now.panel, {}};
  for (int strip = 0; strip < now.count(); ++strip)
    sheet.strips.push_back(folded_of(now, strip));
  return sheet;
}

Result<SlitSession> solved_slit_sheet(SlitDesign design, int subdivisions, const SlitSolveOptions& options, const Progress& progress) {
  auto session = SlitSession::start(std::move(design));
  if (!session) return session;
  for (int level = 0; level <= subdivisions; ++level) {
    if (level > 0) session->subdivide();
    if (auto report = session->solve(options, progress); !report) return tl::unexpected(report.error());
  }
  return session;
}

}  // namespace planish
