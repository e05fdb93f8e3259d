#include "align.hpp"
#include "checks.hpp"
#include "contacts.hpp"
#include "design_load.hpp"
#include "equilibrium.hpp"
#include "part_together.hpp"
#include "refusals.hpp"
#include "settle_joined.hpp"
#include "snapshot.hpp"
#include "strip_work.hpp"

#include <planish/base/assert.hpp>
#include <planish/slit/session.hpp>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// A design under edit. A change makes a new snapshot, in which strips that it affects are open, and
// replaces the old one only if all went well, so a refused change leaves the session as it was.
// Solving works on open strips alone, from their present shape, then parts neighbours that cross; a
// sheet can be shown once each strip has a shape that ends where it must, so late ones get one.
// Subdividing puts a ridge without a fold into each quad, which leaves the shape unchanged
// (math.md#subdivision).

namespace planish {

using namespace slit_detail;

struct SlitSession::Content {
  Snapshot now;
};

namespace {

using Clock = std::chrono::steady_clock;

void take_scan(Snapshot& next, int strip, std::vector<Vec3> points) {
  Slot slot = next.slot(strip);
  slot.scan = scan_of(std::move(points));
  slot.state.status = StripStatus::open;
  next.slots[strip] = std::make_shared<const Slot>(std::move(slot));
}

/// Renumbers the anchors of a design with fewer ridges, if halving its quads gives this number.
void number_as_subdivided(SlitDesign& design, int ridges) {
  if (design.ridges < 1) return;
  for (int finer = design.ridges; finer <= ridges; finer *= 2) {
    if (finer != ridges) continue;
    for (SlitAnchor& anchor : design.anchors)
      anchor.ridge *= ridges / design.ridges;
    design.ridges = ridges;
    return;
  }
}

/// Whether the anchors of a strip are the same, in order.
bool same_anchors(const SlitDesign& a, const SlitDesign& b, int strip) {
  const auto of_strip = [&](const SlitDesign& design) {
    std::vector<SlitAnchor> anchors;
    std::copy_if(design.anchors.begin(), design.anchors.end(), std::back_inserter(anchors),
                 [&](const SlitAnchor& anchor) { return anchor.strip == strip; });
    return anchors;
  };
  return of_strip(a) == of_strip(b);
}

void take_panels(Snapshot& now, Panels panels) {
  now.panel = std::make_shared<const std::vector<PanelFacet>>(std::move(panels.first));
  if (now.placed) return;
  now.second_panel = std::make_shared<const std::vector<PanelFacet>>(std::move(panels.second));
}

bool is_joined(const Snapshot& now, int strip) {
  return std::ranges::any_of(
      now.joined, [&](const JoinedEnds& run) { return run.first <= strip && strip <= run.last; });
}

/// The strips of a run if any of them is open.
std::vector<int> open_run(const Snapshot& now, std::size_t run) {
  std::vector<int> strips;
  bool any = false;
  for (int strip = now.joined[run].first; strip <= now.joined[run].last; ++strip) {
    strips.push_back(strip);
    any = any || now.slot(strip).state.status == StripStatus::open;
  }
  return any ? strips : std::vector<int>();
}

/// Solves runs of joined strips that are open, and adds them to those that moved. Returns the
/// iterations taken.
int solve_joined(Snapshot& now, const DescentOptions& options, std::vector<int>& moved) {
  int iterations = 0;
  for (std::size_t run = 0; run < now.joined.size(); ++run) {
    const auto strips = open_run(now, run);
    if (strips.empty() || options.stop()) continue;
    iterations += settle_joined(now, run, options);
    moved.insert(moved.end(), strips.begin(), strips.end());
  }
  return iterations;
}

/// A snapshot with another design of the same sheet; the strips that it affects are open.
Result<Snapshot> with_design(const Snapshot& now, SlitDesign design) {
  Snapshot next = now;
  design.ends.resize(design.sheet.strips.size());
  bool all = design.weights != now.design->weights || design.end_angle != now.design->end_angle ||
             design.objective != now.design->objective || design.coupling != now.design->coupling ||
             design.ground != now.design->ground || !same_load(design, *now.design);
  auto panels = checked_panels(design);
  if (!panels) return pass_on(panels);
  if (auto sound = check_all(design, *panels); !sound) return pass_on(sound);
  if (design.leg_curve != now.design->leg_curve || design.lean != now.design->lean ||
      design.second_panel != now.design->second_panel) {
    take_panels(next, std::move(*panels));
    all = true;
  }
  if (design.seat_curve != now.design->seat_curve) {
    take_seat_curve(next, design);
    all = true;
  }
  for (int strip = 0; strip < next.count(); ++strip) {
    const bool end_moved = design.ends[strip] != now.design->ends[strip];
    if (all || end_moved || !same_anchors(design, *now.design, strip)) reopen(next, strip);
  }
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  return next;
}

}  // namespace

SlitSession::SlitSession(std::unique_ptr<Content> content) : content_(std::move(content)) {}
SlitSession::SlitSession(SlitSession&&) noexcept = default;
SlitSession& SlitSession::operator=(SlitSession&&) noexcept = default;
SlitSession::~SlitSession() = default;

Result<SlitSession> SlitSession::start(SlitDesign design) {
  if (auto sound = check_sheet(design); !sound) return pass_on(sound);
  auto sized = with_fitted_curves(std::move(design));
  if (!sized) return pass_on(sized);
  design = std::move(*sized);
  auto panels = checked_panels(design);
  if (!panels) return pass_on(panels);
  if (auto sound = check_all(design, *panels); !sound) return pass_on(sound);
  auto content = std::make_unique<Content>();
  auto points = points_by_strip(design);
  if (!points) return pass_on(points);
  design.scans.clear();
  design.ends.resize(design.sheet.strips.size());
  for (auto& cloud : *points)
    content->now.slots.push_back(
        std::make_shared<const Slot>(Slot{{}, {}, scan_of(std::move(cloud)), {}, {}}));
  take_seat_curve(content->now, design);
  take_panels(content->now, std::move(*panels));
  if (!design.second_panel)
    for (const auto& [first, last] : joined_strips(design.sheet))
      content->now.joined.push_back({first, last, {}, std::vector<double>(last - first)});
  content->now.design = std::make_shared<const SlitDesign>(std::move(design));
  return SlitSession(std::move(content));
}

Result<void> SlitSession::set_design(SlitDesign design) {
  const Snapshot& now = content_->now;
  number_as_subdivided(design, now.design->ridges);
  if (design.sheet != now.design->sheet || design.ridges != now.design->ridges) {
    auto begun = start(std::move(design));
    if (!begun) return pass_on(begun);
    content_->now = std::move(begun->content_->now);
    return {};
  }
  if (auto sound = check_sheet(design); !sound) return sound;
  auto sized = with_fitted_curves(std::move(design));
  if (!sized) return pass_on(sized);
  design = std::move(*sized);
  const auto scans = points_by_strip(design);
  if (!scans) return pass_on(scans);
  design.scans.clear();
  auto next = with_design(now, std::move(design));
  if (!next) return pass_on(next);
  for (int strip = 0; strip < now.count(); ++strip)
    if (const auto& points = (*scans)[strip]; points != scan(strip))
      take_scan(*next, strip, points);
  content_->now = std::move(*next);
  return {};
}

Result<Eigen::Isometry3d> SlitSession::align_scans() {
  Snapshot next = content_->now;
  std::vector<ScannedStrip> scans;
  for (int strip = 0; strip < next.count(); ++strip)
    if (const auto& scan = next.slot(strip).scan)
      scans.push_back({scan->points(), folded_of(next, strip)});
  if (scans.empty()) return fail(refuse::no_scan, {{"field", place::pointer("/scan")}});
  const Eigen::Isometry3d motion = aligning_motion(scans);
  for (int strip = 0; strip < next.count(); ++strip) {
    if (!next.slot(strip).scan) continue;
    std::vector<Vec3> moved = next.slot(strip).scan->points();
    for (Vec3& p : moved)
      p = motion * p;
    take_scan(next, strip, std::move(moved));
  }
  content_->now = std::move(next);
  return motion;
}

void SlitSession::subdivide() {
  Snapshot next = content_->now;
  for (int strip = 0; strip < next.count(); ++strip) {
    Slot slot = next.slot(strip);
    if (slot.p.size()) slot.p = subdivided(base_of(content_->now, strip), slot.p);
    slot.inequalities.clear();
    slot.undivided = slot.state.objective;
    slot.state.status = StripStatus::open;
    next.slots[strip] = std::make_shared<const Slot>(std::move(slot));
  }
  next.pressing.contacts = subdivided(next.pressing.contacts);
  SlitDesign design = *next.design;
  design.ridges *= 2;
  for (SlitAnchor& anchor : design.anchors)
    anchor.ridge *= 2;
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  content_->now = std::move(next);
}

Result<SlitSolveReport> SlitSession::solve(const SlitSolveOptions& options,
                                           const Progress& progress) {
  const auto began = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
  bool cancelled = false;
  const DescentOptions descent{options.max_iterations, options.function_tolerance, [&] {
                                 cancelled = cancelled || progress.should_stop();
                                 return cancelled || elapsed() >= options.seconds;
                               }};
  Snapshot& now = content_->now;
  SlitSolveReport report;
  const bool by_energy = now.design->objective == SlitObjective::energy;
  std::vector<int> moved, begun;
  report.iterations += solve_joined(now, descent, moved);
  for (int strip = 0; strip < now.count(); ++strip) {
    if (now.slot(strip).state.status != StripStatus::open || is_joined(now, strip)) continue;
    const bool late = descent.stop();
    if (cancelled) break;
    if (late && now.slot(strip).p.size() == 0) work_on(now, strip, Clear::of_mirror, descent);
    if (late) continue;
    progress.at("strips", static_cast<double>(strip) / now.count());
    if (now.slot(strip).p.size() == 0) begun.push_back(strip);
    if (!by_energy || !goes_on(now, strip))
      report.iterations += work_on(now, strip, Clear::of_mirror, descent).iterations;
    moved.push_back(strip);
  }
  if (by_energy) report.iterations += improve_from_neighbours(now, begun, descent);
  note_crossings(now, moved);
  const int iterations = (by_energy ? part_together : part_neighbours)(now, moved, descent);
  report.iterations += iterations;
  if (iterations > 0) note_crossings(now, moved);
  report.strips_solved = static_cast<int>(moved.size());
  if (cancelled) return fail(refuse::cancelled);
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

FoldedSlitSheet SlitSession::folded() const { return folded_sheet(content_->now); }

std::optional<SlitEquilibrium> SlitSession::equilibrium() const {
  return equilibrium_of(content_->now);
}

Result<SlitSession> solved_slit_sheet(SlitDesign design, int subdivisions,
                                      const SlitSolveOptions& options, const Progress& progress) {
  if (subdivisions < 0 || subdivisions > kMostSubdivisions)
    return fail(refuse::bad_slit_option,
                {{"name", "subdivisions"},
                 {"value", subdivisions},
                 {"range", "a number from 0 to " + std::to_string(kMostSubdivisions)}});
  auto session = SlitSession::start(std::move(design));
  if (!session) return session;
  for (int level = 0; level <= subdivisions; ++level) {
    if (level > 0) session->subdivide();
    if (auto report = session->solve(options, progress); !report) return pass_on(report);
  }
  return session;
}

}  // namespace planish
