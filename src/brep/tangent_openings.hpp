#pragma once

#include "rim.hpp"

#include <planish/sheet/sheet.hpp>

#include <optional>
#include <vector>

namespace planish::brep {

struct Recognition;

/// Consecutive edges of a loop, from the use `first` on.
struct LoopRun {
  LoopRef loop;
  int first = 0;
  int count = 0;

  bool holds(int use, int of_loop) const { return (use - first + of_loop) % of_loop < count; }
};

/// The outline of an opening on a skin: a loop of a plane; or, over a tangent line, a part of a
/// plane's outline and one of the bend's beside it, which end in each other.
struct SkinOutline {
  LoopRun on_plane;
  std::optional<LoopRun> on_bend;
};

/// An opening of a flange that reaches into the bend beside it, on one skin at least, if only by
/// what is machined round it. What is cut is the narrowest section: a clockwise loop of the flange,
/// beside which the tangent line is whole; or, where that crosses the tangent line too, its parts
/// over the flange and over the bend, as their faces run. If the other skin alone is machined
/// there, those parts are the reference skin's own outline.
struct TangentOpening {
  int part = 0;             ///< of the rim
  SkinOutline here, there;  ///< on the reference skin and on the other one
  Frame plane;              ///< of the flange, on the reference skin
  BorderLoop cut;           ///< in that plane
  BorderLoop cut_of_bend;   ///< in (u, v) of the bend, at any turn; empty: the loop is closed
  BorderLoop cut_seen;      ///< all of it, along the normal of the flange
  bool as_drawn = false;    ///< it is cut along the reference skin's own edges
  bool has_room = true;     ///< at the tangent line it ends within the reference skin's outline

  /// Whether the tangent line goes on beside what is cut, over what is machined on this skin.
  bool leads_over() const { return here.on_bend && !as_drawn; }
};

/// Those of a solid that are machined, on one skin or both. May throw the kernel's exceptions.
std::vector<TangentOpening> tangent_openings(const Recognition& of);

/// The area of what is cut, mm²; over the bend half-way between the skins.
double cut_area(const Recognition& of, const TangentOpening& opening);

/// Outlines as seen along the normal of the flange, clockwise: the reference skin's, the other's.
BorderLoop seen_here(const Recognition& of, const TangentOpening& opening);
BorderLoop seen_there(const Recognition& of, const TangentOpening& opening);

/// How far the other skin lies below the plane, mm.
double depth_of(const Recognition& of, const TangentOpening& opening);

/// What the solid has beyond what is cut, mm³, below 0 where more is machined off: by its faces,
/// and the planes and cylinders that go on over it. Empty where it goes beyond a quarter turn of
/// the bend.
std::optional<double> volume_beyond_cut(const Recognition& of, const TangentOpening& opening);

}  // namespace planish::brep
