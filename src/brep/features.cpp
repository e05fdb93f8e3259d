#include "features.hpp"

#include "borders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace planish::brep {
namespace {

double loop_area(const BorderLoop& borders) {
  double sum = 0.0;
  for (const Border& border : borders)
    sum += green_area(border.curve);
  return std::abs(sum);
}

Box2 extent(const BorderLoop& borders) {
  Box2 box;
  for (const Border& border : borders)
    box.add(bounds(border.curve));
  return box;
}

class FeatureFinder {
 public:
  FeatureFinder(Sheet& sheet, const SheetMap& map, const Recognition& of)
      : sheet_(sheet),
        of_(of),
        model_(of.model),
        outlines_(of.outlines),
        map_(map),
        widened_(map.widened) {}

  void run() {
    for (size_t p = 0; p < of_.rim.parts.size(); ++p) {
      const RimPart& part = of_.rim.parts[p];
      const auto& here = of_.side == Side::first ? part.first : part.second;
      const auto& there = of_.side == Side::first ? part.second : part.first;
      if (!part.within && !here.empty()) {
        mark(static_cast<int>(p), here, "formed", part.refusal);
        measure_form(part);
      } else if (part.within && there.empty() && !here.empty()) {
        mark(static_cast<int>(p), here, "pocket",
             {ErrorCode::not_a_sheet,
              fmt::format("A recess at face {} opens the outer contour on one skin only.",
                          part.faces.front() + 1),
              fmt::format("face {}", part.faces.front() + 1)});
        measure_form(part);
      } else if (here.empty()) {
        if (part.within || !formed_here(part))
          for (const LoopRef& ref : there)
            add_far_outline(part, ref, part.within ? "pocket" : "formed");
        measure_form(part);
      } else if (part.within && here.size() == 1 && there.size() == 1) {
        compare_openings(part, here.front(), there.front());
      }
    }
    add_chamfered_rims();
  }

 private:
  const SolidFace& solid_face(int f) const { return model_.faces[f]; }
  FaceId face_id(int f) const { return map_.face_id[f]; }
  Face& face_of(int f) { return sheet_.faces[face_id(f)]; }

  void mark(int part, const std::vector<LoopRef>& loops, const char* kind, const Error& at_rim) {
    FormedFeature feature;
    feature.kind = kind;
    feature.source_face = of_.rim.parts[part].faces.front() + 1;
    feature.face = face_id(loops.front().face);
    feature.at_rim = at_rim;
    const FeatureId index{static_cast<int>(sheet_.features.size())};
    for (const LoopRef& ref : loops)
      for (const CoEdge& use : solid_face(ref.face).loops[ref.loop]) {
        const auto& faces = model_.edges[use.edge].faces;
        const int other = faces[0] == ref.face ? faces[1] : faces[0];
        if (other < 0 || of_.rim.part_of[other] != part) continue;
        const BorderRef border = map_.borders.at({ref.face, use.edge, use.forward});
        sheet_[border].feature = index;
      }
    sheet_.features.push_back(std::move(feature));
  }

  /// Whether a form that leaves the sheet also shows on the reference skin (an emboss has two
  /// sides).
  bool formed_here(const RimPart& part) const {
    const auto [lo, hi] = box_of(part);
    return std::any_of(
        of_.rim.parts.begin(), of_.rim.parts.end(), [&, lo = lo, hi = hi](const RimPart& other) {
          const auto& loops = of_.side == Side::first ? other.first : other.second;
          if (&other == &part || other.within || loops.empty()) return false;
          const auto [other_lo, other_hi] = box_of(other);
          return (lo.array() <= other_hi.array()).all() && (other_lo.array() <= hi.array()).all();
        });
  }

  std::pair<Vec3, Vec3> box_of(const RimPart& part) const {
    Vec3 lo = outlines_[part.faces.front()].lo;
    Vec3 hi = outlines_[part.faces.front()].hi;
    for (const int f : part.faces) {
      lo = lo.cwiseMin(outlines_[f].lo);
      hi = hi.cwiseMax(outlines_[f].hi);
    }
    return {lo.array() - sheet_.thickness, hi.array() + sheet_.thickness};
  }

  /// A recess in, or a boss on, the other skin: drawn where it lies, seen through the sheet.
  void add_far_outline(const RimPart& part, const LoopRef& ref, const char* kind) {
    const bool opening = outer_loop(outlines_[ref.face]) != ref.loop;
    if (!opening || !std::holds_alternative<Frame>(solid_face(ref.face).surface)) return;
    const Vec3 first = outlines_[ref.face].rings[ref.loop].front();
    for (const int partner : of_.skins.partners[ref.face]) {
      const Outline& outline = outlines_[partner];
      if (of_.skins.side[partner] != of_.side ||
          !std::holds_alternative<Frame>(solid_face(partner).surface))
        continue;
      const Face& face = face_of(partner);
      const double reach = sheet_.thickness;
      if (((outline.lo.array() - reach) > first.array()).any() ||
          ((outline.hi.array() + reach) < first.array()).any())
        continue;
      FormedFeature feature;
      feature.kind = kind;
      feature.source_face = part.faces.front() + 1;
      feature.face = face_id(partner);
      feature.outlines.push_back(projected_loop(ref, std::get<Frame>(face.surface)));
      sheet_.features.push_back(std::move(feature));
      return;
    }
  }

  /// An opening that is wider on one skin (countersink, chamfered hole) is cut to the narrowest
  /// section; the wider outlines are drawn, and so is the far one of a slanted cut. Both loops must
  /// be openings of planar faces.
  void compare_openings(const RimPart& part, const LoopRef& here, const LoopRef& there) {
    if (!opening_in_plane(here) || !opening_in_plane(there)) return;
    const CoEdge& first_use = solid_face(here.face).loops[here.loop].front();
    const BorderRef first = map_.borders.at({here.face, first_use.edge, first_use.forward});
    Face& face = face_of(here.face);
    const auto& frame = std::get<Frame>(face.surface);
    BorderLoop& own = face.loops[first.loop];
    BorderLoop mine = read_borders(model_, solid_face(here.face).loops[here.loop], frame, 0.0,
                                   of_.tolerance);
    BorderLoop theirs = projected_loop(there, frame);
    constexpr double kWider = 1.001;  // area ratio that drilling noise does not reach
    if (loop_area(theirs) * kWider < loop_area(own)) own = theirs;
    FormedFeature feature;
    feature.kind = "countersink";
    feature.source_face = part.faces.front() + 1;
    feature.face = first.face;
    for (const BorderLoop* wider : {&mine, &theirs})
      if (loop_area(*wider) > kWider * loop_area(own)) feature.outlines.push_back(*wider);
    if (!feature.outlines.empty()) {
      measure_opening(part, {here, there}, loop_area(own));
      widened_.erase({here.face, here.loop});
    } else if (shifted(mine, theirs)) {
      feature.kind = "slanted cut";
      feature.outlines.push_back(std::move(theirs));
    } else {
      return;
    }
    sheet_.features.push_back(std::move(feature));
  }

  bool shifted(const BorderLoop& a, const BorderLoop& b) const {
    constexpr double kSlope = 0.05;  // 3°: more than draft and rounding make
    const Box2 first = extent(a);
    const Box2 second = extent(b);
    return std::max((first.lo - second.lo).norm(), (first.hi - second.hi).norm()) >
           kSlope * sheet_.thickness;
  }

  bool opening_in_plane(const LoopRef& ref) const {
    return std::holds_alternative<Frame>(solid_face(ref.face).surface) &&
           outer_loop(outlines_[ref.face]) != ref.loop;
  }

  /// Plane of a skin and what a loop in it encloses.
  struct Cover {
    double height = 0.0;  ///< of the plane over the model's centre
    double area = 0.0;
  };
  Cover cover(const LoopRef& ref) const {
    const auto& plane = std::get<Frame>(solid_face(ref.face).surface);
    return {(plane.origin - model_.centre).dot(plane.z),
            loop_area(read_borders(model_, solid_face(ref.face).loops[ref.loop], plane, 0.0,
                                   of_.tolerance))};
  }

  double volume_under(const RimPart& part) const {
    double sum = 0.0;
    for (const int f : part.faces)
      sum += solid_face(f).volume;
    return sum;
  }

  /// What a form holds more than the plain sheet that its outlines cover would: by the divergence
  /// theorem its faces' volumes less those of the covers.
  void measure_form(const RimPart& part) {
    double excess = volume_under(part);
    for (const auto* loops : {&part.first, &part.second})
      for (const LoopRef& ref : *loops) {
        if (!opening_in_plane(ref)) {
          sheet_.forms_volume.reset();
          return;
        }
        const Cover over = cover(ref);
        excess -= over.area * over.height / 3;
      }
    add_volume(excess);
  }

  /// The same for an opening that is cut with the area `cut`: covers are the rings around it, and
  /// the wall of a straight opening takes 2/3 of its volume (the plug's caps have the other third).
  void measure_opening(const RimPart& part, const std::array<LoopRef, 2>& loops, double cut) {
    double excess = volume_under(part);
    double depth = 0.0;
    for (const LoopRef& ref : loops) {
      const Cover over = cover(ref);
      excess -= (over.area - cut) * over.height / 3;
      depth += over.height;
    }
    add_volume(excess + cut * depth * 2 / 3);
  }

  /// Chamfers and fillets left over are on the outer contour: the skin's own outline is drawn.
  void add_chamfered_rims() {
    for (const auto& [f, l] : widened_) {
      const auto* plane = std::get_if<Frame>(&face_of(f).surface);
      sheet_.forms_volume.reset();
      FormedFeature feature;
      feature.kind = "chamfer";
      feature.source_face = f + 1;
      feature.face = face_id(f);
      if (plane)
        feature.outlines.push_back(
            read_borders(model_, solid_face(f).loops[l], *plane, 0.0, of_.tolerance));
      sheet_.features.push_back(std::move(feature));
    }
  }

  /// A loop of the other skin seen on this one: run the other way round, a thickness below.
  BorderLoop projected_loop(const LoopRef& ref, const Frame& plane) const {
    std::vector<CoEdge> loop = solid_face(ref.face).loops[ref.loop];
    std::reverse(loop.begin(), loop.end());
    for (CoEdge& use : loop)
      use.forward = !use.forward;
    BorderLoop borders = read_borders(model_, loop, plane, 0.0, of_.tolerance);
    for (Border& border : borders)
      border.edge_depth = sheet_.thickness;
    return borders;
  }

  void add_volume(double volume) {
    if (sheet_.forms_volume) *sheet_.forms_volume += volume;
  }

  Sheet& sheet_;
  const Recognition& of_;
  const SolidModel& model_;
  const std::vector<Outline>& outlines_;
  const SheetMap& map_;
  std::set<std::pair<int, int>> widened_;  // left for add_chamfered_rims
};

}  // namespace

void add_features(Sheet& sheet, const SheetMap& map, const Recognition& of) {
  FeatureFinder(sheet, map, of).run();
}

}  // namespace planish::brep
