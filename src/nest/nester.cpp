#include "nester.hpp"

#include <planish/base/id_vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

// The one source that sees libnest2d (docs/decisions/0014). Shapes go, largest first, each to the
// place farthest to the left in the first room that has one; walls around the room make places
// along its edge corners of no-fit polygons, so only corners need be tried. No-fit polygons of
// shapes that are not convex are Clipper's Minkowski sums, made once for each two outlines. A place
// that lies on another shape after all is barred and the next one tried.

// One after another: its std::async would start a thread for each item and corner. OpenMP, not
// switched on, is a plain loop.
#define LIBNEST2D_THREADING_omp
#define LIBNEST2D_GEOMETRIES_clipper
// Boost 1.74 includes a header of its own that it calls deprecated.
#define BOOST_ALLOW_DEPRECATED_HEADERS

#include <libnest2d/optimizer.hpp>

namespace planish::nest_detail {

/// In place of NLopt. The best place along a no-fit polygon, by our score, is at one of its
/// corners, where the placer begins each search.
class AtCorner : public libnest2d::opt::Optimizer<AtCorner> {
  friend class libnest2d::opt::Optimizer<AtCorner>;

 public:
  using Optimizer::Optimizer;

 protected:
  template <class Function, class... Args>
  libnest2d::opt::Result<Args...> optimize(Function&& score, std::tuple<Args...> corner,
                                           libnest2d::opt::Bound<Args>... bounds) {
    libnest2d::opt::Result<Args...> best{libnest2d::opt::SUCCESS, corner,
                                         std::apply(score, corner)};
    // Of a hole of a no-fit polygon the last corner, at the upper bound, is not among the starts.
    const std::tuple<Args...> first(bounds.min()...), last(bounds.max()...);
    if (corner != first) return best;
    const double at_last = std::apply(score, last);
    return at_last < best.score
               ? libnest2d::opt::Result<Args...>{libnest2d::opt::SUCCESS, last, at_last}
               : best;
  }
};

}  // namespace planish::nest_detail

namespace libnest2d {
/// libnest2d compares angles by their conversion to double; C++20 also finds the comparison with
/// degrees, turned round, and cannot choose.
inline bool operator!=(const Radians& a, const Radians& b) { return double(a) != double(b); }
}  // namespace libnest2d

namespace libnest2d::opt {
template <>
struct OptimizerSubclass<Method::L_SUBPLEX> {
  using Type = planish::nest_detail::AtCorner;
};
}  // namespace libnest2d::opt

#include <libnest2d/libnest2d.hpp>

namespace planish::nest_detail {
namespace {

using libnest2d::Item;
using libnest2d::PolygonImpl;

/// libnest2d's polygons run clockwise and repeat their first corner.
Path closed_clockwise(Path path) {
  if (ClipperLib::Orientation(path)) ClipperLib::ReversePath(path);
  path.push_back(path.front());
  return path;
}

bool is_convex(const Path& clockwise) {
  const std::size_t n = clockwise.size() - 1;
  for (std::size_t i = 0; i < n; ++i) {
    const IntPoint &a = clockwise[i], &b = clockwise[i + 1], &c = clockwise[(i + 2) % n];
    if ((b.X - a.X) * (c.Y - b.Y) > (b.Y - a.Y) * (c.X - b.X)) return false;
  }
  return true;
}

/// The places of the reference corner of `orbiting` at which it meets `fixed`: a Minkowski sum.
PolygonImpl no_fit_polygon(const Path& fixed, const Path& orbiting) {
  Path turned = orbiting;
  for (IntPoint& p : turned)
    p = {-p.X, -p.Y};
  const bool larger = std::abs(ClipperLib::Area(fixed)) >= std::abs(ClipperLib::Area(turned));
  Paths sum;
  ClipperLib::MinkowskiSum(larger ? turned : fixed, Paths{larger ? fixed : turned}, sum, true);
  const auto outer = std::ranges::max_element(sum, {},
                                              [](const Path& p) { return ClipperLib::Area(p); });
  PolygonImpl result(closed_clockwise(*outer));
  for (auto path = sum.begin(); path != sum.end(); ++path) {
    if (path == outer) continue;
    result.Holes.push_back(closed_clockwise(*path));
    ClipperLib::ReversePath(result.Holes.back());
  }
  return result;
}

Path from_first_corner(Path path) {
  const IntPoint first = path.front();
  for (IntPoint& p : path)
    p -= first;
  return path;
}

/// No-fit polygons that were made, by the two outlines wherever they lie: copies of a part meet
/// copies of another again and again.
class NoFitPolygons {
 public:
  const PolygonImpl& of(const Path& fixed, const Path& orbiting) {
    auto key = std::pair(from_first_corner(fixed), from_first_corner(orbiting));
    const auto found = made_.find(key);
    if (found != made_.end()) return found->second;
    PolygonImpl polygon = no_fit_polygon(key.first, key.second);
    return made_.emplace(std::move(key), std::move(polygon)).first->second;
  }

 private:
  using Pair = std::pair<Path, Path>;
  struct Before {
    static bool before(const IntPoint& a, const IntPoint& b) {
      return a.X != b.X ? a.X < b.X : a.Y < b.Y;
    }
    bool operator()(const Pair& a, const Pair& b) const {
      if (a.first != b.first) return std::ranges::lexicographical_compare(a.first, b.first, before);
      return std::ranges::lexicographical_compare(a.second, b.second, before);
    }
  };
  std::map<Pair, PolygonImpl, Before> made_;
};

/// libnest2d calls for no-fit polygons by a function of two outlines and nothing else; this is how
/// those of one run reach it. Set for as long as `lay_out` runs.
thread_local NoFitPolygons* no_fit_polygons = nullptr;

class NoFitPolygonsOfRun {
 public:
  NoFitPolygonsOfRun() { no_fit_polygons = &polygons_; }
  ~NoFitPolygonsOfRun() { no_fit_polygons = nullptr; }
  NoFitPolygonsOfRun(const NoFitPolygonsOfRun&) = delete;
  NoFitPolygonsOfRun& operator=(const NoFitPolygonsOfRun&) = delete;

 private:
  NoFitPolygons polygons_;
};

}  // namespace
}  // namespace planish::nest_detail

namespace libnest2d::nfp {
/// libnest2d brings convex polygons; Clipper's Minkowski sums do for the others.
template <>
struct NfpImpl<PolygonImpl, NfpLevel::CONVEX_ONLY> {
  NfpResult<PolygonImpl> operator()(const PolygonImpl& fixed, const PolygonImpl& orbiting) const {
    using namespace planish::nest_detail;
    if (is_convex(fixed.Contour) && is_convex(orbiting.Contour))
      return nfpConvexOnly(fixed, orbiting);
    const PolygonImpl& polygon = no_fit_polygons->of(fixed.Contour, orbiting.Contour);
    return {polygon, rightmostUpVertex(polygon)};
  }
};
}  // namespace libnest2d::nfp

namespace planish::nest_detail {
namespace {

/// Thicker than any rounding.
constexpr cInt kWall = 100000;

Item wall(cInt left, cInt low, cInt right, cInt high) {
  return Item(Path{{left, low}, {left, high}, {right, high}, {right, low}, {left, low}});
}

/// Whether two items cover each other, by more than the seam that rounding leaves.
bool overlap(const Item& a, const Item& b) {
  constexpr double kSeam = 5.0;  // units, on half the outline
  const auto one = a.boundingBox(), other = b.boundingBox();
  const IntPoint low(std::max(one.minCorner().X, other.minCorner().X),
                     std::max(one.minCorner().Y, other.minCorner().Y));
  const IntPoint high(std::min(one.maxCorner().X, other.maxCorner().X),
                      std::min(one.maxCorner().Y, other.maxCorner().Y));
  if (low.X >= high.X || low.Y >= high.Y) return false;
  ClipperLib::Clipper clipper;
  clipper.AddPath(a.transformedShape().Contour, ClipperLib::ptSubject, true);
  clipper.AddPath(b.transformedShape().Contour, ClipperLib::ptClip, true);
  Paths common;
  clipper.Execute(ClipperLib::ctIntersection, common, ClipperLib::pftNonZero,
                  ClipperLib::pftNonZero);
  return sum_of(common, [&](const Path& path) { return std::abs(ClipperLib::Area(path)); }) >
         kSeam * static_cast<double>(high.X - low.X + high.Y - low.Y);
}

constexpr double kNoPlace = std::numeric_limits<double>::max();

/// A place that an item must not take.
struct Barred {
  IntPoint shift;
  double rotation = 0.0;
};

/// libnest2d's placer in a room with walls: they make the places along the edge of the sheet
/// corners of no-fit polygons. What cannot have room any more is not tried. A place is looked at
/// before it is taken: among the holes of united no-fit polygons Clipper, rarely, leaves a needle
/// that is none.
class WalledPlacer : public libnest2d::NfpPlacer {
  using Base = libnest2d::NfpPlacer;

 public:
  using BinType = Base::BinType;

  explicit WalledPlacer(const BinType& bin) : Base(bin), walls_(walls_of(bin)) {
    preload({walls_->begin(), walls_->end()});
    const double length = static_cast<double>(bin.width() - 4 * kWall);
    const double width = static_cast<double>(bin.height() - 4 * kWall);
    free_ = length * width;
  }

  void configure(Config config) {
    config.object_function = [barred = barred_, score = config.object_function](const Item& item) {
      for (const Barred& place : *barred)
        if (is_at(item, place)) return kNoPlace;
      return score(item);
    };
    Base::configure(config);
  }

  template <class Remaining>
  bool pack(Item& item, const Remaining& remaining) {
    return packed(item, [&] { return Base::pack(item, remaining); });
  }
  bool pack(Item& item) {
    return packed(item, [&] { return Base::pack(item); });
  }

 private:
  static std::shared_ptr<std::vector<Item>> walls_of(const BinType& bin) {
    const cInt right = bin.maxCorner().X - kWall, top = bin.maxCorner().Y - kWall;
    auto walls = std::make_shared<std::vector<Item>>();
    walls->push_back(wall(-kWall, -kWall, 0, top));
    walls->push_back(wall(right - kWall, -kWall, right, top));
    walls->push_back(wall(-kWall, -kWall, right, 0));
    walls->push_back(wall(-kWall, top - kWall, right, top));
    return walls;
  }

  template <class Try>
  bool packed(Item& item, const Try& attempt) {
    const Path& outline = item.rawShape().Contour;
    // A shape that found no place finds none later.
    if (item.area() > free_ || std::ranges::find(without_place_, outline) != without_place_.end())
      return false;
    constexpr int kAttempts = 20;
    barred_->clear();
    for (int i = 0; i < kAttempts && attempt(); ++i) {
      if (!lies_on_another()) {
        free_ -= item.area();
        return true;
      }
      barred_->push_back({item.translation(), angle_of(item)});
      unpackLast();
      item.rotation(0.0);
    }
    without_place_.push_back(outline);
    return false;
  }

  static double angle_of(const Item& item) {
    const libnest2d::Radians rotation = item.rotation();
    return rotation;
  }

  static bool is_at(const Item& item, const Barred& place) {
    constexpr cInt kNear = 10;
    const IntPoint at = item.translation();
    return angle_of(item) == place.rotation && std::abs(at.X - place.shift.X) <= kNear &&
           std::abs(at.Y - place.shift.Y) <= kNear;
  }

  bool lies_on_another() const {
    const auto& items = getItems();
    const Item& last = items.back();
    return std::any_of(items.begin(), items.end() - 1,
                       [&](const Item& other) { return overlap(last, other); });
  }

  std::shared_ptr<std::vector<Item>> walls_;
  std::shared_ptr<std::vector<Barred>> barred_ = std::make_shared<std::vector<Barred>>();
  std::vector<Path> without_place_;
  double free_ = 0.0;
};

/// The box in which the walls stand.
libnest2d::Box box_around(const Room& room) {
  return {IntPoint(-2 * kWall, -2 * kWall),
          IntPoint(room.length + 2 * kWall, room.width + 2 * kWall)};
}

libnest2d::NfpPlacer::Config placing(const Room& room) {
  libnest2d::NfpPlacer::Config config;
  using std::numbers::pi;
  config.rotations = {0.0, pi};
  if (!room.half_turns_only) config.rotations = {0.0, 0.5 * pi, pi, 1.5 * pi};
  config.alignment = libnest2d::NfpPlacer::Config::Alignment::DONT_ALIGN;
  config.accuracy = 1.0f;  // from every corner
  config.object_function = [room](const Item& item) {
    const auto box = item.boundingBox();
    const IntPoint low = box.minCorner(), high = box.maxCorner();
    if (low.X < 0 || low.Y < 0 || high.X > room.length || high.Y > room.width) return kNoPlace;
    const double wide = static_cast<double>(room.width);
    return static_cast<double>(high.X) + 0.1 * static_cast<double>(high.Y) / wide;
  };
  return config;
}

}  // namespace

std::vector<std::vector<Position>> lay_out(const std::vector<Shape>& shapes, const Room& room,
                                           const Progress& progress) {
  if (shapes.empty()) return {};
  const NoFitPolygonsOfRun polygons;
  std::vector<Item> items;
  std::vector<int> shape_of;
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    for (int i = 0; i < shapes[s].count; ++i) {
      items.emplace_back(closed_clockwise(shapes[s].outline));
      shape_of.push_back(static_cast<int>(s));
    }
  }
  const auto count = static_cast<double>(items.size());
  libnest2d::NestControl control(
      [&](unsigned left) { progress.at("nesting", 1.0 - static_cast<double>(left) / count); });
  control.stopcond = [&] { return progress.should_stop(); };
  const std::size_t rooms = libnest2d::nest<WalledPlacer, libnest2d::FirstFitSelection>(
      items, box_around(room), 0, placing(room), control);
  std::vector<std::vector<Position>> laid(rooms);
  if (progress.should_stop()) return {};
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].binId() < 0) continue;
    const libnest2d::Radians rotation = items[i].rotation();
    const double turns = double(rotation) / (0.5 * std::numbers::pi);
    laid[items[i].binId()].push_back(
        {shape_of[i], static_cast<int>(std::lround(turns)) % 4, items[i].translation()});
  }
  return laid;
}

}  // namespace planish::nest_detail
