#include "align.hpp"
#include "checks.hpp"
#include "session_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace planish {

using namespace slit_detail;

namespace {

void take_scan(Snapshot& next, int strip, std::vector<Vec3> points) {
  Slot slot = next.slot(strip);
  slot.scan = scan_of(std::move(points));
  slot.state.status = StripStatus::open;
  next.slots[strip] = std::make_shared<const Slot>(std::move(slot));
}

/// Anchors of a design with fewer ridges, where halvings of its quads lead to as many.
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

/// What the strips' anchors are, those of one strip in their order.
bool same_anchors(const SlitDesign& a, const SlitDesign& b, int strip) {
  const auto of_strip = [&](const SlitDesign& design) {
    std::vector<SlitAnchor> anchors;
    std::copy_if(design.anchors.begin(), design.anchors.end(), std::back_inserter(anchors),
                 [&](const SlitAnchor& anchor) { return anchor.strip == strip; });
    return anchors;
  };
  return of_strip(a) == of_strip(b);
}

/// A snapshot with another design of the same sheet; the strips that it touches are open.
Result<Snapshot> with_design(const Snapshot& now, SlitDesign design) {
  Snapshot next = now;
  design.ends.resize(design.sheet.strips.size());
  bool all = design.weights != now.design->weights || design.end_angle != now.design->end_angle;
  if (design.leg_curve != now.design->leg_curve) {
    auto panel = checked_panel(design);
    if (!panel) return tl::unexpected(panel.error());
    next.panel = std::make_shared<const std::vector<PanelFacet>>(std::move(*panel));
    all = true;
  }
  if (auto sound = check_all(design, *next.panel); !sound) return tl::unexpected(sound.error());
  if (design.seat_curve != now.design->seat_curve) {
    take_seat_curve(next, design);
    all = true;
  }
  for (int strip = 0; strip < next.count(); ++strip) {
    const auto i = static_cast<std::size_t>(strip);
    if (all || design.ends[i] != now.design->ends[i] || !same_anchors(design, *now.design, strip))
      reopen(next, strip);
  }
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  return next;
}

}  // namespace

Result<void> SlitSession::edit(const std::function<void(SlitDesign&)>& change) {
  SlitDesign design = *content_->now.design;
  change(design);
  auto next = with_design(content_->now, std::move(design));
  if (!next) return tl::unexpected(next.error());
  content_->commit(std::move(*next));
  return {};
}

Result<void> SlitSession::set_design(SlitDesign design) {
  const Snapshot& now = content_->now;
  number_as_subdivided(design, now.design->ridges);
  if (design.sheet != now.design->sheet || design.ridges != now.design->ridges) {
    auto begun = start(std::move(design));
    if (!begun) return tl::unexpected(begun.error());
    content_->commit(std::move(begun->content_->now));
    return {};
  }
  const auto scans = points_by_strip(design);
  if (!scans) return tl::unexpected(scans.error());
  design.scans.clear();
  auto next = with_design(now, std::move(design));
  if (!next) return tl::unexpected(next.error());
  for (int strip = 0; strip < now.count(); ++strip)
    if (const auto& points = (*scans)[strip]; points != scan(strip))
      take_scan(*next, strip, points);
  content_->commit(std::move(*next));
  return {};
}

Result<void> SlitSession::set_leg_curve(BezierCurve curve) {
  return edit([&](SlitDesign& design) { design.leg_curve = std::move(curve); });
}

Result<void> SlitSession::set_seat_curve(std::optional<BezierCurve> curve) {
  return edit([&](SlitDesign& design) { design.seat_curve = std::move(curve); });
}

Result<void> SlitSession::set_weights(const SlitWeights& weights) {
  return edit([&](SlitDesign& design) { design.weights = weights; });
}

Result<void> SlitSession::set_end_angle(EndAngle angle) {
  return edit([&](SlitDesign& design) { design.end_angle = angle; });
}

Result<void> SlitSession::set_end(int strip, const StripEnd& end) {
  if (strip < 0 || strip >= strip_count())
    return fail(
        ErrorCode::unknown_strip,
        fmt::format("there is no strip {}; the sheet has strips 0 to {}", strip, strip_count() - 1),
        fmt::format("/ends/{}", strip));
  return edit([&](SlitDesign& design) { design.ends[strip] = end; });
}

Result<void> SlitSession::add_anchor(const SlitAnchor& anchor) {
  return edit([&](SlitDesign& design) { design.anchors.push_back(anchor); });
}

namespace {

Result<void> check_anchor_number(const SlitDesign& design, int anchor) {
  if (anchor >= 0 && anchor < static_cast<int>(design.anchors.size())) return {};
  return fail(ErrorCode::bad_option,
              fmt::format("there is no anchor {}; there are {}", anchor, design.anchors.size()),
              fmt::format("/anchors/{}", anchor));
}

}  // namespace

Result<void> SlitSession::move_anchor(int anchor, const Vec3& at) {
  if (auto sound = check_anchor_number(design(), anchor); !sound) return sound;
  return edit([&](SlitDesign& design) { design.anchors[anchor].at = at; });
}

Result<void> SlitSession::remove_anchor(int anchor) {
  if (auto sound = check_anchor_number(design(), anchor); !sound) return sound;
  return edit([&](SlitDesign& design) { design.anchors.erase(design.anchors.begin() + anchor); });
}

Result<void> SlitSession::set_scan(int strip, std::vector<Vec3> points) {
  if (auto sound = check_scan(design(), strip, points, strip); !sound) return sound;
  Snapshot next = content_->now;
  take_scan(next, strip, std::move(points));
  content_->commit(std::move(next));
  return {};
}

Result<Eigen::Isometry3d> SlitSession::align_scans() {
  Snapshot next = content_->now;
  std::vector<ScannedStrip> scans;
  for (int strip = 0; strip < next.count(); ++strip)
    if (const auto& scan = next.slot(strip).scan)
      scans.push_back({scan->points(), folded_of(next, strip)});
  if (scans.empty()) return fail(ErrorCode::empty_scan, "there is no scan to align", "/scan");
  const Eigen::Isometry3d motion = aligning_motion(scans);
  for (int strip = 0; strip < next.count(); ++strip) {
    if (!next.slot(strip).scan) continue;
    std::vector<Vec3> moved = next.slot(strip).scan->points();
    for (Vec3& p : moved)
      p = motion * p;
    take_scan(next, strip, std::move(moved));
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
    next.slots[strip] = std::make_shared<const Slot>(std::move(slot));
  }
  SlitDesign design = *next.design;
  design.ridges *= 2;
  for (SlitAnchor& anchor : design.anchors)
    anchor.ridge *= 2;
  next.design = std::make_shared<const SlitDesign>(std::move(design));
  content_->commit(std::move(next));
}

}  // namespace planish
