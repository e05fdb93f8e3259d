// A mould for strips that spring back. Bent further than wanted, strips no longer meet their panels
// or each other, so they cannot lie on it all at once: each is pressed by itself. So each has the
// mould that it would have alone, and the bases of all are laid into one plane, side by side.
#include "overbent_mould.hpp"

#include "refusals.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/slit/overbend.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace planish::slit_detail {
namespace {

/// A sheet of one strip and the facets at which it begins and ends.
FoldedSlitSheet alone(const FoldedSlitSheet& folded, int strip) {
  FoldedSlitSheet sheet = folded;
  sheet.strips = {folded.strips[strip]};
  for (auto* panel : {&sheet.panel, &sheet.second_panel}) {
    std::erase_if(*panel, [&](const PanelFacet& facet) { return facet.strip != strip; });
    for (PanelFacet& facet : *panel)
      facet.strip = 0;
  }
  return sheet;
}

/// Carries places from one base plane to another, moved within it.
class Carry {
 public:
  Carry(const Frame& from, const Frame& to, const Vec2& by) : from_(from), to_(to), by_(by) {}
  Vec3 operator()(const Vec3& p) const {
    const Vec3 v = p - from_.origin;
    return to_.origin + (from_.x.dot(v) + by_.x()) * to_.x + (from_.y.dot(v) + by_.y()) * to_.y +
           from_.z.dot(v) * to_.z;
  }
  void move(MouldRib& rib) const {
    for (auto& facet : rib.facets)
      for (Vec3& corner : facet)
        corner = (*this)(corner);
    for (Vec2& corner : rib.footprint)
      corner += by_;
    for (Vec3& point : rib.mesh.points)
      point = (*this)(point);
  }

 private:
  const Frame& from_;
  const Frame& to_;
  Vec2 by_;
};

Box2 box_around(const Mould& mould) {
  Box2 box;
  for (const MouldRib& rib : mould.ribs)
    for (const Vec2& corner : rib.footprint)
      box.add(corner);
  return box;
}

}  // namespace

Result<Mould> overbent_mould(const FoldedSlitSheet& folded, const MouldOptions& options) {
  if (options.form == MouldForm::body)
    return fail(refuse::overbend_in_one_body, {{"field", place::pointer("/mould/form")}});
  const auto bent = overbent(folded, *options.overbend);
  if (!bent) return pass_on(bent);
  MouldOptions of_one = options;
  of_one.overbend.reset();
  Mould all;
  double reached = 0.0;
  for (int strip = 0; strip < std::ssize(bent->strips); ++strip) {
    auto mould = mould_of(alone(*bent, strip), of_one);
    if (!mould) return pass_on(mould);
    if (strip == 0) all.base = mould->base, all.side = mould->side;
    const Box2 box = box_around(*mould);
    const Carry carry(mould->base, all.base, Vec2(-box.lo.x(), reached - box.lo.y()));
    for (MouldRib& rib : mould->ribs) {
      carry.move(rib);
      rib.strip = strip;
      all.ribs.push_back(std::move(rib));
    }
    for (const StripQuad& quad : mould->bare)
      all.bare.push_back({strip, quad.quad});
    all.volume += mould->volume;
    reached += box.hi.y() - box.lo.y() + options.base;
  }
  return all;
}

}  // namespace planish::slit_detail
