// Where the ring of patches is cut into pieces that can be made: at a corner, in the middle of an
// edge, where the weld is shortest (golden section over rulings), or in parts of equal length. A
// cut that would leave a sliver of a patch moves to its end.

#include "seams.hpp"

#include "refusals.hpp"
#include "roots.hpp"

#include <planish/geometry/minimum.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace planish::transition_detail {
namespace {

/// Rulings whose lengths differ by less (a share) are equally long.
constexpr double kAsLong = tolerance::kComputed;
/// A place closer to a corner is at the corner, a narrower part is a sliver: shares of the first
/// profile's length.
constexpr double kAtCorner = tolerance::kComputed;
constexpr double kSliver = tolerance::kComputed;

double length_of(const RuledPatch& patch, double at) {
  const auto [p, q] = patch.ruling(at);
  return (q - p).norm();
}

class Cutter {
 public:
  explicit Cutter(const Ring& ring) : ring_(ring), boundary_(ring.hull->boundaries[0]) {}

  Result<Cut> at(const SeamEdge& seam) const {
    for (const GivenEdge& edge : boundary_.edges)
      if (edge.number == seam.edge) return at_share(edge.element, 0.5 * (edge.from + edge.to));
    return unknown(boundary_.edges.empty() ? refuse::no_edges : refuse::no_such_edge, seam.edge,
                   boundary_.edges, "/seam/edge");
  }

  /// The middle of the patches that turn about the corner, so that both planes beside it stay
  /// whole.
  Result<Cut> at(const SeamCorner& seam) const {
    for (const GivenCorner& corner : boundary_.corners)
      if (corner.number == seam.corner)
        return corner.at == 0.0 ? at_start_of(corner.element) : at_share(corner.element, corner.at);
    return unknown(boundary_.corners.empty() ? refuse::no_corners : refuse::no_such_corner,
                   seam.corner, boundary_.corners, "/seam/corner");
  }

  Result<Cut> at(const SeamParameter& seam) const {
    if (!(seam.parameter >= 0.0 && seam.parameter <= 1.0))
      return fail(refuse::bad_parameter, {{"value", seam.parameter, unit::none},
                                          {"field", place::pointer("/seam/parameter")}});
    const double whole = perimeter();
    return at_length(start_of_profile() + (boundary_.turned ? -1.0 : 1.0) * seam.parameter * whole);
  }

  /// Where the weld is shortest.
  Cut shortest() const {
    Cut best;
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Cut& cut) {
      const double length = length_of(ring_.patch(cut.patch), cut.at);
      if (length >= least * (1.0 - kAsLong)) return;
      least = length;
      best = cut;
    };
    for (int i = 0; i < ring_.count(); ++i) {
      consider({i, 0.0});
      if (!ring_.patch(i).plane())
        consider(shortest_in(i));
      else if (ring_.patch(i).hull_patch().sides[0].moves())
        consider({i, 0.5});
    }
    return best;
  }

  /// The cut where the first profile has run a length from the start of its first element.
  Cut at_length(double length) const {
    const double whole = perimeter();
    length -= whole * std::floor(length / whole);
    const double noise = kAtCorner * whole;
    for (int i = 0; i < boundary_.count(); ++i) {
      const Element& element = boundary_.element(i);
      const double here = length_of(element);
      if (boundary_.corner_at(i) && length <= noise) return at_start_of(i);
      if (length < here - (boundary_.corner_at(i + 1) ? noise : 0.0))
        return in_element(i, parameter_at(element, length));
      length = std::max(0.0, length - here);
    }
    return boundary_.corner_at(0) ? at_start_of(0) : in_element(0, boundary_.element(0).t0);
  }

  double length_at(const Cut& cut) const {
    const RuledPatch& patch = ring_.patch(cut.patch);
    const Stretch& side = patch.hull_patch().sides[0];
    double length = 0.0;
    for (int i = 0; i < side.element; ++i)
      length += length_of(boundary_.element(i));
    const Element& element = boundary_.element(side.element);
    return length + length_between(element, element.t0, side.moves() ? side.t0 : side.t1) +
           patch.border_length(0, 0.0, cut.at);
  }

  double perimeter() const {
    return sum_of(boundary_.elements, [&](const Element& element) { return length_of(element); });
  }

  /// One between every two edges: at corners, or in the middle of the round part between them.
  Result<std::vector<Cut>> between_edges() const {
    std::vector<Cut> cuts;
    double before = 0.0, round = 0.0;
    bool edges = false;
    const int n = boundary_.count();
    int first = 0;
    while (first < n && !boundary_.element(first).straight)
      ++first;
    for (int k = 0; k < n && first < n; ++k) {
      const int i = (first + 1 + k) % n;
      const Element& element = boundary_.element(i);
      if (!element.straight) {
        if (round == 0.0) before = length_before(i);
        round += length_of(element);
        continue;
      }
      edges = true;
      cuts.push_back(round > 0.0 ? at_length(before + 0.5 * round) : at_start_of(i));
      round = 0.0;
    }
    if (edges && cuts.size() > 1) return cuts;
    return fail(refuse::no_sides, {{"field", place::pointer("/pieces")}});
  }

  /// Moves a cut that would leave a sliver of a patch to its end.
  Cut settled(const Cut& cut) const {
    const double sliver = kSliver * perimeter();
    const auto narrow = [&](double from, double to) {
      const RuledPatch& patch = ring_.patch(cut.patch);
      return std::max(patch.border_length(0, from, to), patch.border_length(1, from, to)) <= sliver;
    };
    if (cut.at > 0.0 && narrow(cut.at, 1.0)) return {(cut.patch + 1) % ring_.count(), 0.0};
    return narrow(0.0, cut.at) ? Cut{cut.patch, 0.0} : cut;
  }

 private:
  Cut shortest_in(int number) const {
    const RuledPatch& patch = ring_.patch(number);
    constexpr int kSamples = 32, kSteps = 24;  // a millionth of the patch
    const auto length = [&](double at) { return length_of(patch, at); };
    return {number, least_at(length, 0.0, 1.0, kSamples, kSteps)};
  }

  Cut at_share(int element, double share) const {
    return at_length(length_before(element) + share * length_of(boundary_.element(element)));
  }

  static double length_between(const Element& element, double t0, double t1) {
    return element.straight ? (element.curve(t1).point - element.curve(t0).point).norm()
                            : arc_length(element, t0, t1);
  }
  static double length_of(const Element& element) {
    return length_between(element, element.t0, element.t1);
  }
  static double length_of(const RuledPatch& patch, double at) {
    return transition_detail::length_of(patch, at);
  }

  double length_before(int i) const {
    double length = 0.0;
    for (int k = 0; k < i; ++k)
      length += length_of(boundary_.element(k));
    return length;
  }

  static double parameter_at(const Element& element, double length) {
    if (element.straight)
      return element.t0 + (element.t1 - element.t0) * length / length_of(element);
    return root_between(
        [&](double t) {
          return std::pair{length_between(element, element.t0, t) - length,
                           element.curve(t).derivative.norm()};
        },
        element.t0, element.t1);
  }

  /// The refusal of a number that none of the given edges or corners has.
  template <typename Given>
  static tl::unexpected<Error> unknown(const Refusal& refusal, int number,
                                       const std::vector<Given>& all, const char* key) {
    Facts facts{{"number", number}, {"field", place::pointer(key)}};
    if (!all.empty()) facts.emplace_back("last", std::ranges::max(all, {}, &Given::number).number);
    return fail(refusal, facts);
  }

  /// Length from the boundary's first element to the start of the given profile.
  double start_of_profile() const {
    for (const GivenEdge& edge : boundary_.edges)
      if (edge.number == 0)
        return length_before(edge.element) + (boundary_.turned ? edge.to : edge.from) *
                                                 length_of(boundary_.element(edge.element));
    return 0.0;
  }

  Cut in_element(int element, double t) const {
    const Element& wanted = boundary_.element(element);
    for (int i = 0; i < ring_.count(); ++i) {
      const RuledPatch& patch = ring_.patch(i);
      const Stretch& side = patch.hull_patch().sides[0];
      const Element& here = boundary_.element(side.element);
      if (!side.moves() || here.source != wanted.source || here.straight != wanted.straight)
        continue;
      const double period = wanted.period;
      const double same = period > 0.0 ? t + period * std::ceil((side.t0 - t) / period -
                                                                tolerance::kRounding)
                                       : t;
      if (same < side.t0 || same >= side.t1) continue;
      return {i, std::clamp(patch.ruling_at(0, same), 0.0, 1.0)};
    }
    return {0, 0.0};
  }

  Cut at_start_of(int element) const {
    const Vec3 corner = boundary_.element(element).curve(boundary_.element(element).t0).point;
    std::vector<int> standing;
    int after = 0;  // the patch that continues from the corner
    for (int i = 0; i < ring_.count(); ++i) {
      const Stretch& side = ring_.patch(i).hull_patch().sides[0];
      if (ring_.hull->point(0, side, side.t0) != corner) continue;
      if (side.moves())
        after = i;
      else
        standing.push_back(i);
    }
    const double whole = sum_of(standing, [&](int i) { return ring_.patch(i).turn(0.0, 1.0); });
    if (whole == 0.0) return {standing.empty() ? after : standing[standing.size() / 2], 0.0};
    // Standing patches in order, which may wrap past the ring's end.
    std::ranges::sort(standing, [&](int a, int b) {
      return (a - after + ring_.count()) % ring_.count() <
             (b - after + ring_.count()) % ring_.count();
    });
    double turned = 0.0;
    for (const int i : standing) {
      const double here = ring_.patch(i).turn(0.0, 1.0);
      if (turned + here >= 0.5 * whole) {
        const double left = 0.5 * whole - turned;
        const double at = root_between(
            [&](double ruling) {
              return std::pair{ring_.patch(i).turn(0.0, ruling) - left, here};
            },
            0.0, 1.0);
        return {i, at};
      }
      turned += here;
    }
    return {after, 0.0};
  }

  const Ring& ring_;
  const Boundary& boundary_;
};

}  // namespace

Result<std::vector<Cut>> cuts_of(const Ring& ring, const std::optional<Seam>& seam,
                                 Division pieces) {
  const Cutter cutter(ring);
  std::vector<Cut> cuts;
  if (pieces == Division::per_side) {
    auto sides = cutter.between_edges();
    if (!sides) return sides;
    cuts = std::move(*sides);
  } else {
    const Result<Cut> first = seam ? std::visit([&](const auto& given) { return cutter.at(given); },
                                                *seam)
                                   : Result<Cut>(cutter.shortest());
    if (!first) return pass_on(first);
    cuts = {*first};
    if (pieces == Division::two)
      cuts.push_back(cutter.at_length(cutter.length_at(*first) + 0.5 * cutter.perimeter()));
  }
  for (Cut& cut : cuts)
    cut = cutter.settled(cut);
  std::ranges::sort(cuts);
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

Ring begun_at(const Ring& ring, double at, double tolerance) {
  const RuledPatch& patch = ring.patch(0);
  HullPatch begun = patch.hull_patch();
  const std::vector<std::array<double, 2>> stops = std::move(begun.stops);
  const std::array<double, 2> start{patch.parameter(0, at), patch.parameter(1, at)};
  const std::array<double, 2> period{stops.back()[0] - stops.front()[0],
                                     stops.back()[1] - stops.front()[1]};
  begun.stops = {start};
  for (const auto& stop : stops)
    if (stop[0] > start[0] && stop[1] > start[1]) begun.stops.push_back(stop);
  for (std::size_t i = 1; i < stops.size(); ++i)
    if (stops[i][0] <= start[0] || stops[i][1] <= start[1])
      begun.stops.push_back({stops[i][0] + period[0], stops[i][1] + period[1]});
  begun.stops.push_back({start[0] + period[0], start[1] + period[1]});
  for (std::size_t side = 0; side < 2; ++side) {
    begun.sides[side].t0 = begun.stops.front()[side];
    begun.sides[side].t1 = begun.stops.back()[side];
  }
  return {ring.hull, {RuledPatch(ring.hull, begun, tolerance)}, ring.size};
}

std::vector<PatchPart> parts_between(const Ring& ring, const Cut& begin, const Cut& end) {
  std::vector<PatchPart> parts;
  const auto add = [&](int patch, double from, double to) {
    if (to > from) parts.push_back({patch % ring.count(), from, to});
  };
  if (begin.patch == end.patch && begin.at < end.at) {
    add(begin.patch, begin.at, end.at);
    return parts;
  }
  add(begin.patch, begin.at, 1.0);
  for (int i = begin.patch + 1; i % ring.count() != end.patch; ++i)
    add(i, 0.0, 1.0);
  add(end.patch, 0.0, end.at);
  return parts;
}

double fold_between(const Ring& ring, const PatchPart& before, const PatchPart& after) {
  const Vec3 a = ring.patch(before.patch).normal(before.to),
             b = ring.patch(after.patch).normal(after.from);
  const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
  return angle > kNoFold ? angle : 0.0;
}

double open_seam(const Ring& ring, std::vector<PatchPart>& parts) {
  constexpr double kHalfOpen = 0.005;  // mm
  const auto step = [&](const PatchPart& part) {
    const RuledPatch& patch = ring.patch(part.patch);
    const double width = std::max(patch.border_length(0, part.from, part.to),
                                  patch.border_length(1, part.from, part.to));
    return std::min(kHalfOpen / width, 0.25) * (part.to - part.from);
  };
  PatchPart &first = parts.front(), &last = parts.back();
  const double begin = first.from + step(first), end = last.to - step(last);
  const double area = ring.patch(first.patch).area(first.from, begin) +
                      ring.patch(last.patch).area(end, last.to);
  first.from = begin;
  last.to = end;
  return area;
}

}  // namespace planish::transition_detail
