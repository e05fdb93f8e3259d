// Where neighbouring strips lean towards each other they overlap as petals do: one lies on the
// other. Pushing them apart sideways would twist both, since a strip is stiff in its plane; lifting
// one off the other bends it a little. So points of facing edges stay beside the other strip where
// they are beside it, and above or below it where they are over it (math.md#strip-contact).
#include "contacts.hpp"

#include <planish/geometry/plane.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace planish::slit_detail {
namespace {

/// A place of a strip and how a point lies to it: how far outside the edge, how far above.
struct Foot {
  double out = 0.0, above = 0.0;
  int quad = 0;
  double along = 0.0, across = 0.0;  ///< where in the quad the strip's point next to it is
  double along_edge = 0.0;           ///< where the edge's point next to it is
  Vec3 sideways = Vec3::Zero(), normal = Vec3::Zero();
  double distance = 0.0;  ///< from the strip's point next to it
};

/// Between the long edges of a quad, as lines from ridge to ridge, at a place of its plane: how far
/// inside each it is.
std::array<double, 2> inside_edges(const FoldedStrip& strip, int quad, const Vec2& at) {
  std::array<double, 2> inside{};
  for (std::size_t side = 0; side < 2; ++side) {
    const Vec2 &from = strip.ridges[quad].flat[side], &to = strip.ridges[quad + 1].flat[side];
    const double left = planish::cross(to - from, at - from) / (to - from).norm();
    inside[side] = side == 0 ? left : -left;
  }
  return inside;
}

/// Where it is widest.
double width_of(const FoldedStrip& strip) {
  double width = 0.0;
  for (int quad = 0; quad < std::ssize(strip.quads); ++quad)
    width = std::max({width, inside_edges(strip, quad, strip.ridges[quad].flat[1])[0],
                      inside_edges(strip, quad, strip.ridges[quad].flat[0])[1]});
  return width;
}

/// A point of a quad as a combination of its corners: along the ridges at a share of the width.
std::vector<StripPoint::Share> shares_of(int quad, double along, double across) {
  const std::array<double, 2> of_side{1.0 - across, across}, of_ridge{1.0 - along, along};
  std::vector<StripPoint::Share> shares;
  for (int side = 0; side < 2; ++side)
    for (int ridge = 0; ridge < 2; ++ridge)
      if (of_side[side] * of_ridge[ridge] != 0.0)
        shares.push_back({side, quad + ridge, of_side[side] * of_ridge[ridge]});
  return shares;
}

/// How far along a quad a place of its plane is at a share of the width: 0 on its first ridge, 1 on
/// its last.
double along_quad(const FoldedStrip& strip, int quad, double across, const Vec2& at) {
  const auto on_ridge = [&](const SlitRidge& ridge) -> Vec2 {
    return ridge.flat[0] + across * (ridge.flat[1] - ridge.flat[0]);
  };
  const Vec2 from = on_ridge(strip.ridges[quad]), way = on_ridge(strip.ridges[quad + 1]) - from;
  return way.dot(at - from) / way.squaredNorm();
}

/// The foot of a point on one quad, as far as it lies over it or beside its edge.
Foot foot_on(const FoldedStrip& strip, int quad, int edge, const Vec3& p) {
  const Frame& frame = strip.quads[quad];
  const Vec3 local = frame.local(p);
  const Vec2 flat = local.head<2>();
  const SlitRidge &near = strip.ridges[quad], &far = strip.ridges[quad + 1];
  const auto inside = inside_edges(strip, quad, flat);
  const double width = inside[0] + inside[1];
  const auto at = [&](double along, double across) -> Vec2 {
    const Vec2 from = near.flat[0] + across * (near.flat[1] - near.flat[0]),
               to = far.flat[0] + across * (far.flat[1] - far.flat[0]);
    return from + along * (to - from);
  };
  // Beside an edge at its point next to the place.
  const auto along_at = [&](double across) {
    return std::clamp(along_quad(strip, quad, across, flat), 0.0, 1.0);
  };
  Foot foot;
  foot.quad = quad;
  foot.above = local.z();
  foot.out = -inside[edge];
  foot.across = width > 0.0 ? std::clamp(inside[0] / width, 0.0, 1.0) : 0.5;
  foot.along = along_at(foot.across);
  foot.along_edge = along_at(edge);
  const Vec2 way = (far.flat[edge] - near.flat[edge]).normalized(),
             aside = edge == 0 ? Vec2(way.y(), -way.x()) : Vec2(-way.y(), way.x());
  foot.sideways = aside.x() * frame.x + aside.y() * frame.y;
  foot.normal = frame.z;
  const Vec2 next = at(foot.along, foot.across);
  foot.distance = (local - Vec3(next.x(), next.y(), 0.0)).norm();
  return foot;
}

Vec3 point_of(const FoldedStrip& strip, const std::vector<StripPoint::Share>& shares) {
  Vec3 point = Vec3::Zero();
  for (const StripPoint::Share& share : shares)
    point += share.weight * strip.ridges[share.ridge].folded[share.side];
  return point;
}

/// Of each quad, around its corners: no place of it is nearer than its box.
std::vector<Eigen::AlignedBox3d> boxes_of(const FoldedStrip& strip) {
  std::vector<Eigen::AlignedBox3d> boxes(strip.quads.size());
  for (std::size_t quad = 0; quad < boxes.size(); ++quad)
    for (const SlitRidge* ridge : {&strip.ridges[quad], &strip.ridges[quad + 1]})
      for (const Vec3& end : ridge->folded)
        boxes[quad].extend(end);
  return boxes;
}

/// A point of an edge: at a ridge, or at a share of the way to the next one.
std::vector<StripPoint::Share> edge_point(int side, int ridge, double share) {
  if (share == 0.0) return {{side, ridge, 1.0}};
  return {{side, ridge, 1.0 - share}, {side, ridge + 1, share}};
}

/// What a point must keep from the other strip: along a direction, from its edge or its surface.
struct Kept {
  Vec3 normal;
  double offset = 0.0;
  bool from_edge = false;
  double missing = 0.0;
};

/// A strip is this much stiffer sideways than across its surface.
constexpr double kStiffer = 10.0;

/// Also of a point that keeps it now, so that it does when strips move.
std::optional<Kept> kept_from(const Foot& foot, double sense, double thickness, double width) {
  const double above = sense * foot.above;
  if (std::abs(foot.above) > width || std::abs(foot.out) >= width) return std::nullopt;
  if (above < 0.0 && -kStiffer * foot.out < -above)
    return Kept{foot.sideways, 0.0, true, std::max(0.0, -foot.out)};
  if (-foot.out >= thickness)
    return Kept{sense * foot.normal, thickness, false, std::max(0.0, thickness - above)};
  constexpr double kRoot = std::numbers::sqrt2 / 2.0;
  return Kept{kRoot * (sense * foot.normal + foot.sideways), 0.0, true,
              std::max(0.0, -kRoot * (above + foot.out))};
}

/// A place along a strip: at a ridge, or in the middle between two.
struct Station {
  int number = 0;

  int ridge() const { return number / 2; }
  /// How far on the way to the next ridge.
  double share() const { return number % 2 == 0 ? 0.0 : 0.5; }
  std::vector<StripPoint::Share> point(int side) const {
    return edge_point(side, ridge(), share());
  }
};

int stations(const FoldedStrip& strip) { return 2 * static_cast<int>(strip.quads.size()) + 1; }

/// One strip of a pair, and the other from which its points must keep.
class Side {
 public:
  /// `is_left`: the strip is the left one of the pair.
  Side(bool is_left, const FoldedStrip& strip, const FoldedStrip& other, double thickness)
      : is_left_(is_left),
        strip_(strip),
        other_(other),
        boxes_(boxes_of(other)),
        far_(width_of(other)),
        thickness_(thickness) {}

  /// Which edge faces the other strip.
  int facing() const { return is_left_ ? 1 : 0; }

  /// The nearest place of the other strip, sought from the quad beside the point outwards.
  Foot foot_of_point(const std::vector<StripPoint::Share>& point) const {
    const Vec3 p = point_of(strip_, point);
    const int quads = static_cast<int>(other_.quads.size()),
              beside = std::min(point.front().ridge, quads - 1);
    Foot nearest = foot_on(other_, beside, 1 - facing(), p);
    const auto see = [&](int quad) {
      if (quad < 0 || quad >= quads) return;
      if (boxes_[quad].squaredExteriorDistance(p) > nearest.distance * nearest.distance) return;
      const Foot foot = foot_on(other_, quad, 1 - facing(), p);
      if (std::pair(foot.distance, quad) < std::pair(nearest.distance, nearest.quad))
        nearest = foot;
    };
    for (int away = 1; away < quads; ++away)
      see(beside - away), see(beside + away);
    return nearest;
  }

  bool is_over(const Foot& foot) const {
    return std::abs(foot.above) < far_ && foot.out < 0.0 && foot.out > -far_;
  }

  std::optional<Kept> kept(const Foot& foot, OnTop on_top) const {
    const double sense = (on_top == OnTop::left) == is_left_ ? 1.0 : -1.0;
    return kept_from(foot, sense, thickness_, far_);
  }

  /// Where the facing edge goes through the plane of the other strip between two stations it does
  /// so beside it. Calls f(point, foot, what is kept).
  template <typename F>
  void aside(const Station& before, const Foot& from, const Foot& to, const F& f) const {
    if (!(from.above * to.above < 0.0)) return;
    const auto point = edge_point(facing(), before.ridge(),
                                  before.share() + 0.5 * from.above / (from.above - to.above));
    const Foot at = foot_of_point(point);
    if (std::abs(at.above) < far_ && std::abs(at.out) < far_)
      f(point, at, Kept{at.sideways, 0.0, true, std::max(0.0, -at.out)});
  }

  /// Where an edge goes through the other strip between two stations, which both may keep.
  template <typename F>
  void pierced(int side, const Station& before, OnTop on_top, const F& f) const {
    const Vec3 from = point_of(strip_, before.point(side)),
               to = point_of(strip_, Station{before.number + 1}.point(side));
    for (int quad = 0; quad < std::ssize(other_.quads); ++quad) {
      const Frame& frame = other_.quads[quad];
      const double a = frame.local(from).z(), b = frame.local(to).z();
      if (!(a * b < 0.0)) continue;
      const double share = a / (a - b);
      const Vec3 through = from + share * (to - from);
      const Foot foot = foot_on(other_, quad, 1 - facing(), through);
      const Vec2 place = frame.local(through).head<2>();
      const auto inside = inside_edges(other_, quad, place);
      const double along = along_quad(other_, quad, inside[0] / (inside[0] + inside[1]), place);
      if (along < 0.0 || along > 1.0 || !is_over(foot)) continue;
      const auto point = edge_point(side, before.ridge(), before.share() + 0.5 * share);
      if (const auto kept_there = kept(foot, on_top)) f(point, foot, *kept_there);
    }
  }

  /// Calls f(point, foot, what is kept) for all points of the strip; where it begins it touches.
  template <typename F>
  void each(const std::vector<OnTop>& on_top, const F& f) const {
    for (int side = 0; side < 2; ++side) {
      Foot before = foot_of_point(Station{0}.point(side));
      for (int number = 1; number < stations(strip_); ++number) {
        const auto point = Station{number}.point(side);
        Foot now = foot_of_point(point);
        if (const auto kept_there = kept(now, on_top[number])) f(point, now, *kept_there);
        if (side == facing()) aside({number - 1}, before, now, f);
        pierced(side, {number - 1}, on_top[number], f);
        before = std::move(now);
      }
    }
  }

 private:
  bool is_left_;
  const FoldedStrip &strip_, &other_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  double far_ = 0.0;  ///< how wide the other strip is
  double thickness_;
};

/// Calls f(whether of the left strip, point, foot, what is kept) for both strips.
template <typename F>
void for_points(const StripPair& pair, const FoldedStrip& left, const FoldedStrip& right,
                double thickness, const F& f) {
  for (const bool is_left : {true, false}) {
    const Side side = is_left ? Side(true, left, right, thickness)
                              : Side(false, right, left, thickness);
    side.each(pair.on_top, [&](const std::vector<StripPoint::Share>& point, const Foot& foot,
                               const Kept& kept) { f(is_left, point, foot, kept); });
  }
}

/// What a station lacks if the one strip is on top, and if the other is; whether they overlap.
struct Lack {
  double left = 0.0, right = 0.0;
  bool over = false;

  std::optional<OnTop> nearer() const {
    if (left == right) return std::nullopt;
    return right < left ? OnTop::right : OnTop::left;
  }
};

Lack lack_at(const Station& station, const Side& side) {
  const Foot foot = side.foot_of_point(station.point(side.facing()));
  Lack lack;
  lack.over = side.is_over(foot);
  const auto square = [&](OnTop on_top) {
    const auto kept = side.kept(foot, on_top);
    return kept ? kept->missing * kept->missing : 0.0;
  };
  lack.left = square(OnTop::left);
  lack.right = square(OnTop::right);
  return lack;
}

/// Stations at which neither is nearer go with those before them, the first ones with those behind:
/// strips may come to overlap there.
std::vector<OnTop> filled(std::vector<std::optional<OnTop>> on_top) {
  for (int i = 1; i < std::ssize(on_top); ++i)
    if (!on_top[i]) on_top[i] = on_top[i - 1];
  std::vector<OnTop> all(on_top.size());
  OnTop next = OnTop::left;
  for (int i = static_cast<int>(on_top.size()) - 1; i >= 0; --i)
    all[i] = next = on_top[i].value_or(next);
  return all;
}

}  // namespace

StripPair pair_of(int left, int right, const FoldedStrip& shape, OnTop on_top) {
  return {left, right, std::vector<OnTop>(stations(shape), on_top)};
}

StripPair nearest_pair(int left, int right, const FoldedStrip& left_shape,
                       const FoldedStrip& right_shape, double thickness) {
  const Side of_left(true, left_shape, right_shape, thickness),
      of_right(false, right_shape, left_shape, thickness);
  std::vector<std::optional<OnTop>> on_top;
  Lack run;
  const auto end_run = [&](int end) {
    on_top.resize(end, run.nearer());
    run = {};
  };
  for (int number = 0; number < stations(left_shape); ++number) {
    const Lack a = lack_at({number}, of_left), b = lack_at({number}, of_right);
    if (!a.over && !b.over) end_run(number);
    run.left += a.left + b.left;
    run.right += a.right + b.right;
  }
  end_run(stations(left_shape));
  return {left, right, filled(on_top)};
}

std::vector<Contact> contacts_of(const StripPair& pair, const FoldedStrip& left,
                                 const FoldedStrip& right, double thickness) {
  std::vector<Contact> contacts;
  for_points(pair, left, right, thickness,
             [&](bool is_left, const std::vector<StripPoint::Share>& point, const Foot& foot,
                 const Kept& kept) {
               const int edge = is_left ? 0 : 1;
               contacts.push_back({{is_left ? pair.left : pair.right, point},
                                   {is_left ? pair.right : pair.left,
                                    kept.from_edge ? shares_of(foot.quad, foot.along_edge, edge)
                                                   : shares_of(foot.quad, foot.along, foot.across)},
                                   kept.normal,
                                   kept.offset,
                                   0.0});
             });
  return contacts;
}

std::vector<Contact> subdivided(const std::vector<Contact>& contacts) {
  std::vector<Contact> fine;
  for (const Contact& contact : contacts) {
    const StripPoint::Share& first = contact.here.shares.front();
    if (contact.of_gap != GapLimit::none) {  // where strips end
      fine.push_back(contact);
      for (StripPoint* point : {&fine.back().here, &fine.back().there})
        point->shares.front().ridge *= 2;
      continue;
    }
    const double at = 2.0 * (first.ridge + 1.0 - first.weight);
    for (const auto& [beside, share] : {std::pair{-0.5, 0.25}, {0.0, 0.5}, {0.5, 0.25}}) {
      const double place = std::max(0.0, at + beside);
      const int ridge = static_cast<int>(place);
      Contact one = contact;
      one.here.shares = edge_point(first.side, ridge, place - ridge);
      one.multiplier *= share;
      fine.push_back(std::move(one));
    }
  }
  return fine;
}

bool is_same(const Contact& a, const Contact& b) {
  constexpr double kAlike = 0.5, kNear = 0.25;
  const StripPoint::Share &first = a.here.shares.front(), &second = b.here.shares.front();
  if (a.of_gap != b.of_gap || a.of_gap != GapLimit::none) return a.of_gap == b.of_gap;
  return a.here.strip == b.here.strip && a.there.strip == b.there.strip &&
         first.side == second.side && first.ridge == second.ridge &&
         std::abs(first.weight - second.weight) < kNear && a.normal.dot(b.normal) > kAlike;
}

Missing missing(const StripPair& pair, const FoldedStrip& left, const FoldedStrip& right,
                double thickness) {
  Missing all;
  for_points(pair, left, right, thickness,
             [&](bool, const std::vector<StripPoint::Share>&, const Foot&, const Kept& kept) {
               all.squares += kept.missing * kept.missing;
               all.most = std::max(all.most, kept.missing);
             });
  return all;
}

}  // namespace planish::slit_detail
