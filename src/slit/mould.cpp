#include "mould_body.hpp"
#include "mould_clear.hpp"
#include "mould_room.hpp"
#include "mould_strips.hpp"
#include "overbent_mould.hpp"
#include "refusals.hpp"
#include "rib_solid.hpp"

#include <planish/geometry/mesh_volume.hpp>
#include <planish/geometry/region.hpp>
#include <planish/slit/mould.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>

// A rib under each strip (math.md#mould, docs/decisions/0003). A facet is parallel to its quad,
// half the thickness away, and neighbouring facets meet in a line below their ridge, so the sheet
// lies on all of them. Quads too steep for the direction in which the sheet is lifted off stay
// bare, and ribs are interrupted there. Where strips lie over each other the upper one's rib makes
// room; directions that lean are tried until no strip hangs free for want of a rib.

namespace planish {

using namespace slit_detail;

namespace {

/// Share of the width that an inset takes on each side at most, if none is given or others took
/// their share.
constexpr double kMostInset = 0.5 * (1.0 - kNarrowestRib);

struct Setting {
  Vec3 up = Vec3::UnitY();
  double sign = -1.0;       ///< of the sheet's normal towards the mould
  double inset = 0.0;       ///< mm…
  double most_share = 0.5;  ///< …and at most this share of the width, unless given
  double offset = 0.0;      ///< half the thickness
  double least_lean = 0.0;
  MouldForm form = MouldForm::ribs;
};

std::string quad_of(int strip, int quad) {
  return "strip " + std::to_string(strip) + ", quad " + std::to_string(quad);
}

MouldSide ground_side(const FoldedSlitSheet& folded) {
  double up = 0.0;  // the front's area as the ground sees it
  for (const FoldedStrip& strip : folded.strips)
    for (std::size_t i = 0; i < strip.quads.size(); ++i) {
      const auto &near = strip.ridges[i].folded, &far = strip.ridges[i + 1].folded;
      up += (far[1] - near[0]).cross(near[1] - far[0]).y();
    }
  return up < 0.0 ? MouldSide::front : MouldSide::back;
}

tl::unexpected<Error> bad_mould(const char* name, const Quantity& value, const char* range,
                                const char* key) {
  return fail(refuse::bad_slit_option, {{"name", name},
                                        {"value", value.value, value.unit},
                                        {"range", range},
                                        {"field", place::pointer(key)}});
}

Result<Setting> setting_of(const FoldedSlitSheet& folded, const MouldOptions& options) {
  Setting setting;
  const MouldSide ground = ground_side(folded);
  setting.sign = (options.side == MouldSide::ground ? ground : options.side) == MouldSide::back
                     ? -1.0
                     : 1.0;
  if (options.up && !(options.up->allFinite() && options.up->norm() > 0.0))
    return fail(refuse::no_way_up, {{"field", place::pointer("/mould/up")}});
  setting.up = options.up ? Vec3(options.up->normalized())
               : options.side == MouldSide::ground || options.side == ground ? Vec3(Vec3::UnitY())
                                                                             : Vec3(-Vec3::UnitY());
  setting.inset = options.inset.value_or(folded.thickness);
  if (!options.inset) setting.most_share = kMostInset;
  if (!(setting.inset >= 0.0) || !std::isfinite(setting.inset))
    return bad_mould("The mould's inset", {setting.inset, unit::mm}, "0 or more", "/mould/inset");
  if (!(options.base > 0.0) || !std::isfinite(options.base))
    return bad_mould("The depth of the mould's base", {options.base, unit::mm}, "a value above 0",
                     "/mould/base");
  const double draft = options.draft.radians();
  if (!(draft > 0.0) || !(draft < 1.5))
    return bad_mould("The mould's draft", {options.draft.degrees(), unit::degrees},
                     "an angle above 0° and below 86°", "/mould/draft");
  setting.offset = 0.5 * folded.thickness;
  setting.least_lean = std::sin(draft);
  setting.form = options.form;
  return setting;
}

double area_of(const WholeStrip& strip, int quad) {
  const auto &near = strip.ridges[quad], &far = strip.ridges[quad + 1];
  return 0.5 * (far[1] - near[0]).cross(far[0] - near[1]).norm();
}

bool leans_up(const Vec3& towards_mould, const Setting& setting) {
  return -towards_mould.dot(setting.up) >= setting.least_lean;
}

/// From a ridge to the working surface of a rib. Where the rib ends beside a bare quad that folds
/// towards the mould, its end stands back to the mitre with that one, or it would press into it.
Vec3 step_to_surface(const WholeStrip& strip, int first, int last, int at, double offset) {
  const auto normals = std::span(strip.towards_mould)
                           .subspan(static_cast<std::size_t>(first), last - first + 1);
  const Vec3 own = mitre(normals, at - first), both = mitre(strip.towards_mould, at);
  if (at != first && at != last + 1) return own;
  const auto middle = [&](int ridge) -> Vec3 {
    return 0.5 * (strip.ridges[ridge][0] + strip.ridges[ridge][1]);
  };
  const Vec3 way = middle(at == first ? at + 1 : at - 1) - middle(at);
  const double back = (both - own).dot(way);
  return back > 0.0 && offset * back < 0.5 * way.squaredNorm() ? both : own;
}

/// The ridge `at` of a rib, on its working surface.
Result<std::array<Vec3, 2>> working_ridge(const WholeStrip& strip, int first, int last, int at,
                                          const Setting& setting, int number) {
  const auto& [left, right] = strip.ridges[at];
  const Vec3 step = step_to_surface(strip, first, last, at, setting.offset);
  const std::array<double, 2> free = left_at(strip, first, last, at);
  const double rest = 1.0 - free[0] - free[1],
               most = rest < 1.0 ? kMostInset * rest : setting.most_share,
               share = std::min(setting.inset / (right - left).norm(), most);
  if (!(share < 0.5))
    return fail(refuse::inset_takes_all,
                {{"inset", setting.inset, unit::mm},
                 {"strip", place::at(place::strip(number), Vec3(0.5 * (left + right)))},
                 {"length", (right - left).norm(), unit::mm},
                 {"field", place::pointer("/mould/inset")}});
  return std::array<Vec3, 2>{
      left + std::max(share, free[0]) * (right - left) + setting.offset * step,
      right + std::max(share, free[1]) * (left - right) + setting.offset * step};
}

/// The facets under the quads `first` to `last` of a strip.
Result<MouldRib> rib_under(const WholeStrip& strip, int first, int last, const Setting& setting,
                           int number) {
  MouldRib rib{number, first, {}, {}, {}};
  std::array<Vec3, 2> near{};
  for (int at = first; at <= last + 1; ++at) {
    const auto far = working_ridge(strip, first, last, at, setting, number);
    if (!far) return pass_on(far);
    if (at > first) {
      const auto& from = strip.ridges[at - 1];
      const auto& to = strip.ridges[at];
      for (std::size_t side = 0; side < 2; ++side)
        if (!(((*far)[side] - near[side]).dot(to[side] - from[side]) > 0.0))
          return fail(refuse::folded_too_tightly,
                      {{"strip", place::at(place::strip(number), to[side])},
                       {"ridge", place::ridge(strip.first + at - 1)},
                       {"ridge", place::ridge(strip.first + at)}},
                      quad_of(number, strip.first + at - 1));
      rib.facets.push_back({near[0], (*far)[0], (*far)[1], near[1]});
    }
    near = *far;
  }
  return rib;
}

/// Ribs under one strip, and the quads that they leave bare.
Result<void> add_ribs(const WholeStrip& strip, int number, const Setting& setting,
                      const WallSetting& walls, Mould& mould) {
  const int count = static_cast<int>(strip.towards_mould.size());
  const auto carried = [&](int quad) {
    return has_rib(strip, quad) && leans_up(strip.towards_mould[quad], setting) &&
           !is_over(mould.walls, strip, quad, walls);
  };
  for (int quad = 0; quad < count;) {
    if (!carried(quad)) {
      mould.bare.push_back({number, strip.first + quad++});
      continue;
    }
    int last = quad;
    while (last + 1 < count && carried(last + 1))
      ++last;
    auto rib = rib_under(strip, quad, last, setting, number);
    if (!rib) return pass_on(rib);
    rib->first_quad = strip.first + quad;
    mould.ribs.push_back(std::move(*rib));
    quad = last + 1;
  }
  return {};
}

/// z along `up`, at a height; x along the strips of the chair, if possible.
Frame base_frame(double height, const Vec3& up) {
  const Vec3 hint = std::abs(up.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ();
  return frame_from_axes(height * up, up, hint);
}

/// Where the base lies: one body reaches down to the panels' free edges.
double lowest_point(const Mould& mould, const FoldedSlitSheet& folded, const Setting& setting) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const MouldRib& rib : mould.ribs)
    for (const auto& facet : rib.facets)
      for (const Vec3& corner : facet)
        lowest = std::min(lowest, corner.dot(setting.up));
  return setting.form == MouldForm::ribs ? lowest
                                         : std::min(lowest, lowest_of_panels(folded, setting.up));
}

/// The ribs' solids, and those of the walls; as one body, the plate as well.
Result<void> make_solids(Mould& mould, const Setting& setting, double base) {
  for (MouldRib& rib : mould.ribs) {
    rib.footprint = footprint_of(rib, mould.base);
    rib.mesh = closed_mesh(rib, mould.base);
    mould.volume += volume_of(rib.mesh);
  }
  for (MouldWall& wall : mould.walls)
    wall.mesh = wall_mesh(wall, mould.base);
  if (setting.form == MouldForm::ribs) return {};
  constexpr double kPlate = 0.5;  // of the base
  auto body = body_of(mould, kPlate * base, base);
  if (!body) return pass_on(body);
  mould.volume = volume_of(*body);
  mould.body = std::move(*body);
  return {};
}

/// Ribs under all strips as wide as their parts say, on the base below them.
Result<void> stand_ribs(Mould& mould, const FoldedSlitSheet& folded, const Setting& setting,
                        const WallSetting& walls,
                        const std::vector<std::vector<WholeStrip>>& strips) {
  mould.ribs.clear();
  mould.bare.clear();
  for (int i = 0; i < std::ssize(strips); ++i)
    for (const WholeStrip& strip : strips[i])
      if (auto added = add_ribs(strip, i, setting, walls, mould); !added) return added;
  if (mould.ribs.empty()) return fail(refuse::nothing_faces_up);
  mould.base = base_frame(lowest_point(mould, folded, setting) - walls.depth, setting.up);
  for (MouldRib& rib : mould.ribs)
    rib.footprint = footprint_of(rib, mould.base);
  return {};
}

/// How well a mould carries the strips: shares of their area.
struct Carried {
  double share = 0.0;    ///< on ribs, or on strips that are
  double hanging = 0.0;  ///< facing up, but above another strip and not on it
};

/// Error: that of a strip all of which hangs.
Result<Carried> carried_by(const std::vector<std::vector<WholeStrip>>& strips,
                           const std::vector<RibThrough>& cut, const Setting& setting) {
  std::map<std::pair<int, int>, const RibThrough*> nearest;
  for (const RibThrough& one : cut) {
    const RibThrough*& known = nearest[{one.rib.strip, one.rib.quad}];
    if (!known || one.height < known->height) known = &one;
  }
  constexpr double kLiesOn = 4.0;  // times half the thickness; strips that touch are 2 apart
  double carried = 0.0, hanging = 0.0, all = 0.0;
  for (int i = 0; i < std::ssize(strips); ++i) {
    double own = 0.0, own_hanging = 0.0;
    const RibThrough* why = nullptr;
    for (const WholeStrip& strip : strips[i])
      for (int quad = 0; quad < std::ssize(strip.towards_mould); ++quad) {
        const double area = area_of(strip, quad);
        all += area;
        if (!leans_up(strip.towards_mould[quad], setting)) continue;
        const auto cause = nearest.find({i, strip.first + quad});
        const bool hangs = !has_rib(strip, quad) && cause != nearest.end() &&
                           cause->second->height > kLiesOn * setting.offset;
        (hangs ? own_hanging : own) += area;
        if (hangs) why = cause->second;
      }
    if (why && own == 0.0) return refused(*why);
    carried += own, hanging += own_hanging;
  }
  return Carried{carried / all, hanging / all};
}

struct Stood {
  Mould mould;
  Carried carried;
};

/// The mould for one direction.
Result<Stood> upright_mould(const FoldedSlitSheet& folded, const Setting& setting, double base) {
  Mould mould;
  mould.side = setting.sign < 0.0 ? MouldSide::back : MouldSide::front;
  const bool body = setting.form == MouldForm::body;
  const WallSetting upright{base_frame(0.0, setting.up), setting.sign, setting.offset, base};
  if (body) {
    auto walls = walls_of(folded, upright);
    if (!walls) return pass_on(walls);
    mould.walls = std::move(*walls);
  }
  auto strips = mould_strips(folded, setting.sign, body ? &setting.up : nullptr);
  if (auto raised = raise(mould.walls, strips, upright); !raised) return pass_on(raised);
  std::vector<RibThrough> cut;
  constexpr int kRounds = 8;  // narrowed quads may show others, whose ridges they had
  for (int round = 0; round <= kRounds; ++round) {
    if (auto stood = stand_ribs(mould, folded, setting, upright, strips); !stood)
      return cut.empty() ? pass_on(stood) : refused(cut.front());
    const auto through = ribs_through(mould, strips, setting.offset);
    if (through.empty()) break;
    if (round == kRounds) return refused(through.front());
    cut.insert(cut.end(), through.begin(), through.end());
    make_room(strips, through, mould.base, setting.offset, std::max(setting.inset, setting.offset));
  }
  const auto carried = carried_by(strips, cut, setting);
  if (!carried) return pass_on(carried);
  if (auto apart = check_apart(mould); !apart) return pass_on(apart);
  if (auto made = make_solids(mould, setting, base); !made) return pass_on(made);
  return Stood{std::move(mould), *carried};
}

/// Directions to try, leaned away from the first one little by little.
std::vector<Vec3> leaned(const Vec3& up, bool symmetric) {
  constexpr int kSteps = 12;
  const Angle step = Angle::degrees(5);
  std::vector<Vec3> towards{-Vec3::UnitZ(), Vec3::UnitZ()};
  if (!symmetric) towards.insert(towards.end(), {Vec3(-Vec3::UnitX()), Vec3(Vec3::UnitX())});
  std::vector<Vec3> directions{up};
  for (int i = 1; i <= kSteps; ++i)
    for (const Vec3& side : towards)
      directions.emplace_back(std::cos(i * step.radians()) * up +
                              std::sin(i * step.radians()) * side);
  return directions;
}

}  // namespace

Result<Mould> mould_of(const FoldedSlitSheet& folded, const MouldOptions& options) {
  if (auto sound = check(folded); !sound) return pass_on(sound);
  if (options.overbend) return overbent_mould(folded, options);
  const auto given = setting_of(folded, options);
  if (!given) return pass_on(given);
  constexpr double kMayHang = 0.02;  // of the strips: less is no reason to lean
  std::optional<Error> first_error;
  std::optional<Stood> best;
  Setting setting = *given;
  for (const Vec3& up :
       options.up ? std::vector<Vec3>{given->up} : leaned(given->up, folded.symmetric)) {
    setting.up = up;
    auto stood = upright_mould(folded, setting, options.base);
    if (!stood) {
      if (!first_error) first_error = stood.error();
      if (stood.error().code != code::unsupported_shape) break;
      continue;
    }
    if (best && stood->carried.share <= best->carried.share) continue;
    best = std::move(*stood);
    if (best->carried.hanging <= kMayHang) break;
  }
  if (best) return std::move(best->mould);
  return tl::unexpected(*first_error);
}

Mesh mesh_of(const Mould& mould) {
  if (mould.body) return *mould.body;
  Mesh mesh;
  for (const MouldRib& rib : mould.ribs) {
    const int first = static_cast<int>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), rib.mesh.points.begin(), rib.mesh.points.end());
    for (const auto& t : rib.mesh.triangles)
      mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return mesh;
}

}  // namespace planish
