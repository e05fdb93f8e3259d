#include "checks.hpp"
#include "session_content.hpp"
#include "strip_work.hpp"

#include <planish/base/assert.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <utility>

namespace planish {

using namespace slit_detail;
namespace {
using Clock = std::chrono::steady_clock;
}

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
  auto points = points_by_strip(design);
  if (!points) return tl::unexpected(points.error());
  design.scans.clear();
  design.ends.resize(design.sheet.strips.size());
  for (auto& cloud : *points)
    content->now.slots.push_back(
        std::make_shared<const Slot>(Slot{{}, {}, scan_of(std::move(cloud)), {}, {}}));
  take_seat_curve(content->now, design);
  content->now.panel = std::make_shared<const std::vector<PanelFacet>>(std::move(*panel));
  content->now.design = std::make_shared<const SlitDesign>(std::move(design));
  return SlitSession(std::move(content));
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

void SlitSession::forget_edits() {
  content_->before.clear();
  content_->after.clear();
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
  std::vector<int> moved;
  for (int strip = 0; strip < now.count(); ++strip) {
    if (now.slot(strip).state.status != StripStatus::open) continue;
    if (descent.stop()) break;
    progress.at("strips", static_cast<double>(strip) / now.count());
    report.iterations += work_on(now, strip, Clear::of_mirror, descent).iterations;
    moved.push_back(strip);
  }
  note_crossings(now, moved);
  if (const int iterations = part_neighbours(now, moved, descent); iterations > 0) {
    report.iterations += iterations;
    note_crossings(now, moved);
  }
  report.strips_solved = static_cast<int>(moved.size());
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
  FoldedSlitSheet sheet{now.design->sheet.thickness,
                        now.design->sheet.reach(),
                        now.design->sheet.symmetric,
                        *now.panel,
                        {}};
  for (int strip = 0; strip < now.count(); ++strip)
    sheet.strips.push_back(folded_of(now, strip));
  return sheet;
}

Result<SlitSession> solved_slit_sheet(SlitDesign design, int subdivisions,
                                      const SlitSolveOptions& options, const Progress& progress) {
  auto session = SlitSession::start(std::move(design));
  if (!session) return session;
  for (int level = 0; level <= subdivisions; ++level) {
    if (level > 0) session->subdivide();
    if (auto report = session->solve(options, progress); !report)
      return tl::unexpected(report.error());
  }
  return session;
}

}  // namespace planish
