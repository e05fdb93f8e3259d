#include "assembly.hpp"
#include "body.hpp"
#include "guarded.hpp"
#include "solid_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <planish/brep/step.hpp>

namespace planish {
namespace {

using namespace brep;

/// Borders are fitted this closely, mm: far below what any machine cuts.
constexpr double kBorderTolerance = 1e-5;

/// Skin area as the neutral surface (K = ½) would measure it, so that the two skins compare.
double neutral_area(const SolidModel& model, const std::vector<Outline>& outlines, const Skins& skins, Side side) {
  double sum = 0.0;
  for (size_t f = 0; f < model.faces.size(); ++f) {
    if (skins.side[f] != side) continue;
    double share = 1.0;
    if (const auto* surface = std::get_if<Developable>(&model.faces[f].surface)) {
      double radius = outlines[f].u_scale;
      if (std::holds_alternative<Ruled>(*surface)) radius = 0.0;
      if (radius > 0) share = (radius - model.faces[f].sense * skins.thickness / 2) / radius;
    }
    sum += outlines[f].area * share;
  }
  return sum;
}

int outward_sharp_edges(const SolidModel& model, const Skins& skins, Side side) {
  return static_cast<int>(std::count_if(skins.sharp.begin(), skins.sharp.end(), [&](const SharpEdge& edge) {
    return !edge.concave && skins.side[static_cast<size_t>(model.edges[static_cast<size_t>(edge.edge)].faces[0])] == side;
  }));
}

/// The skin that the pattern is drawn from: the one folded sharply outwards least (its borders need no
/// setting back), then the one with more material (openings and rims are narrower there).
Side reference_side(const SolidModel& model, const std::vector<Outline>& outlines, const Skins& skins) {
  const int first = outward_sharp_edges(model, skins, Side::first);
  const int second = outward_sharp_edges(model, skins, Side::second);
  if (first != second) return first < second ? Side::first : Side::second;
  constexpr double kClearly = 1.0 + 1e-6;  // sampling of outlines must not decide
  return neutral_area(model, outlines, skins, Side::second) >
                 kClearly * neutral_area(model, outlines, skins, Side::first)
             ? Side::second
             : Side::first;
}

/// Takes closed forms (bridges and lances attached at both ends) off both skins: they are stretched,
/// not bent. Large ones stay, so that the loop they make is refused by name.
bool drop_closed_forms(const SolidModel& model, const std::vector<Outline>& outlines, Skins& skins) {
  constexpr double kLargestShare = 0.25;  // of the skin
  bool dropped = false;
  for (const Side side : {Side::first, Side::second}) {
    const Groups groups = group_faces(model, outlines, skins, side);
    const std::vector<int> faces = closed_forms(model, outlines, groups);
    double area = 0.0;
    for (const int f : faces) area += outlines[static_cast<size_t>(f)].area;
    const double whole = side == Side::first ? skins.area_first : skins.area_second;
    if (faces.empty() || area > kLargestShare * whole) continue;
    for (const int f : faces) {
      skins.side[static_cast<size_t>(f)] = Side::none;
      for (const int partner : skins.partners[static_cast<size_t>(f)]) skins.side[static_cast<size_t>(partner)] = Side::none;
    }
    dropped = true;
  }
  return dropped;
}

Result<Recognized> recognize_model(std::shared_ptr<const SolidModel> model, const RecognizeOptions& options) {
  const std::vector<Outline> outlines = outlines_of(*model);
  auto skins = find_skins(*model, outlines, options.thickness_tolerance);
  if (!skins) return tl::unexpected(skins.error());
  drop_closed_forms(*model, outlines, *skins);
  const Rim rim = find_rim(*model, outlines, *skins);
  const Side side = reference_side(*model, outlines, *skins);
  const Groups groups = group_faces(*model, outlines, *skins, side);
  auto sheet = assemble_sheet(*model, outlines, *skins, rim, groups, side, kBorderTolerance);
  if (!sheet) return tl::unexpected(sheet.error());
  Recognized result;
  result.sheet = std::move(*sheet);
  result.distance = [model](int edge, const Vec3& point) {
    return model->edges[static_cast<size_t>(edge)].curve.distance(point);
  };
  return result;
}

}  // namespace

Result<Recognized> recognize(const Body& body, const RecognizeOptions& options) {
  return guarded([&] {
    auto model = std::make_shared<const SolidModel>(read_solid(body.shape().solid, options.surface_tolerance));
    return recognize_model(std::move(model), options);
  }, body.name());
}

}  // namespace planish
