#include "seams.hpp"
#include "surface_mesh.hpp"
#include "tip_cuts.hpp"

#include <planish/transition/transition.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace planish {
namespace {

using namespace transition_detail;

/// How far the neutral surface lies outside the face that the sizes are given for.
double set_off(const TransitionSpec& spec) {
  const double share = spec.sizes_are == SizesAre::inside ? 0.0
                       : spec.sizes_are == SizesAre::mid  ? 0.5
                                                          : 1.0;
  return (spec.k_factor - share) * spec.thickness;
}

Result<void> check_numbers(const TransitionSpec& spec) {
  if (!(spec.thickness > 0.0) || !std::isfinite(spec.thickness))
    return fail(ErrorCode::invalid_input,
                fmt::format("the thickness is {} mm; it must be above 0", spec.thickness),
                "/thickness");
  if (!(spec.k_factor >= 0.0 && spec.k_factor <= 1.0))
    return fail(ErrorCode::invalid_input,
                fmt::format("the K-factor is {}; it must be from 0 to 1", spec.k_factor),
                "/k_factor");
  const auto* count = std::get_if<PressCount>(&spec.pressing);
  const auto* angle = std::get_if<PressAngle>(&spec.pressing);
  const auto* chord = std::get_if<PressChord>(&spec.pressing);
  if ((count && count->count < 1) || (angle && !(angle->largest > Angle())) ||
      (chord && !(chord->largest > 0.0)))
    return fail(ErrorCode::invalid_input,
                "press lines need a count, a largest angle or a chord above 0", "/press_lines");
  return {};
}

Result<void> check_frame(const Frame& frame, const char* where) {
  for (const Vec3& v : {frame.origin, frame.x, frame.y, frame.z})
    if (!v.allFinite())
      return fail(ErrorCode::invalid_input, "a coordinate of the frame is not a finite number",
                  where);
  return {};
}

double extent_of(const std::array<Boundary, 2>& boundaries) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Boundary& boundary : boundaries)
    for (const Element& element : boundary.elements) {
      const Vec3 p = element.curve(element.t0).point;
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  return (high - low).norm();
}

Vec3 middle_of(const Boundary& boundary) {
  Vec3 sum = Vec3::Zero();
  for (const Element& element : boundary.elements)
    sum += element.curve(element.t0).point;
  return sum / boundary.count();
}

/// Both boundaries, the first one's axis towards the second, the second one's on.
Result<std::array<Boundary, 2>> boundaries_of(const TransitionSpec& spec) {
  const double outwards = set_off(spec);
  const auto first = boundary_of(spec.from, outwards, spec.from.frame.z, "/from/profile");
  if (!first) return tl::unexpected(first.error());
  const auto second = boundary_of(spec.to, outwards, spec.to.frame.z, "/to/profile");
  if (!second) return tl::unexpected(second.error());
  const Vec3 towards = middle_of(*second) - middle_of(*first);
  return std::array{*boundary_of(spec.from, outwards, towards, "/from/profile"),
                    *boundary_of(spec.to, outwards, towards, "/to/profile")};
}

Result<Ring> ring_of(const TransitionSpec& spec, const TransitionOptions& options, double& size) {
  auto boundaries = boundaries_of(spec);
  if (!boundaries) return tl::unexpected(boundaries.error());
  size = extent_of(*boundaries);
  auto hull = lateral_hull(std::move((*boundaries)[0]), std::move((*boundaries)[1]), size);
  if (!hull) return tl::unexpected(hull.error());
  Ring ring{std::make_shared<const Hull>(std::move(*hull)), {}};
  for (const HullPatch& patch : ring.hull->patches)
    ring.strips.emplace_back(ring.hull, patch, options.tolerance * size);
  return ring;
}

Result<void> check_radii(const Ring& ring, const TransitionSpec& spec) {
  const double inside = spec.k_factor * spec.thickness;
  for (const Strip& strip : ring.strips) {
    if (strip.plane()) continue;
    const double radius = strip.smallest_radii(0.0, 1.0).end;
    if (radius > inside) continue;
    return fail(ErrorCode::radius_too_small,
                fmt::format("the thickness of {:.4g} mm is too large: the neutral surface has a "
                            "radius of {:.4g} mm and needs more than "
                            "{:.4g} mm, the part of the thickness that lies inside it",
                            spec.thickness, radius, inside),
                "/thickness");
  }
  return {};
}

/// How many lines a part of a strip is pressed on; nothing where it is rolled.
double wanted_presses(const Strip& strip, double from, double to, const Pressing& pressing) {
  constexpr double kExactly = 1e-9;  // 90° by 10° are 9 lines, whatever rounding says
  const auto lines = [](double amount) { return std::max(1.0, std::ceil(amount - kExactly)); };
  if (const auto* count = std::get_if<PressCount>(&pressing)) {
    if (from == 0.0 && to == 1.0) return count->count;
    // What a seam divides shares the lines.
    const double whole = strip.turn(0.0, 1.0);
    const auto up_to = [&](double at) {
      return std::round(count->count * strip.turn(0.0, at) / whole);
    };
    return std::max(1.0, up_to(to) - up_to(from));
  }
  if (const auto* angle = std::get_if<PressAngle>(&pressing))
    return lines(strip.turn(from, to) / angle->largest.radians());
  if (const auto* chord = std::get_if<PressChord>(&pressing))
    return lines(std::max(strip.border_length(0, from, to), strip.border_length(1, from, to)) /
                 chord->largest);
  return 0.0;
}

/// Errors: `invalid_input`, more lines than anybody presses.
Result<void> check_presses(const Ring& ring, const std::vector<std::vector<StripPart>>& pieces,
                           const Pressing& pressing) {
  constexpr double kMostLines = 2000.0;  // of a bend
  for (const auto& parts : pieces)
    for (const StripPart& part : parts) {
      const Strip& strip = ring.strip(part.strip);
      if (strip.plane()) continue;
      if (const double lines = wanted_presses(strip, part.from, part.to, pressing);
          lines > kMostLines)
        return fail(ErrorCode::invalid_input,
                    fmt::format("a bend would be pressed on {:.4g} lines; {:.0f} are the most: "
                                "give a smaller count, or a larger angle or chord",
                                lines, kMostLines),
                    "/press_lines");
    }
  return {};
}

std::vector<Strip::Press> presses_of(const Strip& strip, double from, double to,
                                     const Pressing& pressing) {
  const int count = static_cast<int>(wanted_presses(strip, from, to, pressing));
  if (count == 0) return {};
  if (!std::holds_alternative<PressChord>(pressing)) return strip.evenly_turned(from, to, count);
  return strip.evenly_along(
      strip.border_length(1, from, to) > strip.border_length(0, from, to) ? 1 : 0, from, to, count);
}

/// Names of points on both profiles, as templates have them.
class RulingNames {
 public:
  /// Points nearer to each other than `near` (mm) are one.
  RulingNames(const Hull& hull, double near) : hull_(hull), near_(near) {}

  /// Of both ends of a ruling, which counts among the true lengths from now on.
  std::array<std::string, 2> add(const std::array<Vec3, 2>& points, const std::string& press) {
    const auto known = std::find_if(lengths.begin(), lengths.end(), [&](const TrueLength& other) {
      return same(other.points[0], points[0]) && same(other.points[1], points[1]);
    });
    if (known != lengths.end()) return {known->from, known->to};
    lengths.push_back({name(0, points[0]), name(1, points[1]), points,
                       (points[1] - points[0]).norm(), piece, press});
    return {lengths.back().from, lengths.back().to};
  }

  std::vector<TrueLength> lengths;
  int piece = 0;  ///< to which rulings belong that are added

 private:
  std::string name(int side, const Vec3& p) {
    const Boundary& boundary = hull_.boundaries[side];
    for (const GivenCorner& corner : boundary.corners) {
      const Element& element = boundary.element(corner.element);
      if (same(element.curve(std::lerp(element.t0, element.t1, corner.at)).point, p))
        return letter(corner.number, side == 0 ? 'A' : 'a');
    }
    auto& known = points_[side];
    const auto found = std::find_if(known.begin(), known.end(),
                                    [&](const Vec3& other) { return same(other, p); });
    const auto number = found - known.begin() + 1;
    if (found == known.end()) known.push_back(p);
    return fmt::format("{}{}", number, side == 0 ? "" : "'");
  }

  static std::string letter(int corner, char first) {
    const std::string rounds = corner < 26 ? "" : std::to_string(corner / 26);
    return std::string(1, static_cast<char>(first + corner % 26)) + rounds;
  }

  bool same(const Vec3& a, const Vec3& b) const { return (a - b).norm() <= near_; }

  const Hull& hull_;
  double near_;
  std::array<std::vector<Vec3>, 2> points_;
};

/// The sheet of one piece.
class PieceMaker {
 public:
  /// Without cuts its tips stay whole, without names its points have no labels.
  PieceMaker(const Ring& ring, const TransitionSpec& spec, const TipCuts* cuts, RulingNames* names)
      : ring_(ring), spec_(spec), cuts_(cuts), names_(names) {
    sheet_.thickness = spec.thickness;
    sheet_.reference_depth = (1.0 - spec.k_factor) * spec.thickness;
  }

  Sheet run(const std::vector<StripPart>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Strip& strip = ring_.strip(parts[i].strip);
      const Strip::Tips tips = cuts_ ? cuts_->of(strip, parts[i].from, parts[i].to) : Strip::Tips{};
      const Strip::Part part = strip.part(parts[i].from, parts[i].to, tips);
      if (i > 0) join(parts[i - 1], parts[i], part);
      add(parts[i], part);
    }
    number_edges();
    return std::move(sheet_);
  }

 private:
  FaceId next_face() const { return static_cast<FaceId>(sheet_.faces.size()); }

  void add(const StripPart& range, const Strip::Part& part) {
    Face face = part.face;
    const Strip& strip = ring_.strip(range.strip);
    std::vector<Strip::Press> presses;
    if (strip.plane()) {
      face.part_of = static_cast<FlangeId>(sheet_.flanges.size());
      sheet_.flanges.push_back({{next_face()}});
    } else {
      presses = presses_of(strip, range.from, range.to, spec_.pressing);
      face.part_of = static_cast<BendId>(sheet_.bends.size());
      sheet_.bends.push_back(bend_of(strip, range, part, presses));
    }
    if (names_) {
      label(strip, part, range.from, "");
      for (std::size_t i = 0; i < presses.size(); ++i)
        label(strip, part, presses[i].at, press_number(part, i, presses.size()));
      label(strip, part, range.to, "");
    }
    last_border_ = {next_face(), 0, part.ruling_borders[1]};
    sheet_.faces.push_back(std::move(face));
  }

  /// Names both ends of a ruling, where they are not the last ones that have been named.
  void label(const Strip& strip, const Strip::Part& part, double at, const std::string& press) {
    const std::array<Vec3, 2> ends = strip.ruling(at);
    const std::array<std::string, 2> names = names_->add(ends, press);
    for (std::size_t side = 0; side < 2; ++side) {
      if (names[side] == last_named_[side]) continue;
      last_named_[side] = names[side];
      sheet_.labels.push_back({next_face(), uv_of(part, at, ends[side]), names[side]});
    }
  }

  /// Of a line of the bend that was added last; lines are numbered with u growing.
  std::string press_number(const Strip::Part& part, std::size_t line, std::size_t lines) const {
    const std::string bend = fmt::format("B{}", sheet_.bends.size());
    return lines == 1 ? bend
                      : fmt::format("{}.{}", bend, part.u1 < part.u0 ? lines - line : line + 1);
  }

  /// Of a point on the ruling `at`.
  static Vec2 uv_of(const Strip::Part& part, double at, const Vec3& p) {
    if (const auto* plane = std::get_if<Frame>(&part.face.surface)) return plane->local2(p);
    const auto& surface = std::get<Developable>(part.face.surface);
    const double u = part.u(at);
    return {u, ruling_on(surface, u).dot(p - point_on(surface, {u, 0.0}))};
  }

  Bend bend_of(const Strip& strip, const StripPart& range, const Strip::Part& part,
               const std::vector<Strip::Press>& presses) const {
    Bend bend;
    bend.kind = strip.bend_kind();
    bend.faces = {next_face()};
    bend.angle = Angle::radians(strip.turned(range.from, range.to));
    bend.inside_radius = std::max(
        0.0, strip.smallest_radii(range.from, range.to).middle - spec_.k_factor * spec_.thickness);
    for (const Strip::Press& press : presses)
      bend.press_lines.push_back({part.u(press.at), Angle::radians(press.turn)});
    if (part.u1 < part.u0) std::reverse(bend.press_lines.begin(), bend.press_lines.end());
    return bend;
  }

  /// Smooth, or folded sharply.
  void join(const StripPart& before, const StripPart& after, const Strip::Part& part) {
    const Vec3 a = ring_.strip(before.strip).normal(before.to),
               b = ring_.strip(after.strip).normal(after.from);
    Joint joint{last_border_, {next_face(), 0, part.ruling_borders[0]}, std::nullopt};
    constexpr double kSmooth = 1e-7;  // sine; planes and what they touch agree to rounding
    if (const double sine = a.cross(b).norm(); sine > kSmooth) {
      joint.sharp = static_cast<BendId>(sheet_.bends.size());
      Bend fold;
      fold.kind = BendKind::sharp;
      fold.angle = Angle::radians(std::atan2(sine, a.dot(b)));
      sheet_.bends.push_back(std::move(fold));
    }
    sheet_.joints.push_back(joint);
  }

  void number_edges() {
    int edge = 0;
    for (Face& face : sheet_.faces)
      for (Border& border : face.loops.front())
        border.edge = ++edge;
    for (const Joint& joint : sheet_.joints)
      border(joint.b).edge = border(joint.a).edge;
  }
  Border& border(const BorderRef& ref) { return sheet_[ref]; }

  const Ring& ring_;
  const TransitionSpec& spec_;
  const TipCuts* cuts_;
  RulingNames* names_;
  std::array<std::string, 2> last_named_;
  Sheet sheet_;
  BorderRef last_border_;
};

/// The ring and what each piece is made of.
struct Division {
  Ring ring;
  std::vector<std::vector<StripPart>> pieces;
  double size = 0.0;
};

Result<Division> divided(const TransitionSpec& spec, const TransitionOptions& options) {
  if (auto sound = check_numbers(spec); !sound) return tl::unexpected(sound.error());
  if (auto sound = check_frame(spec.from.frame, "/from/frame"); !sound)
    return tl::unexpected(sound.error());
  if (auto sound = check_frame(spec.to.frame, "/to/frame"); !sound)
    return tl::unexpected(sound.error());
  Division division;
  auto ring = ring_of(spec, options, division.size);
  if (!ring) return tl::unexpected(ring.error());
  if (auto wide = check_radii(*ring, spec); !wide) return tl::unexpected(wide.error());
  auto cuts = cuts_of(*ring, spec.seam, spec.pieces);
  if (!cuts) return tl::unexpected(cuts.error());
  if (ring->count() == 1) {
    const double moved = cuts->front().at;
    ring = begun_at(*ring, moved, options.tolerance * division.size);
    for (Cut& cut : *cuts)
      cut.at -= moved;
  }
  for (std::size_t i = 0; i < cuts->size(); ++i)
    division.pieces.push_back(parts_between(*ring, (*cuts)[i], (*cuts)[(i + 1) % cuts->size()]));
  if (auto pressed = check_presses(*ring, division.pieces, spec.pressing); !pressed)
    return tl::unexpected(pressed.error());
  division.ring = std::move(*ring);
  return division;
}

}  // namespace

Result<Transition> make_transition(const TransitionSpec& spec, const TransitionOptions& options,
                                   const Progress& progress) {
  if (!(options.mesh_chord > 0.0))
    return fail(
        ErrorCode::bad_option,
        fmt::format("The chord of a mesh is {} mm; it must be positive.", options.mesh_chord));
  const auto division = divided(spec, options);
  if (!division) return tl::unexpected(division.error());
  if (progress.should_stop()) return fail(ErrorCode::cancelled, "The transition was cancelled.");
  const Ring& ring = division->ring;
  Transition transition;
  for (const Strip& strip : ring.strips) {
    transition.patches.push_back(
        {strip.kind(),
         strip.area(0.0, 1.0),
         {strip.border_length(0, 0.0, 1.0), strip.border_length(1, 0.0, 1.0)},
         Angle::radians(strip.turn(0.0, 1.0))});
    transition.area += transition.patches.back().area;
    for (std::size_t side = 0; side < 2; ++side)
      transition.perimeters[side] += transition.patches.back().border[side];
  }
  constexpr double kSamePoint = 1e-7;  // share of the extent: the hull finds places to some 1e-9
  RulingNames names(*ring.hull, kSamePoint * division->size);
  for (const auto& parts : division->pieces) {
    transition.pieces.push_back(PieceMaker(ring, spec, nullptr, &names).run(parts));
    ++names.piece;
  }
  transition.true_lengths = std::move(names.lengths);
  transition.mesh = surface_mesh(ring, options.mesh_chord);
  return transition;
}

Result<std::vector<FoldedPiece>> folded_pieces(const TransitionSpec& spec,
                                               const TransitionOptions& options) {
  auto division = divided(spec, options);
  if (!division) return tl::unexpected(division.error());
  const Ring& ring = division->ring;
  const double open = division->pieces.size() == 1 ? open_seam(ring, division->pieces.front())
                                                   : 0.0;
  const TipCuts tips(ring, division->pieces, spec, division->size);
  std::vector<FoldedPiece> pieces;
  for (const auto& parts : division->pieces) {
    FoldedPiece& piece = pieces.emplace_back();
    piece.cut_area = open;
    for (const StripPart& part : parts) {
      const Strip& strip = ring.strip(part.strip);
      if (auto room = tips.leave_room(strip, part.from, part.to); !room)
        return tl::unexpected(room.error());
      piece.cut_area += strip.tip_area(part.from, part.to, tips.of(strip, part.from, part.to));
    }
    double whole = 0.0;
    for (const StripPart& part : parts)
      whole += ring.strip(part.strip).area(part.from, part.to);
    constexpr double kMostCut = 0.1;
    if (piece.cut_area > kMostCut * whole)
      return fail(ErrorCode::radius_too_small,
                  fmt::format("a sheet of {:.4g} mm is too thick to be folded there: corners in "
                              "which bends meet would have to be cut until {:.0f} % "
                              "of it are gone",
                              spec.thickness, 100.0 * piece.cut_area / whole),
                  "/thickness");
    piece.sheet = PieceMaker(ring, spec, &tips, nullptr).run(parts);
  }
  return pieces;
}

}  // namespace planish
