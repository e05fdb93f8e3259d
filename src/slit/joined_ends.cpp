// The uncut sheet beyond slits that end in the middle of it (math.md#joined-strips). Like a panel
// it is straight along the strips and bent across, so it is a row of plane facets, each as wide as
// its strip, that turn about the lines between them. Unlike a panel it stands on no curve: where it
// lies is one frame and these turns, so that neighbouring facets share their border exactly and
// folding stays an isometry wherever it lies.
#include "joined_ends.hpp"

#include <planish/base/assert.hpp>
#include <planish/geometry/plane.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace planish::slit_detail {
namespace {

/// A frame turned about a line through a point.
Frame turned_about(const Frame& frame, const Vec3& point, const Eigen::Matrix3d& turn) {
  const Vec3 z = (turn * frame.z).normalized();
  Vec3 x = turn * frame.x;
  x = (x - x.dot(z) * z).normalized();
  return {point + turn * (frame.origin - point), x, z.cross(x), z};
}

/// The next facet's frame: turned about the border, whose far end stays to the last bit.
Frame next_frame(const Frame& frame, const Vec2& border, double turn) {
  const Eigen::AngleAxisd about(turn, frame.x);
  Frame next{Vec3::Zero(), frame.x, about * frame.y, about * frame.z};
  next.origin = frame.point(border) - border.x() * next.x - border.y() * next.y;
  return next;
}

std::vector<Vec2> ring_of(const PanelFacet& facet) {
  return {facet.corners.begin(), facet.corners.end()};
}

Vec3 middle_of(const std::vector<PanelFacet>& facets) {
  Vec3 sum = Vec3::Zero();
  for (const PanelFacet& facet : facets)
    sum += centroid_of(facet);
  return sum / static_cast<double>(facets.size());
}

}  // namespace

std::vector<std::pair<int, int>> joined_strips(const SlitSheet& sheet) {
  std::vector<std::pair<int, int>> runs;
  const int count = static_cast<int>(sheet.strips.size());
  for (int strip = 0; strip < count; ++strip) {
    if (!sheet.joins_next(strip)) continue;
    if (runs.empty() || runs.back().second != strip) runs.emplace_back(strip, strip);
    runs.back().second = strip + 1;
  }
  return runs;
}

std::vector<PanelFacet> facets_of(const SlitSheet& sheet, const JoinedEnds& joined) {
  PLANISH_ASSERT(std::ssize(joined.turns) == joined.last - joined.first);
  std::vector<PanelFacet> facets;
  const double far = sheet.far_line();
  Frame frame = joined.frame;
  for (int strip = joined.first; strip <= joined.last; ++strip) {
    const auto [left, right] = sheet.sides_at_end(strip);
    const auto ends = sheet.ends_of(strip);
    if (strip > joined.first)
      frame = next_frame(frame, {far, left}, joined.turns[strip - joined.first - 1]);
    facets.push_back(
        {{Vec2(far, left), Vec2(ends[0], left), Vec2(ends[1], right), Vec2(far, right)},
         frame,
         strip,
         strip > joined.first});
  }
  return facets;
}

std::vector<JoinedMove> moves_of(const std::vector<PanelFacet>& facets, bool symmetric) {
  std::vector<JoinedMove> moves;
  const Vec3 middle = middle_of(facets);
  for (int axis = symmetric ? 1 : 0; axis < 3; ++axis)
    moves.push_back({0, Vec3::Unit(axis), Vec3::Zero()});
  for (int axis = 0; axis < (symmetric ? 1 : 3); ++axis)
    moves.push_back({0, middle.cross(Vec3::Unit(axis)), Vec3::Unit(axis)});
  for (std::size_t i = 1; i < facets.size(); ++i) {
    const Vec3 axis = facets[i].frame.x, on = facets[i].frame.point(facets[i].corners[0]);
    moves.push_back({static_cast<int>(i), on.cross(axis), axis});
  }
  return moves;
}

JoinedEnds moved(const SlitSheet& sheet, const JoinedEnds& joined, bool symmetric,
                 const Eigen::VectorXd& step) {
  const std::vector<PanelFacet> facets = facets_of(sheet, joined);
  Vec3 way = Vec3::Zero(), turn = Vec3::Zero();
  const int shifts = symmetric ? 2 : 3, rigid = symmetric ? 3 : 6;
  for (int i = 0; i < shifts; ++i)
    way[symmetric ? i + 1 : i] = step[i];
  for (int i = shifts; i < rigid; ++i)
    turn[i - shifts] = step[i];
  JoinedEnds result = joined;
  if (const double angle = turn.norm(); angle > 0.0)
    result.frame = turned_about(joined.frame, middle_of(facets),
                                Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix());
  result.frame.origin += way;
  for (std::size_t i = 0; i < result.turns.size(); ++i)
    result.turns[i] += step[rigid + static_cast<Eigen::Index>(i)];
  return result;
}

std::vector<double> turning_stiffness(const SlitSheet& sheet, const JoinedEnds& joined) {
  std::vector<double> all;
  for (int strip = joined.first; strip < joined.last; ++strip) {
    const double length = sheet.far_line() - sheet.ends_of(strip)[1],
                 bent = 0.5 * (sheet.width_at_end(strip) + sheet.width_at_end(strip + 1));
    all.push_back(length / bent);
  }
  return all;
}

double turning_energy(const SlitSheet& sheet, const JoinedEnds& joined) {
  const std::vector<double> stiffness = turning_stiffness(sheet, joined);
  double energy = 0.0;
  for (std::size_t i = 0; i < stiffness.size(); ++i)
    energy += 0.5 * stiffness[i] * joined.turns[i] * joined.turns[i];
  return energy;
}

double area_of(const PanelFacet& facet) {
  double twice = 0.0;
  const std::vector<Vec2> ring = ring_of(facet);
  for (const Segment& side : sides_of(ring))
    twice += planish::cross(side.a, side.b);
  return 0.5 * std::abs(twice);
}

Vec3 centroid_of(const PanelFacet& facet) {
  Vec2 sum = Vec2::Zero();
  double six = 0.0;
  const std::vector<Vec2> ring = ring_of(facet);
  for (const Segment& side : sides_of(ring)) {
    const double part = planish::cross(side.a, side.b);
    sum += part * (side.a + side.b);
    six += 3.0 * part;
  }
  return facet.frame.point(sum / six);
}

}  // namespace planish::slit_detail
