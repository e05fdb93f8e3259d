#include "skins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace planish::brep {
namespace {

/// A smaller dihedral angle beside a bend is a tangent transition: CAD systems hold tangency to
/// 0.1°, but radii rounded by hand leave some degrees…
constexpr double kSmooth = 0.0873;  // 5°
/// …but two planes are one flange only when they are parallel, as bends of less are not made.
constexpr double kSamePlane = 0.002;  // 0.1°
/// A face is a skin when this share of it has material of the sheet's thickness below.
constexpr double kCovered = 0.3;

struct Pair {
  int a = 0;
  int b = 0;
  Opposite opposite;
};

bool boxes_near(const Outline& a, const Outline& b, double reach) {
  return ((a.lo.array() - reach) <= b.hi.array()).all() &&
         ((b.lo.array() - reach) <= a.hi.array()).all();
}

/// Each large face votes for the depth of its nearest opposite, with the area they share.
class ThicknessPoll {
 public:
  ThicknessPoll(const SolidModel& model, const std::vector<Outline>& outlines, double tolerance)
      : model_(model),
        outlines_(outlines),
        tolerance_(tolerance),
        count_(static_cast<int>(model.faces.size())) {}

  std::vector<double> run() {
    for (const int a : largest_faces())
      vote(a);
    std::vector<std::pair<double, double>> rows = clusters();
    std::sort(rows.begin(), rows.end(),
              [](const auto& a, const auto& b) { return a.second > b.second; });
    constexpr double kWorthTrying = 0.15;  // of the heaviest
    constexpr size_t kMost = 3;
    std::vector<double> depths;
    for (const auto& [depth, weight] : rows)
      if (depths.size() < kMost && weight >= kWorthTrying * rows.front().second)
        depths.push_back(depth);
    return depths;
  }

 private:
  const Outline& outline(int face) const { return outlines_[face]; }

  /// The faces that decide: large ones hold the vote, and their number bounds the cost.
  std::vector<int> largest_faces() const {
    constexpr size_t kVoters = 60;
    constexpr double kWorthwhile = 0.05;  // of the largest face
    std::vector<int> faces;
    double largest = 0.0;
    for (const Outline& face : outlines_)
      largest = std::max(largest, face.area);
    for (int f = 0; f < count_; ++f)
      if (!outline(f).flat.empty() && (!general(f) || outline(f).area > kWorthwhile * largest))
        faces.push_back(f);
    std::sort(faces.begin(), faces.end(),
              [&](int a, int b) { return outline(a).area > outline(b).area; });
    if (faces.size() > kVoters) faces.resize(kVoters);
    return faces;
  }

  /// General surfaces are dear to compare, and most are walls of engraved letters: small ones are
  /// not asked.
  bool general(int f) const {
    const auto* surface = std::get_if<Developable>(&model_.faces[f].surface);
    return surface && std::holds_alternative<Ruled>(*surface);
  }

  void vote(int a) {
    double nearest = std::numeric_limits<double>::infinity();
    double weight = 0.0;
    for (int b = 0; b < count_; ++b) {
      if (a == b || outline(b).flat.empty()) continue;
      const auto seen = opposite(model_, outlines_, a, b);
      if (!seen || seen->depth <= 0 || seen->depth >= nearest) continue;
      constexpr double kShare = 0.1;  // of the smaller face: less is a chance meeting
      if (seen->overlap < kShare * std::min(outline(a).area, outline(b).area)) continue;
      if (seen->spread > 0.1 * seen->depth) continue;
      nearest = seen->depth;
      weight = seen->overlap;
    }
    if (weight > 0) votes_.emplace_back(nearest, weight);
  }

  /// Votes within the tolerance of each other, with their mean depth and total weight.
  std::vector<std::pair<double, double>> clusters() {
    std::sort(votes_.begin(), votes_.end());
    std::vector<std::pair<double, double>> rows;
    for (size_t first = 0; first < votes_.size();) {
      double weight = 0.0;
      double moment = 0.0;
      size_t i = first;
      for (; i < votes_.size() && votes_[i].first <= votes_[first].first * (1 + tolerance_); ++i) {
        weight += votes_[i].second;
        moment += votes_[i].first * votes_[i].second;
      }
      rows.emplace_back(moment / weight, weight);
      first = i;
    }
    return rows;
  }

  const SolidModel& model_;
  const std::vector<Outline>& outlines_;
  double tolerance_;
  int count_;
  std::vector<std::pair<double, double>> votes_;  // depth, area
};

class SkinFinder {
 public:
  SkinFinder(const SolidModel& model, const std::vector<Outline>& outlines, double thickness,
             double tolerance)
      : model_(model),
        outlines_(outlines),
        tolerance_(tolerance),
        count_(static_cast<int>(model.faces.size())),
        order_(static_cast<size_t>(count_)) {
    skins_.thickness = thickness;
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(),
              [&](int a, int b) { return outline(a).lo.x() < outline(b).lo.x(); });
  }

  Result<Skins> run() {
    pair_faces();
    find_rounded_outsides();
    find_sharp_edges();
    label_components();
    return settle();
  }

 private:
  const Outline& outline(int face) const { return outlines_[face]; }
  const SolidFace& face(int index) const { return model_.faces[index]; }

  double slack() const { return tolerance_ * skins_.thickness; }

  /// All pairs at the thickness; faces are swept along x so that only near ones meet.
  void pair_faces() {
    skins_.partners.assign(static_cast<size_t>(count_), {});
    covered_.assign(static_cast<size_t>(count_), 0.0);
    const double reach = skins_.thickness + slack();
    double longest = 0.0;
    for (int f = 0; f < count_; ++f)
      longest = std::max(longest, outline(f).hi.x() - outline(f).lo.x());
    for (size_t i = 0; i < order_.size(); ++i) {
      const int a = order_[i];
      if (outline(a).flat.empty()) continue;
      for (size_t j = i + 1; j < order_.size(); ++j) {
        const int b = order_[j];
        if (outline(b).lo.x() > outline(a).hi.x() + reach) break;
        if (!outline(b).flat.empty() && boxes_near(outline(a), outline(b), reach)) try_pair(a, b);
      }
    }
  }

  void try_pair(int a, int b) {
    const auto seen = opposite(model_, outlines_, a, b);
    if (!seen || std::abs(seen->depth - skins_.thickness) > slack() || seen->spread > slack())
      return;
    const auto back = opposite(model_, outlines_, b, a);
    if (!back) return;
    skins_.partners[a].push_back(b);
    skins_.partners[b].push_back(a);
    covered_[a] += seen->overlap / outline(a).area;
    covered_[b] += back->overlap / outline(b).area;
    depths_.push_back({a, b, *seen});
  }

  bool candidate(int f) const { return covered_[f] >= kCovered; }

  /// Concave edges of two candidates whose partners are bridged by a cylinder about that edge: the
  /// rounded outside of a bend with zero inside radius. It counts as skin although nothing faces
  /// it.
  void find_rounded_outsides() {
    for (size_t e = 0; e < model_.edges.size(); ++e) {
      const auto angle = dihedral(model_, static_cast<int>(e));
      if (!angle || *angle > -kSmooth) continue;
      const auto& [f, g] = model_.edges[e].faces;
      if (!candidate(f) || !candidate(g)) continue;
      for (int c = 0; c < count_; ++c)
        if (!candidate(c) && rounds(c, static_cast<int>(e)))
          rounded_.emplace_back(static_cast<int>(e), c);
    }
    for (const auto& [edge, c] : rounded_)
      covered_[c] = 1.0;
  }

  bool rounds(int c, int edge) const {
    const auto* surface = std::get_if<Developable>(&face(c).surface);
    const auto* cylinder = surface ? std::get_if<Cylinder>(surface) : nullptr;
    if (!cylinder || face(c).sense < 0 || std::abs(cylinder->radius - skins_.thickness) > slack())
      return false;
    const SpaceCurve& curve = model_.edges[edge].curve;
    const auto off_axis = [&](const Vec3& p) { return cylinder->frame.local(p).head<2>().norm(); };
    if (curve.kind != SpaceCurve::Kind::line || off_axis(curve.start) > slack() ||
        off_axis(curve.end) > slack())
      return false;
    const double h0 = cylinder->frame.local(curve.start).z();
    const double h1 = cylinder->frame.local(curve.end).z();
    const Box2& box = outline(c).box;
    return std::max(h0, h1) > box.lo.y() && std::min(h0, h1) < box.hi.y();
  }

  /// Edges at which a skin is folded sharply: the partners meet sharply too, the other way round,
  /// or are rounded about the edge. A wall of a cut meets both skins convexly and so is never
  /// taken.
  void find_sharp_edges() {
    std::vector<std::pair<int, double>> bent;
    for (size_t e = 0; e < model_.edges.size(); ++e) {
      const auto angle = dihedral(model_, static_cast<int>(e));
      if (!angle) continue;
      const auto& [f, g] = model_.edges[e].faces;
      if (!candidate(f) || !candidate(g) || smooth_edge(model_, static_cast<int>(e))) continue;
      bent.emplace_back(static_cast<int>(e), *angle);
    }
    for (const auto& [e, angle] : bent) {
      const bool rounded = std::any_of(rounded_.begin(), rounded_.end(),
                                       [e = e](const auto& r) { return r.first == e; });
      const bool mirrored = std::any_of(
          bent.begin(), bent.end(), [&, e = e, angle = angle](const auto& other) {
            return other.first != e && other.second * angle < 0 && opposite_edges(e, other.first);
          });
      if (rounded || mirrored) skins_.sharp.push_back({e, angle < 0, rounded});
    }
  }

  bool partnered(int a, int b) const {
    const auto& row = skins_.partners[a];
    return std::find(row.begin(), row.end(), b) != row.end();
  }

  bool opposite_edges(int e, int other) const {
    const auto& [f, g] = model_.edges[e].faces;
    const auto& [p, q] = model_.edges[other].faces;
    if (!(partnered(f, p) && partnered(g, q)) && !(partnered(f, q) && partnered(g, p)))
      return false;
    const SpaceCurve& a = model_.edges[e].curve;
    const SpaceCurve& b = model_.edges[other].curve;
    // The mitre's length grows with the angle; 150° of bend is 4 thicknesses.
    constexpr double kLongestMitre = 4.0;
    const Vec3 middle = (b.start + b.end) / 2;
    const Vec3 along = (a.end - a.start).normalized();
    const Vec3 d = middle - a.start;
    return (d - d.dot(along) * along).norm() < kLongestMitre * skins_.thickness;
  }

  void label_components() {
    component_.assign(static_cast<size_t>(count_), -1);
    std::vector<std::vector<int>> neighbours(static_cast<size_t>(count_));
    const auto join = [&](int e) {
      const auto& [f, g] = model_.edges[e].faces;
      neighbours[f].push_back(g);
      neighbours[g].push_back(f);
    };
    for (size_t e = 0; e < model_.edges.size(); ++e) {
      const auto angle = dihedral(model_, static_cast<int>(e));
      if (!angle || !smooth_edge(model_, static_cast<int>(e))) continue;
      const auto& [f, g] = model_.edges[e].faces;
      if (candidate(f) && candidate(g)) join(static_cast<int>(e));
    }
    for (const SharpEdge& sharp : skins_.sharp)
      join(sharp.edge);
    for (int f = 0; f < count_; ++f) {
      if (!candidate(f) || component_[f] >= 0) continue;
      const int label = static_cast<int>(component_area_.size());
      component_area_.push_back(0.0);
      std::vector<int> stack{f};
      component_[f] = label;
      while (!stack.empty()) {
        const int at = stack.back();
        stack.pop_back();
        component_area_.back() += outline(at).area;
        for (const int next : neighbours[at])
          if (component_[next] < 0) {
            component_[next] = label;
            stack.push_back(next);
          }
      }
    }
  }

  Result<Skins> settle() {
    if (component_area_.empty())
      return fail(ErrorCode::not_a_sheet,
                  "No face has an opposite one at a common thickness; this is not a sheet.");
    const int first = static_cast<int>(
        std::max_element(component_area_.begin(), component_area_.end()) - component_area_.begin());
    std::vector<double> votes(component_area_.size(), 0.0);
    for (const Pair& pair : depths_) {
      const int a = component_[pair.a];
      const int b = component_[pair.b];
      if (a < 0 || b < 0) continue;
      if (a == first) votes[b] += pair.opposite.overlap;
      if (b == first) votes[a] += pair.opposite.overlap;
    }
    const int second = static_cast<int>(std::max_element(votes.begin(), votes.end()) -
                                        votes.begin());
    if (votes[second] <= 0.0)
      return fail(
          ErrorCode::not_a_sheet,
          "The largest face has no opposite one at a common thickness; this is not a sheet.");
    if (second == first)
      return fail(ErrorCode::unsupported_shape,
                  "Both skins of the sheet run into one another without a cut edge between them.");
    label(first, second);
    return std::move(skins_);
  }

  void label(int first, int second) {
    skins_.side.assign(static_cast<size_t>(count_), Side::none);
    for (int f = 0; f < count_; ++f) {
      const int label = component_[f];
      if (label == first) skins_.side[f] = Side::first;
      if (label == second) skins_.side[f] = Side::second;
    }
    adopt_islands();
    skins_.area_first = component_area_[first];
    skins_.area_second = component_area_[second];
    double lo = std::numeric_limits<double>::infinity();
    double hi = 0.0;
    double weight = 0.0;
    double mean = 0.0;
    for (const Pair& pair : depths_) {
      if (component_[pair.a] != first && component_[pair.b] != first) continue;
      lo = std::min(lo, pair.opposite.depth - pair.opposite.spread / 2);
      hi = std::max(hi, pair.opposite.depth + pair.opposite.spread / 2);
      weight += pair.opposite.overlap;
      mean += pair.opposite.overlap * pair.opposite.depth;
    }
    skins_.thickness = mean / weight;
    skins_.spread = std::max(0.0, hi - lo);
  }

  /// Faces opposite one skin but cut off from the other (a tongue that a bend runs past) belong to
  /// that other skin.
  void adopt_islands() {
    for (int f = 0; f < count_; ++f) {
      if (!candidate(f) || skins_.side[f] != Side::none) continue;
      const auto& partners = skins_.partners[f];
      const auto all_on = [&](Side side) {
        return !partners.empty() && std::all_of(partners.begin(), partners.end(), [&](int p) {
          return component_[p] >= 0 && skins_.side[p] == side;
        });
      };
      if (all_on(Side::first)) islands_.emplace_back(f, Side::second);
      if (all_on(Side::second)) islands_.emplace_back(f, Side::first);
    }
    for (const auto& [f, side] : islands_) {
      skins_.side[f] = side;
      (side == Side::first ? skins_.islands_first : skins_.islands_second) += 1;
    }
  }

  const SolidModel& model_;
  const std::vector<Outline>& outlines_;
  double tolerance_;
  int count_;
  std::vector<int> order_;
  std::vector<std::pair<int, Side>> islands_;
  Skins skins_;
  std::vector<double> covered_;
  std::vector<Pair> depths_;
  std::vector<std::pair<int, int>> rounded_;  // concave edge, cylinder about it
  std::vector<int> component_;
  std::vector<double> component_area_;
};

}  // namespace

std::optional<double> dihedral(const SolidModel& model, int index) {
  const SolidEdge& edge = model.edges[index];
  if (edge.uses != 2 || edge.faces[0] == edge.faces[1]) return {};
  const SolidFace& f = model.faces[edge.faces[0]];
  const SolidFace& g = model.faces[edge.faces[1]];
  if (std::holds_alternative<DoublyCurved>(f.surface) ||
      std::holds_alternative<DoublyCurved>(g.surface))
    return {};
  const double t = (edge.curve.t0 + edge.curve.t1) / 2;
  const Vec3 point = edge.curve.point(t);
  const Vec3 n_f = outward_normal_at(f, point);
  const Vec3 n_g = outward_normal_at(g, point);
  // With f on the left of its run x, the direction into f is n × x.
  const Vec3 x = edge.forward[0] ? edge.curve.tangent(t) : Vec3(-edge.curve.tangent(t));
  const double angle = std::atan2(n_f.cross(n_g).norm(), n_f.dot(n_g));
  return n_g.dot(n_f.cross(x)) > 0 ? -angle : angle;
}

std::vector<double> likely_thicknesses(const SolidModel& model,
                                       const std::vector<Outline>& outlines, double tolerance) {
  return ThicknessPoll(model, outlines, tolerance).run();
}

Result<Skins> find_skins(const SolidModel& model, const std::vector<Outline>& outlines,
                         double thickness, double tolerance) {
  return SkinFinder(model, outlines, thickness, tolerance).run();
}

bool smooth_edge(const SolidModel& model, int index) {
  const auto angle = dihedral(model, index);
  if (!angle) return false;
  const SolidEdge& edge = model.edges[index];
  const auto flat = [&](int f) { return std::holds_alternative<Frame>(model.faces[f].surface); };
  return std::abs(*angle) < (flat(edge.faces[0]) && flat(edge.faces[1]) ? kSamePlane : kSmooth);
}

}  // namespace planish::brep
