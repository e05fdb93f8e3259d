#pragma once

#include "silhouette.hpp"

#include <planish/sheet/builder.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace planish::brep {

/// Maps the solid's faces and edge uses to the sheet.
struct SheetMap {
  std::map<int, FaceId> face_id;                            ///< by face of the solid
  std::map<std::tuple<int, int, bool>, BorderRef> borders;  ///< by face, edge and sense of the use
  std::map<LoopRef, BorderRef> cut_loops;                   ///< the first border of each loop
  std::set<LoopRef> widened;                                ///< cut wider than the skin's outline
  std::map<int, Silhouette> silhouettes;  ///< by face of the solid: loops are taken from it
  /// By tangent opening, whose outline on the reference skin crosses the tangent line: the borders
  /// along the line, of one face and of the other; and where what is cut begins in the flange.
  std::map<int, std::vector<std::vector<BorderRef>>> bridges;
  std::map<int, BorderRef> tangent_cuts;

  /// Whether what is cut along a loop of a skin face is taken from a silhouette.
  bool is_seen(const LoopRef& ref) const {
    const auto found = silhouettes.find(ref.face);
    return found != silhouettes.end() && std::ranges::count(found->second.skin_loops, ref.loop) > 0;
  }
};

/// A feature of a face of the sheet, first met at a face of the solid; without outlines and volume.
FormedFeature feature_of(const char* kind, FormSide side, int solid_face, FaceId face);

/// Adds features that a flat pattern only outlines: formed features and bosses (their borders
/// marked, drawn and not cut), pockets, countersinks (cut to the narrowest section), slanted cuts,
/// chamfered rims; and their contribution to the plain sheet's volume, positive or negative.
void add_features(SheetBuilder& builder, const SheetMap& map, const Recognition& of);

}  // namespace planish::brep
