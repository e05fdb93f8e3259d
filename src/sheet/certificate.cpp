#include "contour.hpp"
#include "set_back.hpp"
#include "unfolding_tree.hpp"

#include <planish/sheet/certificate.hpp>

#include <cmath>

namespace planish {
namespace {

const Face& face_at(const Sheet& sheet, FaceId id) { return sheet.faces[index_of(id)]; }

double middle_u(const Face& face) {
  Box2 box;
  for (const Border& border : face.loops.front())
    box.add(bounds(border.curve));
  return (box.lo.x() + box.hi.x()) / 2;
}

/// The area at K = ½, from contours chained anew with that K.
Result<double> area_at_half(const Sheet& made, FlattenOptions options) {
  const auto moved = needs_setback(made) ? with_setback(made) : Result<Sheet>(made);
  if (!moved) return tl::unexpected(moved.error());
  const Sheet& sheet = *moved;
  options.allowance = ConstantK{0.5, "certificate"};
  options.bend_k.clear();
  const auto tree = grow_unfolding_tree(sheet, options);
  if (!tree) return tl::unexpected(tree.error());
  const auto contours = chain_contours(sheet, *tree, options);
  if (!contours) return tl::unexpected(contours.error());
  double area = signed_area(contours->outer.loop);
  for (const Contour& opening : contours->openings)
    area += signed_area(opening.loop);
  return area;
}

/// Lengths on the reference skin itself: its development must keep them, whatever the K-factor.
void check_lengths(const Sheet& sheet, const FlatPattern& pattern, double tolerance,
                   Certificate& certificate) {
  for (size_t f = 0; f < sheet.faces.size(); ++f) {
    const Face& face = sheet.faces[f];
    const auto* surface = std::get_if<Developable>(&face.surface);
    std::optional<Development> skin;
    if (surface) skin.emplace(*surface, 0.0, middle_u(face));
    for (size_t l = 0; l < face.loops.size(); ++l)
      for (size_t i = 0; i < face.loops[l].size(); ++i) {
        const Border& border = face.loops[l][i];
        if (border.edge < 0 || border.edge_length <= 0.0) continue;
        const double flat = length(skin ? skin->develop(border.curve, tolerance) : border.curve);
        const double error = std::abs(flat - border.edge_length);
        if (error <= certificate.length_error) continue;
        certificate.length_error = error;
        const Loop& image = l == 0 ? pattern.face_outlines[f] : pattern.face_openings[f][l - 1];
        certificate.length_error_at = point_at(image[i], 0.5);
      }
  }
}

/// Folds points of the finished contours back into space.
class Refolder {
 public:
  Refolder(const Sheet& sheet, const FlatPattern& pattern, const EdgeDistance& distance)
      : sheet_(sheet), pattern_(pattern), distance_(distance) {
    for (size_t f = 0; f < sheet.faces.size(); ++f) {
      const auto* surface = std::get_if<Developable>(&sheet.faces[f].surface);
      neutral_.emplace_back();
      if (surface)
        neutral_.back().emplace(*surface, pattern.neutral_offset[f], middle_u(sheet.faces[f]));
      inverse_.push_back(pattern.placement[f].inverse());
    }
  }

  void check(const Contour& contour, Certificate& certificate) const {
    for (size_t i = 0; i < contour.loop.size(); ++i)
      for (const Origin& origin : contour.origins[i]) {
        if (origin.gap) continue;
        for (const double t : {0.0, 0.3, 0.5, 0.8})
          check_point(contour.loop[i], origin, t, certificate);
      }
  }

 private:
  void check_point(const Curve2& final_curve, const Origin& origin, double t,
                   Certificate& certificate) const {
    const Vec2 p = point_at(final_curve, nearest(final_curve, point_at(origin.image, t)).t);
    const Border& border = border_at(sheet_, origin.border);
    if (border.edge < 0) return;
    const double deviation = distance_(border.edge,
                                       folded(origin.border.face, p, border.edge_depth));
    if (!(deviation > certificate.refold_deviation)) return;
    certificate.refold_deviation = deviation;
    certificate.refold_at = p;
  }

  Vec3 folded(FaceId id, const Vec2& p, double depth) const {
    const size_t f = static_cast<size_t>(index_of(id));
    const Face& face = face_at(sheet_, id);
    const Vec2 local = inverse_[f] * p;
    const Vec2 uv = neutral_[f] ? neutral_[f]->fold(local) : local;
    return skin_point(face, uv) - depth * outward_normal(face, uv);
  }

  const Sheet& sheet_;
  const FlatPattern& pattern_;
  const EdgeDistance& distance_;
  std::vector<std::optional<Development>> neutral_;
  std::vector<Isometry2> inverse_;
};

}  // namespace

Result<Certificate> certify(const Sheet& sheet, const FlatPattern& pattern,
                            const EdgeDistance& distance, const FlattenOptions& options) {
  Certificate certificate;
  const auto area = area_at_half(sheet, options);
  if (!area) return tl::unexpected(area.error());
  certificate.flat_area_half = *area;
  certificate.volume_ratio = sheet.volume > 0 ? *area * sheet.thickness / sheet.volume
                                              : std::nan("");
  const double plain = sheet.volume - sheet.forms_volume - sheet.mitres_volume;
  certificate.explained_ratio = sheet.volume > 0 && sheet.forms_measured && plain > 0
                                    ? *area * sheet.thickness / plain
                                    : std::nan("");
  check_lengths(sheet, pattern, options.curve_tolerance, certificate);
  if (!distance) {
    certificate.refold_deviation = std::nan("");
    return certificate;
  }
  const Refolder refolder(sheet, pattern, distance);
  refolder.check(pattern.outer, certificate);
  for (const Contour& opening : pattern.openings)
    refolder.check(opening, certificate);
  return certificate;
}

}  // namespace planish
