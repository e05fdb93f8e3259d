#include "align.hpp"
#include "checks.hpp"
#include "session_content.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <utility>

namespace planish {

using namespace slit_detail;

namespace {

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

}  // namespace

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

}  // namespace planish
