#pragma once

#include "support/sheets.hpp"

#include <array>
#include <numbers>

// Boxes and tubes with sharp corners, closed all around: they lie flat once they are ripped.

namespace planish::test {

/// What a right-angled corner of a `length` holds beyond a bend's arc.
inline double mitre_of(double thickness, double length) {
  return (1.0 - std::numbers::pi / 4) * thickness * thickness * length;
}

namespace folded {

inline BendId corner(SheetBuilder& builder) {
  Bend bend;
  bend.kind = BendKind::sharp;
  bend.angle = Angle::degrees(90);
  bend.reference_inside = true;
  return builder.new_bend(bend);
}

inline void add_mitres(Sheet& sheet) {
  for (Joint& joint : sheet.joints) {
    joint.mitre_volume = mitre_of(sheet.thickness, *sheet[joint.a].edge_length);
    sheet.mitres_volume += joint.mitre_volume;
  }
}

}  // namespace folded

/// Inside sizes; the reference skin is inside. Edges by number: those around the base, in the order
/// of its sides (the first is as long as `length`), and those between walls.
struct FoldedBox {
  Sheet sheet;
  std::array<int, 4> around, upright;
};
inline FoldedBox folded_box(const BoxSize& size) {
  SheetBuilder builder(size.thickness);
  const FaceId base = builder.flange({}, {rectangle(size.length, size.width)});
  std::array<FaceId, 4> walls{};
  for (int i = 0; i < 4; ++i) {
    const Rim rim = builder.crease(builder.rim(base, i), {Angle::degrees(90), BendDirection::up});
    walls[i] = builder.flange_behind(rim, {rectangle(rim.length, size.height)});
  }
  for (int i = 0; i < 4; ++i)  // a wall begins where its side of the base ends
    builder.join({walls[i], 0, 3}, {walls[(i + 1) % 4], 0, 1}, folded::corner(builder));
  FoldedBox box{builder.finish(), {}, {}};
  folded::add_mitres(box.sheet);
  const double t = size.thickness;
  box.sheet.volume = (size.length + 2 * t) * (size.width + 2 * t) * (size.height + t) -
                     size.length * size.width * size.height;
  box.sheet.genus = 0;
  for (int i = 0; i < 4; ++i) {
    box.around[i] = *box.sheet[BorderRef{base, 0, i}].edge;
    box.upright[i] = *box.sheet[BorderRef{walls[i], 0, 3}].edge;
  }
  return box;
}

/// A rectangular tube, inside width × height, the reference skin inside; its last joint closes it.
inline Sheet folded_tube(double width, double height, double length, double thickness) {
  SheetBuilder builder(thickness);
  const Crease up{Angle::degrees(90), BendDirection::up};
  const FaceId first = builder.flange({}, {rectangle(width, length)});
  FaceId face = first;
  int side = 1;
  for (const double next : {height, width, height}) {
    const Rim rim = builder.crease(builder.rim(face, side), up);
    face = builder.flange_behind(rim, {rectangle(length, next)});
    side = 2;
  }
  builder.join({face, 0, 2}, {first, 0, 3}, folded::corner(builder));
  Sheet sheet = builder.finish();
  folded::add_mitres(sheet);
  sheet.volume = ((width + 2 * thickness) * (height + 2 * thickness) - width * height) * length;
  sheet.genus = 1;
  return sheet;
}

}  // namespace planish::test
