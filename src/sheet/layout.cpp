// Lays a sheet in the plane (math.md#unfolding-tree): one development for each bend, then a tree of
// joints from the root, which places each face beside its parent. Joints outside the tree are
// measured afterwards: a cycle that does not close within the tolerance is refused
// (math.md#cycles), never spread over its joints.

#include "bend_development.hpp"
#include "placement.hpp"
#include "refusals.hpp"
#include "unplaced.hpp"

#include <planish/base/assert.hpp>
#include <planish/sheet/layout.hpp>
#include <planish/sheet/places.hpp>
#include <planish/sheet/topology.hpp>

#include <algorithm>
#include <cmath>

// A sheet laid flat, once (docs/decisions/0004): bends developed at their neutral surfaces, faces
// placed over a tree of the longest joints (placement.cpp), borders imaged. Every joint is measured
// afterwards, those that the tree did not use too: a cycle that does not close is refused
// (math.md#cycles). A border that shrinks to a point, as at a cone's apex, becomes exactly one.

namespace planish {
namespace {

using namespace sheet_detail;

Result<void> check_options(const Sheet& sheet, const FlattenOptions& options) {
  if (options.root && !sheet.faces.has(*options.root))
    return fail(refuse::root_unknown,
                {{"root", index_of(*options.root) + 1}, {"count", sheet.faces.size()}});
  for (const auto& [bend, k] : options.bend_k)
    if (!sheet.bends.has(bend))
      return fail(refuse::k_for_no_bend,
                  {{"bend", place_of(sheet, bend)}, {"count", sheet.bends.size()}});
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (!positive(options.curve_tolerance) || !positive(options.merge_tolerance) ||
      !positive(options.closure_tolerance))
    return fail(refuse::tolerance_not_positive);
  return {};
}

Loop image_of(const BorderLoop& loop, const std::optional<Development>& development,
              const Isometry2& placement, const FlattenOptions& options) {
  Loop image;
  for (const Border& border : loop) {
    if (!development) {
      image.push_back(transformed(border.curve, placement));
      continue;
    }
    Curve2 curve = transformed(development->develop(border.curve, options.curve_tolerance),
                               placement);
    // A border that shrinks to a point, as at a cone's apex, becomes exactly a point.
    const bool point = bounds(curve).size().norm() <= options.merge_tolerance;
    image.push_back(point ? Curve2(Segment{start_of(curve), end_of(curve)}) : std::move(curve));
  }
  return image;
}

std::vector<Loop> images_of(const Sheet& sheet, FaceId id, const Layout& layout,
                            const FlattenOptions& options) {
  static const std::optional<Development> kPlane;
  const auto* bend = std::get_if<BendId>(&sheet[id].part_of);
  return mapped(sheet[id].loops, [&](const BorderLoop& loop) {
    return image_of(loop, bend ? layout.development[*bend] : kPlane, layout.placement[id], options);
  });
}

Error loop_error(const Sheet& sheet, const Joint& joint, double closure) {
  return error_of(refuse::loop_misses,
                  {{"gap", closure, unit::mm},
                   {"face", face_at(sheet, joint.a)},
                   {"face", face_at(sheet, joint.b)}},
                  between_faces(sheet, joint));
}

/// Measures how far every joint is from closing, and refuses one that does not close.
Result<double> closure_of(const Sheet& sheet, const Layout& layout, double tolerance) {
  double closure = 0.0;
  const Joint* worst = nullptr;
  for (const Joint& joint : sheet.joints) {
    const double off = mismatch(sheet, layout, joint);
    if (off <= closure) continue;
    closure = off;
    worst = &joint;
  }
  if (closure > tolerance) return tl::unexpected(loop_error(sheet, *worst, closure));
  return closure;
}

}  // namespace

const Curve2& Layout::image(const BorderRef& ref) const {
  const std::vector<Loop>& loops = images[ref.face];
  PLANISH_ASSERT(ref.loop >= 0 && ref.loop < std::ssize(loops) && ref.border >= 0 &&
                 ref.border < std::ssize(loops[ref.loop]));
  return loops[ref.loop][ref.border];
}

Region Layout::region(FaceId face) const {
  const std::vector<Loop>& loops = images[face];
  return {loops.front(), {loops.begin() + 1, loops.end()}};
}

Vec2 Layout::develop(const Sheet& sheet, FaceId face, const Vec2& uv) const {
  const auto* bend = std::get_if<BendId>(&sheet[face].part_of);
  return placement[face] * (bend ? development[*bend]->develop(uv) : uv);
}

Vec2 Layout::fold(const Sheet& sheet, FaceId face, const Vec2& p) const {
  const auto* bend = std::get_if<BendId>(&sheet[face].part_of);
  const Vec2 local = placement[face].inverse() * p;
  return bend ? development[*bend]->fold(local) : local;
}

bool Layout::shows_reference(const Sheet& sheet) const {
  return placement[root].linear().determinant() * sheet[root].sense > 0.0;
}

void Layout::move(const Isometry2& motion) {
  for (Isometry2& placed : placement)
    placed = motion * placed;
  for (std::vector<Loop>& loops : images)
    for (Loop& loop : loops)
      loop = transformed(loop, motion);
}

namespace sheet_detail {

FaceId largest_flange_face(const Sheet& sheet) {
  FaceId best{};
  double best_area = -1.0;
  for (const FaceId id : sheet.faces.ids()) {
    if (!std::holds_alternative<FlangeId>(sheet[id].part_of)) continue;
    double area = 0.0;
    for (const BorderLoop& loop : sheet[id].loops)
      for (const Border& border : loop)
        area += green_area(border.curve);
    if (area <= best_area) continue;
    best_area = area;
    best = id;
  }
  return best;
}

std::string between_faces(const Sheet& sheet, const Joint& joint) {
  const auto number = [&](const BorderRef& ref) {
    const auto of_border = sheet[ref].source_face;
    return std::to_string(
        (of_border ? of_border : sheet[ref.face].source_face).value_or(index_of(ref.face)));
  };
  return "between face " + number(joint.a) + " and face " + number(joint.b);
}

Result<Layout> unplaced(const Sheet& sheet, const FlattenOptions& options) {
  if (auto right = check(sheet); !right) return pass_on(right);
  if (auto right = check_options(sheet, options); !right) return pass_on(right);
  auto allowances = allowances_of(sheet, options);
  if (!allowances) return pass_on(allowances);

  Layout layout;
  layout.root = options.root.value_or(largest_flange_face(sheet));
  layout.allowance = std::move(*allowances);
  auto developments = developments_of(sheet, layout.allowance);
  if (!developments) return pass_on(developments);
  layout.development = std::move(*developments);
  layout.neutral_offset = neutral_offsets_of(sheet, layout.allowance);
  return layout;
}

}  // namespace sheet_detail

Result<Layout> lay_out(const Sheet& sheet, const FlattenOptions& options) {
  auto layout = unplaced(sheet, options);
  if (!layout) return layout;
  auto placed = placed_over(longest_first(sheet), sheet, Topology(sheet), *layout);
  if (!placed) return pass_on(placed);
  layout->tree = std::move(placed->tree);
  layout->placement = std::move(placed->placement);
  const auto closure = closure_of(sheet, *layout, options.closure_tolerance);
  if (!closure) return pass_on(closure);
  layout->closure = *closure;
  for (const FaceId id : sheet.faces.ids())
    layout->images.push_back(images_of(sheet, id, *layout, options));
  return layout;
}

}  // namespace planish
