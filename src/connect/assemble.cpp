#include "assemble.hpp"

#include "general_fit.hpp"
#include "plate_outline.hpp"

#include <planish/base/assert.hpp>

#include <algorithm>
#include <cmath>

namespace planish::connect_detail {
namespace {

// Pieces of a ruling shorter than this share of the bend's length are none.
constexpr double kNoPiece = 1e-9;

struct TaggedCurve {
  Curve2 curve;
  int side = -1;  // joint with the plate on that side
};

Curve2 shifted(const Curve2& curve, double v) {
  Isometry2 motion = Isometry2::Identity();
  motion.translation() = Vec2(0.0, v);
  return transformed(curve, motion);
}

// Length on the skin by chords in space, extrapolated: it does not know of any development. A
// ruling is its own chord.
double length_in_space(const Developable& surface, const Curve2& uv) {
  const auto* segment = std::get_if<Segment>(&uv);
  if (segment && segment->a.x() == segment->b.x())
    return (point_on(surface, segment->b) - point_on(surface, segment->a)).norm();
  const auto* spline = std::get_if<CubicSpline>(&uv);
  const int chords = std::max(64, spline ? 16 * static_cast<int>(spline->poles.size() / 3) : 0);
  std::vector<Vec3> points;
  for (int i = 0; i <= chords; ++i)
    points.push_back(point_on(surface, point_at(uv, static_cast<double>(i) / chords)));
  const auto length = [&](std::size_t step) {
    double sum = 0.0;
    for (std::size_t i = step; i < points.size(); i += step)
      sum += (points[i] - points[i - step]).norm();
    return sum;
  };
  const double a = length(4), b = length(2), c = length(1);
  const double ab = b + (b - a) / 3.0, bc = c + (c - b) / 3.0;
  return bc + (bc - ab) / 15.0;
}

class Assembler {
 public:
  explicit Assembler(const Parts& parts) : parts_(parts) {}

  Result<Assembled> run() {
    made_.sheet.thickness = parts_.thickness;
    orient();
    for (std::size_t p = 0; p < parts_.plates.size(); ++p)
      if (auto added = add_plate(static_cast<int>(p)); !added) return tl::unexpected(added.error());
    for (std::size_t b = 0; b < parts_.fits.size(); ++b)
      add_bend(static_cast<int>(b));
    number_edges();
    made_.root = parts_.plates.empty() ? FaceId{0} : made_.plate_faces[parts_.root];
    return std::move(made_);
  }

 private:
  int plate_of(int bend, int side) const {
    const auto& plates = parts_.fits[bend].report.plates;
    return side < static_cast<int>(plates.size()) ? plates[side] : -1;
  }

  // +1 where the bend's normal at a side is the plate's own, −1 where it is the opposite.
  double alignment(int bend, int side) const {
    const BendSurface& surface = parts_.fits[bend].surface;
    const Vec3 normal = normal_on(surface.mid, surface.azimuth(side));
    return normal.dot(parts_.plates[plate_of(bend, side)].frame.z) > 0.0 ? 1.0 : -1.0;
  }

  // Which of its two sides each plate shows on the reference skin, from the root on.
  void orient() {
    plate_sign_.assign(parts_.plates.size(), 0.0);
    bend_sense_.assign(parts_.fits.size(), 0);
    std::vector<int> open;
    if (!parts_.plates.empty()) {
      plate_sign_[parts_.root] = 1.0;
      open.push_back(parts_.root);
    }
    while (!open.empty()) {
      const int plate = open.back();
      open.pop_back();
      for (std::size_t b = 0; b < parts_.fits.size(); ++b)
        if (bend_sense_[b] == 0) follow(static_cast<int>(b), plate, open);
    }
    for (int& sense : bend_sense_)
      if (sense == 0) sense = 1;  // a section of its own
  }

  void follow(int bend, int plate, std::vector<int>& open) {
    for (int side = 0; side < 2; ++side) {
      if (plate_of(bend, side) != plate) continue;
      const double sense = plate_sign_[plate] * alignment(bend, side);
      bend_sense_[bend] = sense > 0.0 ? 1 : -1;
      const int other = plate_of(bend, 1 - side);
      if (other < 0) return;
      plate_sign_[other] = sense * alignment(bend, 1 - side);
      open.push_back(other);
      return;
    }
  }

  // Frame of a plate's face: z is the outward normal of the reference skin.
  Frame skin_frame(int plate) const {
    Frame frame = parts_.plates[plate].frame;
    const double sign = plate_sign_[plate];
    frame.y *= sign;
    frame.z *= sign;
    frame.origin += 0.5 * parts_.thickness * frame.z;
    return frame;
  }

  Result<void> add_plate(int plate) {
    std::vector<BendOnPlate> bends;
    for (std::size_t b = 0; b < parts_.fits.size(); ++b)
      for (int side = 0; side < 2; ++side)
        if (plate_of(static_cast<int>(b), side) == plate)
          bends.push_back({static_cast<int>(b), side, &parts_.fits[b]});
    const PlacedPlate& placed = parts_.plates[plate];
    auto outline = extended_outline(placed, std::move(bends), parts_.ids[plate]);
    if (!outline) return tl::unexpected(outline.error());

    const auto id = static_cast<FlangeId>(made_.sheet.flanges.size());
    const auto face_id = static_cast<FaceId>(made_.sheet.faces.size());
    Face face;
    face.surface = skin_frame(plate);
    face.part_of = id;
    face.loops.push_back(border_loop(outline->pieces, plate, face_id));
    for (const auto& hole : placed.holes) {
      std::vector<ExtendedOutline::Piece> pieces;
      for (std::size_t i = 0; i < hole.size(); ++i)
        pieces.push_back({hole[i], hole[(i + 1) % hole.size()], -1});
      face.loops.push_back(border_loop(std::move(pieces), plate, face_id));
    }
    made_.sheet.faces.push_back(std::move(face));
    made_.sheet.flanges.push_back({{face_id}});
    made_.plate_faces.push_back(face_id);
    return {};
  }

  BorderLoop border_loop(std::vector<ExtendedOutline::Piece> pieces, int plate, FaceId face) {
    const double sign = plate_sign_[plate];
    if (sign < 0.0) {
      std::reverse(pieces.begin(), pieces.end());
      for (auto& piece : pieces)
        std::swap(piece.a, piece.b);
    }
    BorderLoop loop;
    for (const auto& piece : pieces) {
      if (piece.bend >= 0)
        joints_.push_back({piece.bend, plate, {face, 0, static_cast<int>(loop.size())}});
      const Segment segment{{piece.a.x(), sign * piece.a.y()}, {piece.b.x(), sign * piece.b.y()}};
      loop.push_back({.curve = segment, .edge_length = (segment.b - segment.a).norm()});
    }
    return loop;
  }

  // The ruling at a side from lower to higher v, the joint in the middle.
  std::vector<TaggedCurve> ruling(int bend, int side) const {
    const BendFit& fit = parts_.fits[bend];
    const auto i = static_cast<std::size_t>(side);
    const double u = fit.surface.azimuth(side), low = fit.boundaries.low.v[i],
                 high = fit.boundaries.high.v[i];
    const int plate = plate_of(bend, side);
    if (plate < 0) return {TaggedCurve{Segment{{u, low}, {u, high}}}};
    JointRange joint = joint_range(fit, side, parts_.plates[plate]);
    const double none = kNoPiece * (high - low);
    if (joint.low - low <= none) joint.low = low;
    if (high - joint.high <= none) joint.high = high;
    std::vector<TaggedCurve> pieces;
    if (joint.low > low) pieces.push_back({Segment{{u, low}, {u, joint.low}}});
    pieces.push_back({Segment{{u, joint.low}, {u, joint.high}}, side});
    if (joint.high < high) pieces.push_back({Segment{{u, joint.high}, {u, high}}});
    return pieces;
  }

  static void append_reversed(std::vector<TaggedCurve>& loop, std::vector<TaggedCurve> pieces) {
    std::reverse(pieces.begin(), pieces.end());
    for (TaggedCurve& piece : pieces)
      loop.push_back({reversed(piece.curve), piece.side});
  }

  // Counter-clockwise in (u, v).
  std::vector<TaggedCurve> bend_loop(int bend) const {
    const BendFit& fit = parts_.fits[bend];
    std::vector<TaggedCurve> loop{TaggedCurve{fit.boundaries.low.curve}};
    for (TaggedCurve& piece : ruling(bend, 1 - fit.surface.first))
      loop.push_back(std::move(piece));
    loop.push_back({reversed(fit.boundaries.high.curve)});
    append_reversed(loop, ruling(bend, fit.surface.first));
    return loop;
  }

  // The reference skin of a bend, and how much further its v begins than that of the mid-surface.
  std::pair<Developable, double> skin(int bend) const {
    const BendSurface& surface = parts_.fits[bend].surface;
    const double offset = 0.5 * parts_.thickness * bend_sense_[bend];
    if (const auto* cylinder = std::get_if<Cylinder>(&surface.mid))
      return {Cylinder{cylinder->frame, cylinder->radius + offset}, 0.0};
    if (surface.kind == BendKind::general) return {offset_surface(surface, offset), 0.0};
    Cone cone = std::get<Cone>(surface.mid);
    cone.frame.origin -= offset / std::sin(cone.half_angle) * cone.frame.z;
    return {cone, offset / std::tan(cone.half_angle)};
  }

  void add_bend(int bend) {
    const BendFit& fit = parts_.fits[bend];
    const int sense = bend_sense_[bend];
    const auto id = static_cast<BendId>(made_.sheet.bends.size());
    const auto face_id = static_cast<FaceId>(made_.sheet.faces.size());
    const auto [surface, shift] = skin(bend);
    Face face;
    face.surface = surface;
    face.sense = sense;
    face.part_of = id;
    std::vector<TaggedCurve> loop = bend_loop(bend);
    if (sense < 0) {
      std::vector<TaggedCurve> turned;
      append_reversed(turned, std::move(loop));
      loop = std::move(turned);
    }
    BorderLoop borders;
    for (const TaggedCurve& piece : loop) {
      const Curve2 curve = shifted(piece.curve, shift);
      if (piece.side >= 0)
        join(bend, plate_of(bend, piece.side), {face_id, 0, static_cast<int>(borders.size())});
      borders.push_back({.curve = curve, .edge_length = length_in_space(surface, curve)});
    }
    face.loops.push_back(std::move(borders));
    made_.sheet.faces.push_back(std::move(face));
    made_.sheet.bends.push_back(
        {fit.report.kind, {face_id}, fit.report.angle, fit.report.inside_radius, sense < 0, {}});
    made_.bends.push_back(id);
  }

  void join(int bend, int plate, const BorderRef& border) {
    const auto joint = std::find_if(joints_.begin(), joints_.end(), [&](const PlateJoint& j) {
      return j.bend == bend && j.plate == plate;
    });
    PLANISH_ASSERT(joint != joints_.end());
    made_.sheet.joints.push_back({joint->border, border, std::nullopt});
  }

  void number_edges() {
    int edge = 0;
    for (Face& face : made_.sheet.faces)
      for (BorderLoop& loop : face.loops)
        for (Border& border : loop)
          border.edge = ++edge;
    const auto border = [&](const BorderRef& ref) -> Border& { return made_.sheet[ref]; };
    for (const Joint& joint : made_.sheet.joints)
      border(joint.b).edge = border(joint.a).edge;
  }

  struct PlateJoint {
    int bend = 0, plate = 0;
    BorderRef border;
  };

  const Parts& parts_;
  Assembled made_;
  std::vector<double> plate_sign_;
  std::vector<int> bend_sense_;
  std::vector<PlateJoint> joints_;
};

}  // namespace

Result<Assembled> assembled(const Parts& parts) { return Assembler(parts).run(); }

}  // namespace planish::connect_detail
