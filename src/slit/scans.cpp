// Scans that name no strip. The sheet is sampled more finely than a slit is from the next, and each
// point asks for the nearest sample: of a strip, or of a panel, whose points lie on no strip.
// Strips and points follow each other: after the first rounds what is far from all strips is left
// out.
#include "nearest_points.hpp"
#include "refusals.hpp"

#include <planish/base/assert.hpp>
#include <planish/slit/scans.hpp>

#include <algorithm>
#include <cmath>

namespace planish {
namespace {

using namespace slit_detail;

constexpr std::size_t kMostShared = 200'000;  // points: a second
constexpr int kSamplesAcross = 16;            // of a strip
constexpr int kNoStrip = -1;

/// Points of a folded sheet, with their strips.
struct Samples {
  std::vector<Vec3> points;
  std::vector<int> strips;

  void add(const std::array<Vec2, 4>& corners, const Frame& frame, double spacing, int strip) {
    const auto count = [&](int a, int b, int c, int d) {
      const double length = std::max((corners[a] - corners[b]).norm(),
                                     (corners[c] - corners[d]).norm());
      return std::max(1, static_cast<int>(std::ceil(length / spacing)));
    };
    const int along = count(0, 1, 3, 2), across = count(0, 3, 1, 2);
    for (int i = 0; i <= along; ++i)
      for (int j = 0; j <= across; ++j) {
        const double s = static_cast<double>(i) / along, t = static_cast<double>(j) / across;
        const Vec2 flat = (1.0 - s) * ((1.0 - t) * corners[0] + t * corners[3]) +
                          s * ((1.0 - t) * corners[1] + t * corners[2]);
        points.push_back(frame.point(flat));
        strips.push_back(strip);
      }
  }
};

double width_of(const FoldedStrip& strip) {
  return (strip.ridges.front().flat[1] - strip.ridges.front().flat[0]).norm();
}

double widest(const FoldedSlitSheet& sheet) {
  double width = 0.0;
  for (const FoldedStrip& strip : sheet.strips)
    width = std::max(width, width_of(strip));
  return width;
}

Samples samples_of(const FoldedSlitSheet& sheet) {
  Samples samples;
  for (int s = 0; s < std::ssize(sheet.strips); ++s) {
    const FoldedStrip& strip = sheet.strips[s];
    for (int q = 0; q < std::ssize(strip.quads); ++q) {
      const SlitRidge &a = strip.ridges[q], &b = strip.ridges[q + 1];
      samples.add({a.flat[0], b.flat[0], b.flat[1], a.flat[1]}, strip.quads[q],
                  width_of(strip) / kSamplesAcross, s);
    }
  }
  for (const std::vector<PanelFacet>* panel : {&sheet.panel, &sheet.second_panel})
    for (const PanelFacet& facet : *panel)
      samples.add(facet.corners, facet.frame, widest(sheet) / kSamplesAcross, kNoStrip);
  return samples;
}

/// The strip of each point.
std::vector<int> strips_of(const std::vector<Vec3>& cloud, const FoldedSlitSheet& sheet,
                           double farthest) {
  Samples samples = samples_of(sheet);
  const std::vector<int> strips = std::move(samples.strips);
  const NearestPoints nearest(std::move(samples.points));
  return mapped(cloud, [&](const Vec3& p) {
    const Vec3& found = nearest.nearest(p);
    if ((found - p).norm() > farthest) return kNoStrip;
    return strips[&found - nearest.points().data()];
  });
}

std::vector<SlitScan> scans_of(const std::vector<Vec3>& cloud, const std::vector<int>& strips,
                               const FoldedSlitSheet& sheet) {
  std::vector<SlitScan> scans(sheet.strips.size());
  for (int s = 0; s < std::ssize(scans); ++s)
    scans[s].strip = s;
  for (int i = 0; i < std::ssize(cloud); ++i)
    if (strips[i] != kNoStrip) scans[strips[i]].points.push_back(cloud[i]);
  std::erase_if(scans, [](const SlitScan& scan) { return scan.points.empty(); });
  return scans;
}

/// The points as if only the modelled half of a symmetric sheet had been measured.
std::vector<Vec3> on_modelled_half(std::vector<Vec3> points, const FoldedSlitSheet& sheet) {
  if (!sheet.symmetric) return points;
  const double side = sheet.strips.front().ridges.front().folded[0].x();
  for (Vec3& p : points)
    p.x() = std::copysign(p.x(), side);
  return points;
}

std::vector<Vec3> thinned(std::vector<Vec3> points) {
  const std::size_t step = (points.size() + kMostShared - 1) / kMostShared;
  if (step <= 1) return points;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); i += step)
    points[kept++] = points[i];
  points.resize(kept);
  return points;
}

/// Scans and strips in turn.
class Following {
 public:
  Following(SlitSession& session, SlitDesign design)
      : session_(session),
        cloud_(on_modelled_half(thinned(cloud_of(design)), session.folded())),
        told_(with_shares(std::move(design), {})) {}

  /// Gives points to strips; whether some have another one than before.
  Result<bool> share_out(int round) {
    constexpr int kFreeRounds = 2;     // until strips are near
    constexpr double kChanged = 1e-3;  // of all points
    if (cloud_.empty()) return false;
    const FoldedSlitSheet sheet = session_.folded();
    const double farthest = round < kFreeRounds ? sheet.reach : widest(sheet);
    std::vector<int> strips = strips_of(cloud_, sheet, farthest);
    double changed = strips_.empty() ? static_cast<double>(cloud_.size()) : 0.0;
    for (std::size_t i = 0; i < strips_.size(); ++i)
      changed += strips[i] != strips_[i] ? 1.0 : 0.0;
    strips_ = std::move(strips);
    shares_ = scans_of(cloud_, strips_, sheet);
    if (shares_.empty()) return fail(refuse::cloud_off, {{"field", place::pointer("/scan")}});
    if (auto set = session_.set_design(shared()); !set) return pass_on(set);
    return changed > kChanged * static_cast<double>(cloud_.size());
  }

  /// The design with the points of each strip.
  SlitDesign shared() const { return with_shares(told_, shares_); }

 private:
  SlitSession& session_;
  std::vector<Vec3> cloud_;
  SlitDesign told_;
  std::vector<int> strips_;       ///< of the cloud's points
  std::vector<SlitScan> shares_;  ///< of strips in the cloud
};

}  // namespace

bool has_cloud(const SlitDesign& design) {
  return std::ranges::any_of(design.scans, [](const SlitScan& scan) { return !scan.strip; });
}

std::vector<Vec3> cloud_of(const SlitDesign& design) {
  std::vector<Vec3> cloud;
  for (const SlitScan& scan : design.scans)
    if (!scan.strip) cloud.insert(cloud.end(), scan.points.begin(), scan.points.end());
  return cloud;
}

SlitDesign with_shares(SlitDesign design, const std::vector<SlitScan>& shares) {
  std::erase_if(design.scans, [](const SlitScan& scan) { return !scan.strip; });
  design.scans.insert(design.scans.end(), shares.begin(), shares.end());
  return design;
}

std::vector<SlitScan> by_strip(const std::vector<Vec3>& cloud, const FoldedSlitSheet& sheet,
                               double farthest) {
  const std::vector<Vec3> points = on_modelled_half(thinned(cloud), sheet);
  return scans_of(points, strips_of(points, sheet, farthest), sheet);
}

Result<Eigen::Isometry3d> follow_scans(SlitSession& session, SlitDesign design, bool align,
                                       const SlitSolveOptions& options, const Progress& progress) {
  constexpr int kRounds = 30;
  constexpr double kStill = 1e-4;  // of the sheet's reach
  const double reach = design.sheet.reach(), still = kStill * reach;
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  const bool clouded = has_cloud(design);
  PLANISH_ASSERT(!(align && clouded));
  Following following(session, std::move(design));
  for (int round = 0; round < kRounds; ++round) {
    if (auto done = session.solve(options, progress); !done) return pass_on(done);
    const auto changed = following.share_out(round);
    if (!changed) return pass_on(changed);
    double moved = 0.0;
    if (align) {
      const auto step = session.align_scans();
      if (!step) return step;
      motion = *step * motion;
      moved = step->translation().norm() + Eigen::AngleAxisd(step->linear()).angle() * reach;
    }
    if (!*changed && moved < still) break;
  }
  if (clouded) {  // as if points had named their strips: not from shapes on the way here
    auto again = SlitSession::start(following.shared());
    if (!again) return pass_on(again);
    session = std::move(*again);
  }
  if (auto done = session.solve(options, progress); !done) return pass_on(done);
  return motion;
}

}  // namespace planish
