#include "ruled_triangles.hpp"

#include "kernel_points.hpp"

#include <planish/base/tolerance.hpp>

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

// Triangles of a face between rulings. The kernel fills such faces with points inside, which a
// surface that is straight along its rulings does not need. Borders become chords in (u, v), and
// rulings go through all of their ends, and further ones until a strip is flat enough. Within a
// strip the chords are in order along v, and the face lies between the first and the second, the
// third and the fourth: each such part is a trapezium.

namespace planish::brep {
namespace {

/// A straight piece of a border in (u, v), a.x() < b.x().
struct Chord {
  Vec2 a, b;

  double at(double u) const {
    if (u <= a.x()) return a.y();
    if (u >= b.x()) return b.y();
    return std::lerp(a.y(), b.y(), (u - a.x()) / (b.x() - a.x()));
  }
};

Handle(Geom_BSplineSurface) rails_of(const TopoDS_Face& face) {
  TopLoc_Location place;
  return Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face, place));
}

class Strips {
 public:
  Strips(MeshOfFaces& to, const TopoDS_Face& face, int number, double chord)
      : to_(to),
        surface_(rails_of(face)),
        motion_(face.Location().Transformation()),
        turned_(face.Orientation() == TopAbs_REVERSED),
        number_(number),
        chord_(chord) {
    double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
    surface_->Bounds(u0, u1, v0, v1);
    same_ = tolerance::kRounding * (u1 - u0);
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
      add_border(TopoDS::Edge(edges.Current()), face);
  }

  void append() {
    const std::vector<double> rulings = rulings_through_ends();
    std::ranges::sort(chords_, {}, [](const Chord& chord) { return chord.a.x(); });
    std::vector<Chord> crossing;
    auto next = chords_.begin();
    for (std::size_t i = 0; i + 1 < rulings.size(); ++i) {
      const double from = rulings[i], to = rulings[i + 1], middle = 0.5 * (from + to);
      std::erase_if(crossing, [&](const Chord& chord) { return chord.b.x() <= middle; });
      for (; next != chords_.end() && next->a.x() < middle; ++next)
        if (next->b.x() > middle) crossing.push_back(*next);
      std::ranges::sort(crossing, {}, [&](const Chord& chord) { return chord.at(middle); });
      for (std::size_t j = 0; j + 1 < crossing.size(); j += 2)
        append_part(crossing[j], crossing[j + 1], from, to, kHalvings);
    }
  }

 private:
  static constexpr int kHalvings = 10;

  Vec3 point(const Vec2& uv) const {
    return vector_of(surface_->Value(uv.x(), uv.y()).Transformed(motion_));
  }

  void add_border(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    double first = 0.0, last = 0.0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (curve.IsNull()) return;
    const auto at = [&](double s) -> Vec2 {
      const gp_Pnt2d p = curve->Value(s);
      return {p.X(), p.Y()};
    };
    // What is even about its middle has another extreme in the parts.
    constexpr int kParts = 4;
    for (int i = 0; i < kParts; ++i) {
      const double from = std::lerp(first, last, double(i) / kParts),
                   to = std::lerp(first, last, double(i + 1) / kParts);
      add_chords(at, {from, to}, at(from), at(to), kHalvings);
    }
  }

  void add_chords(const auto& at, std::array<double, 2> range, const Vec2& a, const Vec2& b,
                  int halvings) {
    const double middle = 0.5 * (range[0] + range[1]);
    const Vec2 between = at(middle);
    const Vec3 chord = 0.5 * (point(a) + point(b));
    // Half for the chord, half for the strips.
    if (halvings == 0 || (point(between) - chord).norm() <= 0.5 * chord_) {
      if (std::abs(b.x() - a.x()) > same_)
        chords_.push_back(a.x() < b.x() ? Chord{a, b} : Chord{b, a});
      return;
    }
    add_chords(at, {range[0], middle}, a, between, halvings - 1);
    add_chords(at, {middle, range[1]}, between, b, halvings - 1);
  }

  std::vector<double> rulings_through_ends() const {
    std::vector<double> ends;
    for (const Chord& chord : chords_) {
      ends.push_back(chord.a.x());
      ends.push_back(chord.b.x());
    }
    std::ranges::sort(ends);
    std::vector<double> rulings;
    for (const double u : ends)
      if (rulings.empty() || u > rulings.back() + same_) rulings.push_back(u);
    return rulings;
  }

  /// Between two chords from one ruling to another, halved until it is nearly plane.
  void append_part(const Chord& low, const Chord& high, double from, double to, int halvings) {
    const std::array<Vec2, 4> uv{Vec2(from, low.at(from)), Vec2(to, low.at(to)),
                                 Vec2(to, high.at(to)), Vec2(from, high.at(from))};
    std::array<Vec3, 4> corners;
    std::ranges::transform(uv, corners.begin(), [&](const Vec2& p) { return point(p); });
    const double middle = 0.5 * (from + to);
    const auto [p, q, r, s] = corners;
    const double off = std::max((point({middle, low.at(middle)}) - 0.5 * (p + q)).norm(),
                                (point({middle, high.at(middle)}) - 0.5 * (s + r)).norm());
    const Vec3 across = (r - p).cross(s - q);
    const double apart = std::abs(across.normalized().dot(q - p));  // the diagonals
    if (halvings > 0 && std::max(off, apart) > 0.5 * chord_) {
      append_part(low, high, from, middle, halvings - 1);
      append_part(low, high, middle, to, halvings - 1);
      return;
    }
    const std::array<int, 4> at{added(p), added(q), added(r), added(s)};
    append_triangle(at[0], at[1], at[2]);
    append_triangle(at[0], at[2], at[3]);
  }

  int added(const Vec3& p) {
    to_.mesh.points.push_back(p);
    return static_cast<int>(to_.mesh.points.size()) - 1;
  }

  void append_triangle(int a, int b, int c) {
    const auto at = [&](int corner) -> const Vec3& { return to_.mesh.points[corner]; };
    if ((at(b) - at(a)).cross(at(c) - at(a)).norm() == 0.0) return;
    if (turned_) std::swap(b, c);
    to_.mesh.triangles.push_back({a, b, c});
    to_.face.push_back(number_);
  }

  MeshOfFaces& to_;
  const Handle(Geom_BSplineSurface) surface_;
  const gp_Trsf motion_;
  const bool turned_;
  const int number_;
  const double chord_;
  double same_ = 0.0;  ///< of u: rulings nearer to each other are one
  std::vector<Chord> chords_;
};

}  // namespace

bool joins_rails(const TopoDS_Face& face) {
  const Handle(Geom_BSplineSurface) surface = rails_of(face);
  return !surface.IsNull() && !surface->IsURational() && !surface->IsVRational() &&
         !surface->IsUPeriodic() && !surface->IsVPeriodic() && surface->VDegree() == 1 &&
         surface->NbVPoles() == 2;
}

void append_ruled_triangles(MeshOfFaces& to, const TopoDS_Face& face, int number, double chord) {
  Strips(to, face, number, chord).append();
}

}  // namespace planish::brep
