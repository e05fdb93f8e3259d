#include "mould_body.hpp"
#include "mould_clear.hpp"
#include "refusals.hpp"
#include "rib_solid.hpp"

#include <planish/geometry/mesh_volume.hpp>
#include <planish/geometry/region.hpp>
#include <planish/slit/mould.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

// A rib under each strip (math.md#mould, docs/decisions/0003). A facet is parallel to its quad,
// half the thickness away, and neighbouring facets meet in a line below their ridge, so the sheet
// lies on all of them. Quads too steep for the direction in which the sheet is lifted off stay
// bare, and ribs are interrupted there. Insets, then directions that lean, are tried until ribs
// stand apart; options that are given are kept.

namespace planish {

using namespace slit_detail;

namespace {

WholeStrip whole_strip(const FoldedStrip& strip, double sign) {
  WholeStrip whole;
  for (const SlitRidge& ridge : strip.ridges)
    whole.ridges.push_back(ridge.folded);
  for (const Frame& quad : strip.quads)
    whole.towards_mould.push_back(sign * quad.z);
  return whole;
}

/// The image of a panel's facet in x = 0, run as it is.
WholeStrip image_of_facet(WholeStrip facet) {
  for (auto& ridge : facet.ridges)
    ridge = {mirrored(ridge[0]), mirrored(ridge[1])};
  for (Vec3& normal : facet.towards_mould)
    normal = mirrored(normal);
  return facet;
}

/// The image in x = 0, run from the symmetry plane to the other panel.
WholeStrip image_of(const WholeStrip& strip) {
  WholeStrip image;
  for (auto ridge = strip.ridges.rbegin(); ridge != strip.ridges.rend(); ++ridge)
    image.ridges.push_back({mirrored((*ridge)[0]), mirrored((*ridge)[1])});
  for (auto normal = strip.towards_mould.rbegin(); normal != strip.towards_mould.rend(); ++normal)
    image.towards_mould.push_back(mirrored(*normal));
  return image;
}

/// Both halves, as one strip where they meet.
std::vector<WholeStrip> whole_strips(const FoldedStrip& strip, const FoldedSlitSheet& folded,
                                     double sign) {
  const WholeStrip half = whole_strip(strip, sign);
  if (!folded.symmetric) return {half};
  WholeStrip image = image_of(half);
  constexpr double kMeets = 1e-6;  // of the length: a strip that reached its end meets this
  const double gap = std::max((half.ridges.back()[0] - image.ridges.front()[0]).norm(),
                              (half.ridges.back()[1] - image.ridges.front()[1]).norm());
  if (gap > kMeets * folded.reach) {
    image.first = static_cast<int>(half.towards_mould.size());
    return {half, image};
  }
  WholeStrip whole = half;
  whole.ridges.insert(whole.ridges.end(), image.ridges.begin() + 1, image.ridges.end());
  whole.towards_mould.insert(whole.towards_mould.end(), image.towards_mould.begin(),
                             image.towards_mould.end());
  return {whole};
}

/// Share of a strip's width left free on each side of the narrowest ribs tried.
constexpr double kNarrowest = 0.375;

struct Setting {
  Vec3 up = Vec3::UnitY();
  double sign = -1.0;        ///< of the sheet's normal towards the mould
  double inset = 0.0;        ///< mm, …
  double inset_share = 0.0;  ///< …at least this share of the strip's width…
  double most_share = 0.5;   ///< …and at most this, unless given
  double offset = 0.0;       ///< half the thickness
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
  if (!options.inset) setting.most_share = kNarrowest;
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

bool leans_up(const Vec3& towards_mould, const Setting& setting) {
  return -towards_mould.dot(setting.up) >= setting.least_lean;
}

/// The ridge `at` of a rib, on its working surface.
Result<std::array<Vec3, 2>> working_ridge(const WholeStrip& strip, int first, int last, int at,
                                          const Setting& setting, int number) {
  const auto& [left, right] = strip.ridges[at];
  const auto normals = std::span(strip.towards_mould)
                           .subspan(static_cast<std::size_t>(first), last - first + 1);
  const Vec3 step = mitre(normals, static_cast<std::size_t>(at - first));
  const double share = std::min(
      std::max(setting.inset / (right - left).norm(), setting.inset_share), setting.most_share);
  if (!(share < 0.5))
    return fail(refuse::inset_takes_all,
                {{"inset", setting.inset, unit::mm},
                 {"strip", place::at(place::strip(number), Vec3(0.5 * (left + right)))},
                 {"length", (right - left).norm(), unit::mm},
                 {"field", place::pointer("/mould/inset")}});
  return std::array<Vec3, 2>{left + share * (right - left) + setting.offset * step,
                             right + share * (left - right) + setting.offset * step};
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
    return leans_up(strip.towards_mould[quad], setting) &&
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

/// The facet of a panel at which a strip ends, as a quad before or behind its own.
std::optional<WholeStrip> facet_below(const std::vector<PanelFacet>& panel, int strip,
                                      const Setting& setting) {
  const auto facet = std::ranges::find(panel, strip, &PanelFacet::strip);
  if (facet == panel.end()) return std::nullopt;
  const Vec3 normal = setting.sign * facet->frame.z;
  if (std::abs(normal.dot(setting.up)) <= kUprightPanel) return std::nullopt;
  const auto at = [&](std::size_t corner) { return facet->frame.point(facet->corners[corner]); };
  return WholeStrip{{{at(0), at(3)}, {at(1), at(2)}}, {normal}, 0};
}

void put_before(WholeStrip& strip, const WholeStrip& facet) {
  strip.ridges.insert(strip.ridges.begin(), facet.ridges.front());
  strip.towards_mould.insert(strip.towards_mould.begin(), facet.towards_mould.front());
  --strip.first;
}

void put_behind(WholeStrip& strip, const WholeStrip& facet) {
  strip.ridges.push_back(facet.ridges.front());
  strip.towards_mould.push_back(facet.towards_mould.front());
}

/// In one body ribs go on under panels that lean.
void add_panels(std::vector<WholeStrip>& parts, const FoldedSlitSheet& folded, int number,
                const Setting& setting) {
  const auto first = facet_below(folded.panel, number, setting),
             second = facet_below(folded.second_panel, number, setting);
  if (second) put_behind(parts.back(), *second);
  if (first && folded.symmetric) put_behind(parts.back(), image_of_facet(*first));
  if (first) put_before(parts.front(), *first);
}

/// Ribs under all strips. `strips`: whole, by strip.
Result<void> add_all_ribs(Mould& mould, const FoldedSlitSheet& folded, const Setting& setting,
                          const WallSetting& walls, std::vector<std::vector<WholeStrip>>& strips) {
  for (std::size_t i = 0; i < folded.strips.size(); ++i) {
    const int number = static_cast<int>(i);
    strips.push_back(whole_strips(folded.strips[i], folded, setting.sign));
    if (setting.form == MouldForm::body) add_panels(strips.back(), folded, number, setting);
    for (const WholeStrip& strip : strips.back())
      if (auto added = add_ribs(strip, number, setting, walls, mould); !added) return added;
  }
  if (!mould.ribs.empty()) return {};
  return fail(refuse::nothing_faces_up);
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

/// The mould for one direction.
Result<Mould> upright_mould(const FoldedSlitSheet& folded, const Setting& setting, double base) {
  Mould mould;
  mould.side = setting.sign < 0.0 ? MouldSide::back : MouldSide::front;
  const WallSetting upright{base_frame(0.0, setting.up), setting.sign, setting.offset, base};
  if (setting.form == MouldForm::body) {
    auto walls = walls_of(folded, upright);
    if (!walls) return pass_on(walls);
    mould.walls = std::move(*walls);
  }
  std::vector<std::vector<WholeStrip>> strips;
  if (auto added = add_all_ribs(mould, folded, setting, upright, strips); !added)
    return pass_on(added);
  if (auto raised = raise(mould.walls, strips, upright); !raised) return pass_on(raised);
  mould.base = base_frame(lowest_point(mould, folded, setting) - base, setting.up);
  for (MouldRib& rib : mould.ribs)
    rib.footprint = footprint_of(rib, mould.base);
  if (auto clear = check_clear(mould, strips, setting.offset); !clear) return pass_on(clear);
  if (auto made = make_solids(mould, setting, base); !made) return pass_on(made);
  return mould;
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

/// Settings to try until the ribs stand apart; given values are kept. Ribs down to half their
/// strips' width come before a leaning mould, and that before ribs of a quarter.
std::vector<Setting> tries(const Setting& first, const FoldedSlitSheet& folded,
                           const MouldOptions& options) {
  const std::vector<Vec3> directions = options.up ? std::vector<Vec3>{first.up}
                                                  : leaned(first.up, folded.symmetric);
  const std::vector<std::vector<double>> shares = options.inset
                                                      ? std::vector<std::vector<double>>{{0.0}}
                                                      : std::vector<std::vector<double>>{
                                                            {0.0, 0.125, 0.25}, {kNarrowest}};
  std::vector<Setting> settings;
  for (const auto& group : shares)
    for (const Vec3& up : directions)
      for (const double share : group) {
        settings.push_back(first);
        settings.back().up = up;
        settings.back().inset_share = share;
      }
  return settings;
}

}  // namespace

Result<Mould> mould_of(const FoldedSlitSheet& folded, const MouldOptions& options) {
  if (auto sound = check(folded); !sound) return pass_on(sound);
  const auto given = setting_of(folded, options);
  if (!given) return pass_on(given);
  std::optional<Error> first_error;
  for (const Setting& setting : tries(*given, folded, options)) {
    auto mould = upright_mould(folded, setting, options.base);
    if (mould) return mould;
    if (!first_error) first_error = mould.error();
    if (mould.error().code != code::unsupported_shape) break;
  }
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
